"""What an operator can set by ``MANNER_*`` variables; docs/settings.md explains each of them."""

from __future__ import annotations

import secrets
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from typing import Literal

from pydantic import Field, SecretStr, field_validator
from pydantic_settings import BaseSettings, SettingsConfigDict
from sqlalchemy import make_url
from sqlalchemy.exc import ArgumentError

PROJECT = Path(__file__).resolve().parents[1]


class Settings(BaseSettings):
    """The server's settings. Each field is read from ``MANNER_<FIELD>``."""

    model_config = SettingsConfigDict(env_prefix="MANNER_", extra="ignore", frozen=True)

    data_directory: Path = Path("data")
    database_url: str = ""
    database_password_file: Path | None = None
    secret_key: SecretStr | None = None
    secret_key_file: Path | None = None
    public_url: str = "http://127.0.0.1:8000"
    upload_limit: int = Field(default=64_000_000, gt=0)
    request_limit: int = Field(default=1_000_000, gt=0)
    session_hours: float = Field(default=12, gt=0)
    sign_in_attempts: str = "10/15 minutes"
    trusted_proxies: str = "127.0.0.1"
    scheduler: str = ""
    log_format: Literal["auto", "console", "json"] = "auto"
    log_level: Literal["debug", "info", "warning", "error"] = "info"

    @field_validator("public_url")
    @classmethod
    def _without_closing_slash(cls, url: str) -> str:
        if not url.startswith(("http://", "https://")):
            raise ValueError("the public URL must start with http:// or https://")
        return url.rstrip("/")

    @field_validator("sign_in_attempts")
    @classmethod
    def _is_a_rate(cls, rate: str) -> str:
        from limits import parse  # here, since most keep the default

        try:
            parse(rate)
        except ValueError:
            raise ValueError("give a number and a time, such as 10/15 minutes") from None
        return rate

    @field_validator("database_url")
    @classmethod
    def _is_an_address(cls, url: str) -> str:
        try:
            make_url(url or "sqlite://")
        except ArgumentError:  # whose message would repeat the address, password and all
            raise ValueError("give an address such as postgresql://user@host/name") from None
        return url

    @property
    def secure(self) -> bool:
        """Whether participants reach the server by https: cookies then never travel without."""
        return self.public_url.startswith("https://")

    @cached_property
    def database(self) -> str:
        """The SQLAlchemy URL: the given one, or SQLite in the data directory."""
        if not self.database_url:
            return f"sqlite:///{self._made_data_directory() / 'manner.sqlite3'}"
        url = make_url(self.database_url)
        if url.drivername in ("postgresql", "postgres"):  # psycopg 3 is the driver we ship
            url = url.set(drivername="postgresql+psycopg")
        if self.database_password_file:
            url = url.set(password=self.database_password_file.read_text().strip())
        return url.render_as_string(hide_password=False)

    @cached_property
    def signing_key(self) -> str:
        """The key that signs cookies: the given one, or one made once in the data directory."""
        if self.secret_key is not None:
            return _long_enough(self.secret_key.get_secret_value(), "MANNER_SECRET_KEY")
        if self.secret_key_file is not None:
            return _read_key(self.secret_key_file)
        path = self._made_data_directory() / "secret_key"
        if not path.exists():
            _make_key(path)
        return _read_key(path)

    def _made_data_directory(self) -> Path:
        self.data_directory.mkdir(parents=True, exist_ok=True)
        return self.data_directory.resolve()


def _make_key(path: Path) -> None:
    # Written aside and then linked: of two servers that start at once, both read the same key.
    # Drawn by lot, because processes of two containers may have the same number.
    aside = path.with_name(f".{path.name}.{secrets.token_hex(8)}")
    aside.touch(mode=0o600, exist_ok=False)
    aside.write_text(secrets.token_urlsafe(48))
    with suppress(FileExistsError):
        path.hardlink_to(aside)
    aside.unlink()


def _read_key(path: Path) -> str:
    return _long_enough(path.read_text().strip(), str(path))


def _long_enough(key: str, place: str) -> str:
    if len(key) < 32:
        raise ValueError(f"{place} holds no usable key: it needs 32 characters or more.")
    return key
