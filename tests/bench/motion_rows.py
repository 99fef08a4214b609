"""Reading BVH, kinematics and writing GLB, beside the packages that people use today."""

from __future__ import annotations

import contextlib
import gzip
import io
import math
import warnings
from collections.abc import Callable
from pathlib import Path

import bvhio
import numpy as np
import pybvh
from pymotion.io.bvh import BVH
from pymotion.ops.skeleton import fk as pymotion_fk

from motion import Clip
from motion.bvh import read_bvh
from motion.figure import build_figure
from motion.glb import write_clip_glb, write_figure_glb
from motion.ingest import IngestOptions, ingest
from motion.kinematics import forward_kinematics
from tests.bench.measure import Row, durations, rates

MOTIONS = Path(__file__).resolve().parents[3] / "shared" / "motions"


def rows(scratch: Path) -> list[Row]:
    """All rows about motion; files for the peers are written to ``scratch``."""
    walk = MOTIONS / "cmu" / "12_01_walk.bvh"
    long_walk = repeated(walk, scratch / "cmu_2752_frames.bvh", frames=2752)
    large = repeated(walk, scratch / "cmu_20_megabytes.bvh", size=20_000_000)
    found = [
        *parsing("Read BVH, CMU 131_01", MOTIONS / "cmu" / "131_01_start_walk_stop.bvh", "≥ pybvh"),
        *parsing("Read BVH, CMU, 2752 × 31", long_walk, "≥ pybvh"),
        *parsing("Read BVH, 20 MB", large, "≥ 120", slow_peers=False),
        *parsing(
            "Read BVH, Bandai dance",
            MOTIONS / "bandai-namco" / "dance-short_normal_001.bvh",
            "as CMU",
        ),
    ]
    clip = ingest(long_walk.read_bytes(), IngestOptions()).clip
    return [*found, *kinematics(clip, long_walk), *glb(clip), *figure(clip)]


def repeated(source: Path, target: Path, *, frames: int = 0, size: int = 0) -> Path:
    """A longer file made of a real one's frames over and over."""
    head, _, motion = source.read_text().partition("MOTION")
    lines = motion.split("\n", 3)
    rows = lines[3].strip("\n").split("\n")
    wanted = frames or size // (len("\n".join(rows)) // len(rows) + 1)
    more = (rows * (wanted // len(rows) + 1))[:wanted]
    target.write_text(f"{head}MOTION\nFrames: {wanted}\n{lines[2]}\n" + "\n".join(more) + "\n")
    return target


def quietly(run: Callable[[], object]) -> Callable[[], object]:
    """The same without the peers' prints and warnings."""

    def silent() -> object:
        with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return run()

    return silent


def parsing(what: str, path: Path, aim: str, *, slow_peers: bool = True) -> list[Row]:
    contenders: dict[str, Callable[[], object]] = {
        "Manner": lambda: read_bvh(path.read_bytes()),
        "pybvh": quietly(lambda: pybvh.read_bvh_file(str(path))),
    }
    if slow_peers:
        contenders["PyMotion"] = quietly(lambda: BVH().load(str(path)))
        contenders["bvhio"] = quietly(lambda: bvhio.readAsBvh(str(path)))
    able = {who: read for who, read in contenders.items() if _reads(read)}
    measured = rates(what, able, path.stat().st_size / 1e6, "MB/s", aim)
    refused = [Row(what, who, math.nan, "cannot read it") for who in contenders if who not in able]
    return measured + refused


def _reads(read: Callable[[], object]) -> bool:
    """Whether a package reads the file at all; ours must."""
    try:
        read()
    except Exception:
        return False
    return True


def kinematics(clip: Clip, path: Path) -> list[Row]:
    theirs = quietly(lambda: pybvh.read_bvh_file(str(path)))()
    skeleton = clip.skeleton
    offsets, parents = (
        np.array(skeleton.offsets),
        np.where(skeleton.parents < 0, 0, skeleton.parents),
    )
    contenders: dict[str, Callable[[], object]] = {
        "Manner": lambda: forward_kinematics(clip),
        "PyMotion": lambda: pymotion_fk(clip.rotations, clip.root_positions, offsets, parents),
        # Not its node_positions(), which computes once and then hands out copies.
        "pybvh": quietly(lambda: pybvh.frames_to_node_positions(theirs)),
    }
    work = clip.frames * len(skeleton) / 1e6
    return rates("Forward kinematics, 2752 × 31", contenders, work, "M frame-joints/s", "≥ 20")


def glb(clip: Clip) -> list[Row]:
    return durations("Write GLB, 2752 × 31", {"Manner": lambda: write_clip_glb(clip)}, aim="≤ 10")


def figure(clip: Clip) -> list[Row]:
    mesh = build_figure(clip)
    size = len(gzip.compress(write_figure_glb(mesh), 6)) / 1000
    return [
        *durations("Make a figure's mesh", {"Manner": lambda: build_figure(clip)}, aim="≤ 2000"),
        Row("Figure's mesh, gzip", "Manner", size, "kB", "≤ 150"),
    ]
