"""A real server is killed in the middle of a job and started again."""

from __future__ import annotations

import json
import os
import signal
import time
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from sqlalchemy import func, select

from app.persistence import researchers
from app.persistence.engine import Database, make_engine
from app.persistence.models import ClipRecord
from app.services import keys, samples
from tests.support.motions import walks
from tests.support.server import Server

PATIENCE = 180  # seconds until the test gives up waiting
CLIPS = 160


@pytest.fixture
def database(database_url: str) -> Iterator[Database]:
    database = Database(make_engine(database_url))
    samples.make(database, walks)
    yield database
    database.engine.dispose()


@pytest.fixture
def server(database_url: str, tmp_path: Path) -> Iterator[Server]:
    folder = tmp_path / "server"
    folder.mkdir()
    server = Server(folder, environment={"MANNER_DATABASE_URL": database_url})
    yield server
    server.stop()


def until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "it never came true"
        time.sleep(0.02)


def children_of(process: int) -> list[int]:
    """The processes that any of its threads has started."""
    listed = Path(f"/proc/{process}/task").glob("*/children")
    return [int(child) for file in listed for child in file.read_text().split()]


def is_alive(process: int) -> bool:
    """Whether it runs; one that has ended may still wait to be taken notice of."""
    try:
        return " Z " not in Path(f"/proc/{process}/stat").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return False


def test_a_killed_server_goes_on_with_its_job_and_leaves_no_process(
    database: Database, server: Server
) -> None:
    with database.writing() as db:
        owner = researchers.add(db, email="rosa@example.org", name="Rosa", password_hash="-")
        key = keys.make(db, owner.id, "test", "write").secret

    def call(path: str, body: object = None) -> dict:
        data = None if body is None else json.dumps(body).encode()
        headers = {"Authorization": f"Bearer {key}", "Content-Type": "application/json"}
        request = urllib.request.Request(server.url + path, data, headers)
        with urllib.request.urlopen(request) as answer:
            return json.load(answer)

    server.start()
    items = [
        {
            "source": walks()[i % 3].clip.content_hash,
            "operations": [{"operation": "tempo@1", "parameters": {"factor": 1 + (i + 1) / 1000}}],
        }
        for i in range(CLIPS)
    ]
    job = f"/api/v1/jobs/{call('/api/v1/clips/batch', {'items': items})['id']}"
    until(lambda: call(job)["done"] > 0)
    children = children_of(server.process.pid)
    assert children
    os.kill(server.process.pid, signal.SIGKILL)  # it alone: nobody tells its processes
    server.process.join()
    until(lambda: not any(is_alive(child) for child in children))

    server.start()
    left = call(job)
    assert left["state"] == "running"
    assert 0 < left["done"] < CLIPS
    until(lambda: call(job)["ended_at"] is not None)
    found = call(job)
    assert (found["state"], found["done"], found["failed"]) == ("done", CLIPS, 0)
    kept = [item["clip"] for item in left["items"]]
    assert all(
        before in (None, after["clip"]) for before, after in zip(kept, found["items"], strict=True)
    )
    with database.reading() as db:
        edited = select(func.count()).where(ClipRecord.source == "edited")
        assert db.scalar(edited) == CLIPS == len({item["clip"] for item in found["items"]})
