"""Processes that compute: the same results, kept warm, started anew, never waited for in vain."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path

import pytest

from app.errors import BusyError, InvalidError
from app.workers import WAITING, Workers


@pytest.fixture
def workers() -> Iterator[Workers]:
    made = Workers(2)
    yield made
    made.close()


def add(a: int, b: int = 0) -> int:
    return a + b


def fault(message: str) -> None:
    raise InvalidError(message, code="known", where={"step": 1}, mend="Mend it.")


def process(wait_for: str = "") -> int:
    """The process's id, once the named file is there."""
    while wait_for and not Path(wait_for).exists():
        time.sleep(0.01)
    return os.getpid()


def die(unless: str = "") -> str:
    """End the process; the second time nothing happens if a file is named."""
    if unless and Path(unless).exists():
        return "lived"
    if unless:
        Path(unless).touch()
    os._exit(1)


def test_a_function_is_computed_in_another_process(workers: Workers) -> None:
    assert workers.run("a", add, 2, b=3) == 5
    assert workers.run("a", process) != os.getpid()


def test_a_clip_comes_back_to_the_process_that_knows_it(workers: Workers) -> None:
    assert len({workers.run("a clip", process) for _ in range(4)}) == 1


def test_an_idle_process_helps_a_busy_one(workers: Workers, tmp_path: Path) -> None:
    go = tmp_path / "go"
    with ThreadPoolExecutor(1) as pool:
        first = pool.submit(workers.run, "a clip", process, str(go))
        while not any(worker.load for worker in workers._workers):
            time.sleep(0.001)
        second = workers.run("a clip", process)
        go.touch()
        assert first.result() != second


def test_what_a_function_raises_reaches_its_caller_whole(workers: Workers) -> None:
    with pytest.raises(InvalidError, match="wrong") as caught:
        workers.run("a", fault, "wrong")
    error = caught.value
    assert (error.code, error.where, error.mend) == ("known", {"step": 1}, "Mend it.")
    assert workers.run("a", add, 1) == 1


def test_work_that_takes_too_long_is_stopped_and_the_next_is_not(tmp_path: Path) -> None:
    workers = Workers(1, seconds=20.0)
    try:
        before = workers.run("a", process)
        workers._workers[0]._seconds = 0.05
        with pytest.raises(InvalidError, match="longer than") as caught:
            workers.run("a", process, str(tmp_path / "never"))
        assert caught.value.code == "takes_too_long"
        workers._workers[0]._seconds = 20.0
        assert workers.run("a", process) != before
    finally:
        workers.close()


def test_work_whose_process_dies_is_done_again_once(workers: Workers, tmp_path: Path) -> None:
    assert workers.run("a", die, str(tmp_path / "died")) == "lived"
    with pytest.raises(BusyError, match="broke off"):
        workers.run("a", die)
    assert workers.run("a", add, 1, 1) == 2


def test_more_work_than_fits_is_refused_at_once(workers: Workers, tmp_path: Path) -> None:
    go = tmp_path / "go"
    with ThreadPoolExecutor(WAITING) as pool:
        waiting = [pool.submit(workers.run, str(n), process, str(go)) for n in range(WAITING)]
        while sum(worker.load for worker in workers._workers) < WAITING:
            time.sleep(0.001)
        with pytest.raises(BusyError):
            workers.run("a", add, 1)
        go.touch()
        assert len({done.result() for done in waiting}) == 2
    assert workers.run("a", add, 1) == 1


def test_all_processes_end_with_the_server(workers: Workers) -> None:
    running = [workers.run(key, process) for key in "abcdef"]
    workers.close()
    for pid in set(running):
        with pytest.raises(ProcessLookupError):
            os.kill(pid, 0)
    with pytest.raises(BusyError, match="shutting down"):
        workers.run("a", add, 1)


def test_closing_does_not_wait_for_what_runs(workers: Workers, tmp_path: Path) -> None:
    outcome: list[str] = []

    def run() -> None:
        with suppress(BusyError):
            workers.run("a", process, str(tmp_path / "never"))
        outcome.append("ended")

    thread = threading.Thread(target=run)
    thread.start()
    while not any(worker.load for worker in workers._workers):
        time.sleep(0.001)
    workers.close()
    thread.join()
    assert outcome == ["ended"]
