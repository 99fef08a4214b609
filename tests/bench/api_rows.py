"""Recipes over the API: the real server, real sockets, one client and eight.

The clip lasts 10 s at 100 fps. Each client is an asynchronous one on one kept-alive connection, so
that the load itself costs little of the two processors that the server needs.
"""

from __future__ import annotations

import asyncio
import itertools
import json
import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.persistence.models import Researcher
from app.services import keys, library
from app.services.clip_files import make_files
from motion import Clip
from motion.editing.tempo import resample_rate
from motion.procedural.library import set_b
from tests.bench.measure import Row
from tests.support.server import Server

SECONDS, RATE = 10.0, 100.0
REQUESTS = 60
CLIENTS = 8
Request = tuple[str, str, bytes]  # method, path, body


def rows(scratch: Path) -> list[Row]:
    """Latency of one client, and the throughput of eight against that of one."""
    folder = scratch / "api"
    folder.mkdir()
    key, clip = prepare(folder)
    server = Server(folder)
    server.start()
    try:
        return asyncio.run(_measure(server.port, key, clip))
    finally:
        server.stop()


def prepare(folder: Path) -> tuple[str, str]:
    """A database with one clip and one key; the key and the clip's id."""
    engine = make_engine(f"sqlite:///{folder / 'manner.sqlite3'}")
    schema.upgrade(engine)
    with Database(engine).writing() as db:
        researcher = Researcher(email="bench@example.org", name="Bench", password_hash="")
        db.add(researcher)
        db.flush()
        files = make_files(long_walk())
        clip = library.store(db, files, name="walk", source="imported", state="kept", tags={})
        clip_id = clip.id
        db.commit()
        secret = keys.make(db, researcher.id, "bench", "write").secret
    engine.dispose()
    return secret, clip_id


def long_walk() -> Clip:
    """A neutral walk, cycle after cycle, ten seconds at 100 fps."""
    cycle = next(s.clip for s in set_b() if s.tags.get("emotion", "neutral") == "neutral")
    cycles = int(np.ceil(SECONDS / cycle.duration)) + 1
    travel = cycle.travel * [1.0, 0.0, 1.0]
    roots = [cycle.root_positions[:-1] + n * travel for n in range(cycles)]
    walk = replace(
        cycle,
        root_positions=np.concatenate(roots),
        rotations=np.concatenate([cycle.rotations[:-1]] * cycles),
        cyclic=False,
    )
    walk = resample_rate(walk, RATE)
    frames = int(SECONDS * RATE)
    return replace(
        walk, root_positions=walk.root_positions[:frames], rotations=walk.rotations[:frames]
    )


async def _measure(port: int, key: str, clip: str) -> list[Row]:
    fresh = recipes(clip)

    def new() -> Request:
        return "POST", "/api/v1/clips", next(fresh)

    def known() -> Request:
        return "POST", "/api/v1/clips", first

    def glb() -> Request:
        return "GET", f"/api/v1/clips/{clip}.glb", b""

    first = next(fresh)
    # Warmed up: the workers have started, and each knows the clip and its nine motions.
    for warm in (known, glb):
        await load(port, key, warm, clients=1, count=3)
    await load(port, key, new, clients=CLIENTS, count=4 * CLIENTS)
    rows = []
    for what, request, aim in (
        ("Recipe over the API, 10 s × 100 fps, new", new, "≤ 60"),
        ("Recipe over the API, known", known, "≤ 8"),
        ("Clip as GLB with figure, kept", glb, "≤ 8"),
    ):
        times = await load(port, key, request, clients=1, count=REQUESTS)
        rows.append(Row(f"{what}, p50", "Manner", statistics.median(times) * 1e3, "ms", aim))
    rows.append(await _scaling(port, key, new))
    return rows


async def _scaling(port: int, key: str, new: Callable[[], Request]) -> Row:
    """Throughput of eight clients over that of one, taken in turn."""
    shares = []
    for _ in range(3):
        rates = []
        for clients in (1, CLIENTS):
            start = time.perf_counter()
            await load(port, key, new, clients=clients, count=REQUESTS)
            rates.append(REQUESTS / (time.perf_counter() - start))
        shares.append(rates[1] / rates[0])
    spread = (min(shares), max(shares))
    what = f"New recipes a second, {CLIENTS} clients : 1"
    return Row(what, "Manner", statistics.median(shares), "×", "≥ 1.7", spread)


def recipes(clip: str) -> Iterator[bytes]:
    """Requests for clips that nobody has asked for yet: a grid point and a posture."""
    for number in itertools.count():
        path, timing = 0.2 + (number * 0.618034) % 1.6, 0.2 + (number * 0.754878) % 1.6
        offsets = [{"pose": "head_down", "amount": 0.5}, {"pose": "elbows_away", "amount": 0.3}]
        steps = [
            {"operation": "grid@1", "parameters": {"path": path, "timing": timing}},
            {"operation": "posture@1", "parameters": {"offsets": offsets}},
        ]
        yield json.dumps({"source": clip, "operations": steps}).encode()


async def load(
    port: int, key: str, request: Callable[[], Request], *, clients: int, count: int
) -> list[float]:
    """Send so many requests, spread over the clients; the seconds that each took."""
    left = iter(range(count))
    times: list[float] = []

    async def client() -> None:
        reader, writer = await asyncio.open_connection("127.0.0.1", port)
        for _ in left:
            start = time.perf_counter()
            await _send(reader, writer, key, request())
            times.append(time.perf_counter() - start)
        writer.close()

    await asyncio.gather(*(client() for _ in range(clients)))
    return times


async def _send(
    reader: asyncio.StreamReader, writer: asyncio.StreamWriter, key: str, request: Request
) -> None:
    method, path, body = request
    head = (
        f"{method} {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nAuthorization: Bearer {key}\r\n"
        f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n"
    )
    writer.write(head.encode() + body)
    answer = (await reader.readuntil(b"\r\n\r\n")).decode().lower()
    length = int(answer.partition("content-length:")[2].split("\r\n")[0])
    content = await reader.readexactly(length)
    if not answer.startswith(("http/1.1 200", "http/1.1 201")):
        raise AssertionError(content.decode())
