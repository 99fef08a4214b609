"""Sliders of an authoring space: from a moved slider to the new motion, over real sockets."""

from __future__ import annotations

import asyncio
import itertools
import json
import statistics
from collections.abc import Callable, Iterator
from pathlib import Path

from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.persistence.models import Researcher
from app.services import keys, library, new_spaces
from app.services.clip_files import make_files
from app.services.space_making import define
from motion.procedural.library import set_b
from tests.bench.api_rows import Request, load
from tests.bench.measure import RUNS, Row
from tests.support.server import Server

REQUESTS = 60  # of each run


def rows(scratch: Path) -> list[Row]:
    """The server's share of a slider's drag."""
    folder = scratch / "spaces"
    folder.mkdir()
    key, space_id = prepare(folder)
    server = Server(folder)
    server.start()
    try:
        return asyncio.run(_measure(server.port, key, space_id))
    finally:
        server.stop()


def prepare(folder: Path) -> tuple[str, str]:
    """A database with a space of the 27 walks of set B; a key and the space's id."""
    engine = make_engine(f"sqlite:///{folder / 'manner.sqlite3'}")
    schema.upgrade(engine)
    with Database(engine).writing() as db:
        researcher = Researcher(email="bench@example.org", name="Bench", password_hash="")
        db.add(researcher)
        db.flush()
        ids = [
            library.store(
                db, make_files(one.clip), name=one.name, source="sample", state="kept", tags={}
            ).id
            for one in set_b()
        ]
        db.flush()
        defined = define("Set B", new_spaces.sources(db, ids), {})
        space = new_spaces.keep(db, defined, study_id=None, made_by=None)
        db.commit()
        secret = keys.make(db, researcher.id, "bench", "read").secret
    engine.dispose()
    return secret, space.id


async def _measure(port: int, key: str, space_id: str) -> list[Row]:
    body = points()

    def asking(what: str) -> Callable[[], Request]:
        return lambda: ("POST", f"/api/v1/spaces/{space_id}/{what}", next(body))

    found = []
    for what, path, aim in (
        ("Slider to new motion, 27 examples", "motion", "≤ 15"),
        ("Slider to weights, 27 examples", "weights", ""),
    ):
        await load(port, key, asking(path), clients=1, count=5)  # the space is prepared
        runs = [
            1e3 * statistics.median(await load(port, key, asking(path), clients=1, count=REQUESTS))
            for _ in range(RUNS)
        ]
        spread = (min(runs), max(runs))
        found.append(Row(f"{what}, p50", "Manner", statistics.median(runs), "ms", aim, spread))
    return found


def points() -> Iterator[bytes]:
    """Points that nobody has asked for yet, moving one of the four sliders each time."""
    names = ["lateral_swing_group", "limb_swing_group", "bending_group", "step_length_group"]
    values = dict.fromkeys(names, 0.5)
    for number in itertools.count():
        values[names[number % 4]] = (number * 0.618034) % 1.0
        yield json.dumps({"interface": "features", "values": values}).encode()
