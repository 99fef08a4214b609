"""What the compose file's scale profile starts, started by hand: no container engine is needed."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import httpx2
import pytest
from distributed import Client
from sqlalchemy import text

from app.persistence.engine import make_engine
from tests.support.server import Server, free_port
from tests.support.simulate import answer_with

pytestmark = pytest.mark.scale

STUDY = "/studies/emotion-in-walking"


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[str]:
    """A Dask scheduler and two workers; gives the scheduler's address."""
    address = f"tcp://127.0.0.1:{free_port()}"
    dask = [sys.executable, "-m", "dask"]
    port = address.rpartition(":")[2]
    commands = [[*dask, "scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard"]]
    worker = [*dask, "worker", address, "--host", "127.0.0.1", "--nthreads", "1", "--no-dashboard"]
    commands += [[*worker, "--local-directory", str(tmp_path / f"worker-{n}")] for n in (1, 2)]
    processes = []
    try:
        for index, command in enumerate(commands):
            with (tmp_path / f"dask-{index}.log").open("wb") as log:
                processes.append(
                    subprocess.Popen(command, stdout=log, stderr=log, start_new_session=True)
                )
        wait_for_workers(address, 2)
        yield address
    finally:
        for process in processes:
            os.killpg(process.pid, signal.SIGTERM)
        for process in processes:
            process.wait(timeout=30)


def wait_for_workers(address: str, count: int) -> None:
    with Client(address, timeout=60, set_as_default=False) as client:
        client.wait_for_workers(count, timeout=60)


def manner(environment: dict[str, str], *arguments: str) -> str:
    done = subprocess.run(
        [sys.executable, "-m", "app.cli", *arguments],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def get(url: str) -> dict:
    with urllib.request.urlopen(url, timeout=20) as answer:
        return json.load(answer)


def begin(server: Server) -> str:
    """Agree to take part at one server; gives the personal token."""
    with httpx2.Client(base_url=server.url, follow_redirects=False) as browser:
        page = browser.get(STUDY).text
        token = page.split('name="csrf_token" value="')[1].split('"')[0]
        version = page.split('name="consent_version" value="')[1].split('"')[0]
        form = {"csrf_token": token, "agree": "yes", "consent_version": version}
        answer = browser.post(f"{STUDY}/begin", data=form)
    assert answer.status_code == 303, answer.text
    return answer.headers["location"].rpartition("/")[2]


def answer(server: Server, token: str, index: int) -> int:
    """Answer one trial at one server; gives the status."""
    session = get(f"{server.url}/api/v1/sessions/{token}")
    (part,) = session["parts"].values()
    values = {scale["id"]: 1 for scale in part["scales"]}
    body = answer_with(values, index).model_dump(mode="json")
    return httpx2.post(f"{server.url}/api/v1/sessions/{token}/responses", json=body).status_code


def test_two_servers_a_cluster_and_postgresql_work_as_one(
    empty_postgresql: str, cluster: str, tmp_path: Path, motions_dir: Path
) -> None:
    environment = {
        "MANNER_DATABASE_URL": empty_postgresql,
        "MANNER_SCHEDULER": cluster,
        "MANNER_SECRET_KEY": "a key that both servers share " * 2,
        "MANNER_DATA_DIRECTORY": str(tmp_path),
    }
    manner(environment, "prepare")
    walks = sorted(map(str, motions_dir.glob("bandai-namco/walk_*.bvh")))[:6]
    told = manner(environment, "import", "--yes", *walks)
    assert told.count("✓") == 6
    before = tasks_done(cluster)
    assert before >= 6
    manner(environment, "make-set", "foerger")
    assert count(empty_postgresql, "clips WHERE source = 'edited'") == 20
    assert tasks_done(cluster) > before

    folders = [tmp_path / name for name in ("one", "two")]
    servers = [
        Server(folder, environment=environment_of(environment, folder)) for folder in folders
    ]
    try:
        for server in servers:
            server.data_directory.mkdir()
            server.start()
        first = servers[0]
        token = begin(first)
        for index in range(22):
            assert answer(servers[index % 2], token, index) == 201
            if index == 10:
                first.kill()
                first.start()
        for server in servers:
            assert get(f"{server.url}/api/v1/sessions/{token}")["next"] == 22
        assert count(empty_postgresql, "responses") == 22
    finally:
        for server in servers:
            server.stop()


def environment_of(shared: dict[str, str], folder: Path) -> dict[str, str]:
    return {**shared, "MANNER_DATA_DIRECTORY": str(folder)}


def tasks_done(address: str) -> int:
    """Tasks that the cluster's workers have taken on since they started."""

    def log_of(dask_worker: object) -> int:
        return len({entry[0] for entry in dask_worker.state.log if "memory" in entry})

    with Client(address, set_as_default=False) as client:
        return sum(client.run(log_of).values())


def count(database: str, what: str) -> int:
    engine = make_engine(database)
    with engine.connect() as connection:
        counted = connection.execute(text(f"SELECT count(*) FROM {what}")).scalar_one()
    engine.dispose()
    return int(counted)
