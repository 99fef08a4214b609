"""Settings: documented, and safe without any."""

from __future__ import annotations

import re
import stat
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from pydantic import ValidationError

from app.settings import PROJECT, Settings


def test_the_documentation_lists_exactly_the_settings_that_exist() -> None:
    text = (PROJECT / "docs" / "settings.md").read_text()
    documented = set(re.findall(r"^\| `(MANNER_\w+)` \|", text, re.MULTILINE))
    assert documented == {f"MANNER_{name.upper()}" for name in Settings.model_fields}


def test_the_documented_defaults_are_the_defaults() -> None:
    text = (PROJECT / "docs" / "settings.md").read_text()
    documented = dict(re.findall(r"^\| `MANNER_(\w+)` \| `([^`]+)` \|", text, re.MULTILINE))
    defaults = {name.upper(): field.default for name, field in Settings.model_fields.items()}
    assert documented
    assert {name: str(defaults[name]) for name in documented} == documented


def test_a_secret_key_is_made_once_and_only_its_owner_reads_it(tmp_path: Path) -> None:
    first = Settings(data_directory=tmp_path / "data").signing_key
    path = tmp_path / "data" / "secret_key"
    assert len(first) >= 48
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert Settings(data_directory=tmp_path / "data").signing_key == first
    assert [file.name for file in (tmp_path / "data").iterdir()] == ["secret_key"]


def test_two_installations_have_unlike_keys(tmp_path: Path) -> None:
    keys = {Settings(data_directory=tmp_path / name).signing_key for name in "ab"}
    assert len(keys) == 2


def test_a_truncated_key_file_stops_the_start(tmp_path: Path) -> None:
    (tmp_path / "secret_key").write_text("short")
    with pytest.raises(ValueError, match="secret_key holds no usable key"):
        _ = Settings(data_directory=tmp_path).signing_key


def test_a_short_key_stops_the_start() -> None:
    with pytest.raises(ValueError, match="MANNER_SECRET_KEY holds no usable key"):
        _ = Settings(secret_key="short").signing_key


def test_servers_that_start_at_once_read_the_same_key(tmp_path: Path) -> None:
    with ThreadPoolExecutor(8) as pool:
        keys = pool.map(lambda _: Settings(data_directory=tmp_path).signing_key, range(64))
        assert len(set(keys)) == 1
    assert [file.name for file in tmp_path.iterdir()] == ["secret_key"]


def test_secrets_come_from_files_and_stay_out_of_the_representation(tmp_path: Path) -> None:
    (tmp_path / "key").write_text("k" * 40 + "\n")
    (tmp_path / "password").write_text("s3cr/t@\n")
    settings = Settings(
        database_url="postgresql://manner@database/manner",
        database_password_file=tmp_path / "password",
        secret_key_file=tmp_path / "key",
    )
    assert settings.signing_key == "k" * 40
    assert settings.database == "postgresql+psycopg://manner:s3cr%2Ft%40@database/manner"
    assert "s3cr" not in repr(settings)
    assert "geheim" not in repr(Settings(secret_key="geheim" * 6))


def test_without_settings_the_database_lies_in_the_data_directory(tmp_path: Path) -> None:
    settings = Settings(data_directory=tmp_path / "new")
    assert settings.database == f"sqlite:///{tmp_path / 'new' / 'manner.sqlite3'}"
    assert (tmp_path / "new").is_dir()


@pytest.mark.parametrize(
    ("url", "secure"), [("https://study.example.org/", True), ("http://127.0.0.1:8000", False)]
)
def test_the_public_address_decides_about_secure_cookies(url: str, secure: bool) -> None:
    settings = Settings(public_url=url)
    assert settings.secure is secure
    assert not settings.public_url.endswith("/")


def test_a_wrong_value_names_the_setting(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MANNER_UPLOAD_LIMIT", "-1")
    with pytest.raises(ValidationError, match="upload_limit"):
        Settings()
