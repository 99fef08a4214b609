"""The API describes itself wholly."""

from __future__ import annotations

import re

import pytest

from app.main import create_app
from app.settings import PROJECT, Settings

METHODS = {"get", "post", "patch", "put", "delete"}


@pytest.fixture(scope="module")
def document() -> dict:
    settings = Settings(database_url="sqlite://", secret_key="x" * 40)
    return create_app(settings).openapi()


def test_only_the_json_api_is_described(document: dict) -> None:
    assert document["paths"]
    assert all(path.startswith("/api/v1/") for path in document["paths"])


def test_every_operation_has_a_name_of_its_own_and_a_sentence(document: dict) -> None:
    operations = [o for path in document["paths"].values() for m, o in path.items() if m in METHODS]
    names = [operation["operationId"] for operation in operations]
    assert len(set(names)) == len(names)
    assert all(operation["description"] for operation in operations)


def test_every_refusal_has_the_one_shape(document: dict) -> None:
    for path, item in document["paths"].items():
        for method, operation in item.items():
            for status, response in operation["responses"].items():
                if int(status) < 400:
                    continue
                schema = response["content"]["application/json"]["schema"]
                assert schema == {"$ref": "#/components/schemas/ErrorResponse"}, (path, method)


def test_the_error_and_the_clip_come_with_examples(document: dict) -> None:
    schemas = document["components"]["schemas"]
    for name in ("ErrorDetail", "ClipView", "ImportOptions"):
        assert schemas[name]["example"]
        assert set(schemas[name]["example"]) <= set(schemas[name]["properties"])


def test_the_page_about_the_api_names_addresses_that_are_there(document: dict) -> None:
    text = (PROJECT / "docs" / "api.md").read_text()
    named = re.findall(r"`(GET|POST|DELETE) (/api/v1/[a-z/_{}-]*)`", text)
    assert len(named) > 10
    for method, path in named:
        assert method.lower() in document["paths"].get(path, {}), (method, path)
