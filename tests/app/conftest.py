"""A signed-in researcher's browser, and rows to look at."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

import pytest
from argon2 import PasswordHasher
from httpx2 import Response
from starlette.testclient import TestClient

from app import main
from app.persistence.engine import Database
from app.services import clip_files, rendering, researchers, samples
from motion import Clip
from motion.figure import FigureMesh, build_figure
from tests.support.motions import walks

EMAIL, PASSWORD = "rosa@example.org", "four plain words here"


def csrf_token(client: TestClient, page: str = "/no-webgl") -> str:
    """The token that a page of this browser carries."""
    found = re.search(r'name="csrf-token" content="([^"]+)"', client.get(page).text)
    assert found, f"{page} carries no token"
    return found.group(1)


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Passwords are hashed cheaply, motions computed in place, and a figure built once for all."""
    cheap = PasswordHasher(time_cost=1, memory_cost=8, parallelism=1)
    monkeypatch.setattr(researchers, "_hasher", cheap)
    monkeypatch.setattr(clip_files, "build_figure", built_once)
    monkeypatch.setattr(rendering, "build_figure", built_once)
    monkeypatch.setattr(main, "Workers", InPlace)


class InPlace:
    """Does at once, in the test's own process, what workers do."""

    def __init__(self, **_: object) -> None:
        pass

    def start(self) -> None:
        pass

    def run(self, _: str, function: Callable[..., object], *args: object) -> object:
        return function(*args)

    def close(self) -> None:
        pass


def built_once(clip: Clip) -> FigureMesh:
    key = clip.skeleton.content_hash
    if key not in _figures:
        _figures[key] = build_figure(clip)
    return _figures[key]


_figures: dict[str, FigureMesh] = {}


@pytest.fixture
def database(client: TestClient) -> Database:
    return client.app.state.database


@pytest.fixture
def researcher(database: Database) -> str:
    """A researcher's account; its address."""
    with database.writing() as db:
        link = researchers.make_setup_link(db, "http://testserver")
        token = link.rpartition("/")[2]
        researchers.set_up(db, token, email=EMAIL, name="Rosa", password=PASSWORD)
    return EMAIL


@dataclass
class Researching:
    """Calls the API as a page of a signed-in researcher does."""

    client: TestClient
    headers: dict[str, str]

    def upload(self, name: str, data: bytes, **form: str) -> Response:
        return self.client.post(
            "/api/v1/imports", files={"file": (name, data)}, data=form, headers=self.headers
        )

    def __getattr__(self, method: str) -> Callable[..., Response]:
        call = getattr(self.client, method)
        return lambda path, **more: call(path, headers=self.headers, **more)


@pytest.fixture
def signed_in(client: TestClient, researcher: str) -> Researching:
    form = {"email": researcher, "password": PASSWORD, "csrf_token": csrf_token(client)}
    assert client.post("/research/sign-in", data=form).status_code == 303
    return Researching(client, {"X-CSRF-Token": csrf_token(client, "/library")})


@pytest.fixture
def samples_made(database: Database) -> int:
    """A library of three samples."""
    return samples.make(database, walks)
