"""Durable answers a second: the real server, real sockets, many clients at once.

Each client is a participant with a session of its own that answers over and over (a changed answer
is a new revision), one request after the other on one kept-alive connection.

    python -m tests.bench.answers_load --clients 32 --seconds 5
"""

from __future__ import annotations

import argparse
import asyncio
import json
import statistics
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.persistence.writer import Writer
from tests.support.server import Server
from tests.support.simulate import add_study, answer_with
from tests.support.taking_part import SCALES, begin


@dataclass
class Load:
    """What one run measured: answers acknowledged, their latencies in ms, over how many seconds."""

    latencies: list[float] = field(default_factory=list)
    seconds: float = 0.0

    @property
    def rate(self) -> float:
        """Acknowledged answers per second."""
        return len(self.latencies) / self.seconds

    def percentile(self, percent: float) -> float:
        """Latency in ms below which so many per cent of the answers lie."""
        return statistics.quantiles(self.latencies, n=1000)[round(percent * 10) - 1]


def measure(clients: int = 32, seconds: float = 5.0, runs: int = 1) -> list[Load]:
    """Start a server on an empty SQLite database (synchronous=FULL), load it, stop it."""
    with tempfile.TemporaryDirectory() as folder:
        tokens = prepare(f"sqlite:///{Path(folder) / 'manner.sqlite3'}", clients)
        server = Server(Path(folder))
        server.start()
        try:
            return [
                asyncio.run(load(server.port, tokens, seconds, round_)) for round_ in range(runs)
            ]
        finally:
            server.stop()


def prepare(database_url: str, clients: int) -> list[str]:
    """A migrated database with the demonstration study and one session a client."""
    engine = make_engine(database_url)
    schema.upgrade(engine)
    database = Database(engine)
    with database.writing() as db:
        add_study(db)
    writer = Writer(database)
    tokens = [writer.write(begin) for _ in range(clients)]
    writer.close()
    engine.dispose()
    return tokens


async def load(port: int, tokens: list[str], seconds: float, round_: int = 0) -> Load:
    """All clients at once for so many seconds; a round's answers are new revisions."""
    result = Load()
    start = time.perf_counter()
    clients = [_client(port, token, start + seconds, round_, result) for token in tokens]
    await asyncio.gather(*clients)
    result.seconds = time.perf_counter() - start
    return result


async def _client(port: int, token: str, end: float, round_: int, result: Load) -> None:
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    values = dict.fromkeys(SCALES, 1)
    answer = answer_with(values).model_dump(mode="json")
    number = 0
    while time.perf_counter() < end:
        revision = 1 + round_ * 1000 + number // 22
        answer |= {"trial_index": number % 22, "revision": revision}
        body = json.dumps(answer).encode()
        head = (
            f"POST /api/v1/sessions/{token}/responses HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n"
            f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n"
        )
        sent = time.perf_counter()
        writer.write(head.encode() + body)
        status, content = await _answer(reader)
        result.latencies.append(1000 * (time.perf_counter() - sent))
        if status != 201 or json.loads(content)["revision"] != revision:
            raise AssertionError(f"answer {number} was not stored: {status} {content[:300]!r}")
        number += 1
    writer.close()


async def _answer(reader: asyncio.StreamReader) -> tuple[int, bytes]:
    head = await reader.readuntil(b"\r\n\r\n")
    lines = head.decode("latin-1").split("\r\n")
    length = next(int(li.split(":")[1]) for li in lines if li.lower().startswith("content-length"))
    return int(lines[0].split()[1]), await reader.readexactly(length)


def main() -> None:
    """Measure and print one line a run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--clients", type=int, default=32)
    parser.add_argument("--seconds", type=float, default=5.0)
    parser.add_argument("--runs", type=int, default=3)
    given = parser.parse_args()
    for run in measure(given.clients, given.seconds, given.runs):
        print(
            f"{run.rate:7.0f} answers/s   p50 {run.percentile(50):6.1f} ms   "
            f"p95 {run.percentile(95):6.1f} ms   worst {max(run.latencies):6.1f} ms"
        )


if __name__ == "__main__":
    main()
