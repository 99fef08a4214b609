"""The real server as a process that tests may kill and start again."""

from __future__ import annotations

import multiprocessing
import os
import re
import signal
import socket
import time
import urllib.error
import urllib.request
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing.process import BaseProcess
from pathlib import Path

# Generous, for a slow machine that does other things besides: only a hanging server takes longer.
START_SECONDS = 120
STOP_SECONDS = 60
SET_UP_LINK = re.compile(r"http://\S+/research/set-up/\S+")

# Servers are forked from one process that has loaded the code: loading it takes each of them 3 s.
# Nothing has run there, so there are no connections or locks to inherit; OpenBLAS, which has
# threads once it is loaded, ends them before a fork.
_loaded = multiprocessing.get_context("forkserver")
_loaded.set_forkserver_preload(["app.cli", "app.main", "app.services.preparation", "uvicorn"])


def free_port() -> int:
    """A port of 127.0.0.1 that nobody listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@dataclass
class Server:
    """One ``manner serve`` on a free port of 127.0.0.1, with a data folder of its own."""

    data_directory: Path
    port: int = field(default_factory=free_port)
    environment: dict[str, str] = field(default_factory=dict)
    process: BaseProcess | None = None

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    @property
    def log(self) -> str:
        """Everything that the server has printed, over all its lives."""
        return self._log_file.read_text(errors="replace")

    @property
    def set_up_link(self) -> str:
        """The one-time link that the first start prints in the terminal."""
        match = SET_UP_LINK.search(self.log)
        assert match, f"no set-up link was printed:\n{self.log}"
        return match.group()

    @property
    def _log_file(self) -> Path:
        return self.data_directory / "server.log"

    def start(self) -> None:
        environment = {
            **os.environ,
            "MANNER_DATA_DIRECTORY": str(self.data_directory),
            "MANNER_PUBLIC_URL": self.url,
            **self.environment,
        }
        self._log_file.touch()  # read even if the server ends before it can print
        self.process = _loaded.Process(target=_serve, args=(self.port, environment, self._log_file))
        self.process.start()
        try:
            self._wait_until_healthy()
        except BaseException:
            self.kill()  # or the tests would wait for it at their own end
            raise

    def kill(self) -> None:
        """SIGKILL: no time to flush, drain or say goodbye."""
        self._end(signal.SIGKILL)

    def stop(self) -> None:
        """SIGTERM: the server may drain what it holds."""
        self._end(signal.SIGTERM)

    def restart(self) -> None:
        if self.process is not None:
            self.kill()
        self.start()

    def _end(self, how: signal.Signals) -> None:
        if self.process is None or self.process.pid is None:
            return
        with suppress(ProcessLookupError):  # it has ended by itself
            os.killpg(self.process.pid, how)
        self.process.join(STOP_SECONDS)
        assert self.process.exitcode is not None, f"the server did not end:\n{self.log}"
        self.process = None

    def _wait_until_healthy(self) -> None:
        deadline = time.monotonic() + START_SECONDS
        while time.monotonic() < deadline:
            if self.process is None or not self.process.is_alive():
                raise AssertionError(f"the server ended while starting:\n{self.log}")
            try:
                with urllib.request.urlopen(f"{self.url}/health", timeout=2) as answer:
                    if answer.status == 200:
                        return
            except (urllib.error.URLError, OSError):
                time.sleep(0.1)
        raise AssertionError(f"the server was not healthy in {START_SECONDS} s:\n{self.log}")


def _serve(port: int, environment: Mapping[str, str], log: Path) -> None:
    """What ``manner serve`` does, as a process of its own group that prints into a file."""
    os.setsid()
    os.environ.clear()
    os.environ.update(environment)
    for stream in (1, 2):
        os.dup2(os.open(log, os.O_WRONLY | os.O_APPEND | os.O_CREAT), stream)
    from app.cli import app

    app(["serve", "--port", str(port)])
