"""Skeletons of every kind that a body must fit, and what their meshes are measured with."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from motion.clip import Clip
from motion.figure import FigureMesh, build_figure
from motion.ingest import IngestOptions, ingest
from motion.procedural.bodies import BODIES
from motion.procedural.styles import CHARACTERS
from motion.procedural.walk import walk_cycle
from motion.skeleton import EndSite, Skeleton

SAMPLE = ("adult", "female", "male")
RECORDED = ("bandai-namco/walk_normal_001.bvh", "cmu/12_01_walk.bvh")
CASES = (*SAMPLE, *RECORDED)


@cache
def sample_clip(body: str) -> Clip:
    return walk_cycle(CHARACTERS["neutral"], BODIES[body])


@cache
def recorded_clip(path: Path) -> Clip:
    return ingest(path.read_bytes(), IngestOptions()).clip


@cache
def figure_of(clip: Clip) -> FigureMesh:
    return build_figure(clip)


def without_roles(clip: Clip, *parts: str) -> Clip:
    """The clip of a skeleton that does not say which joints some parts are."""
    kept = {
        role: joint
        for role, joint in clip.skeleton.roles.items()
        if role not in parts and role.partition("_")[2] not in parts
    }
    skeleton = clip.skeleton.with_roles(kept)
    return Clip(skeleton, clip.root_positions, clip.rotations, clip.frame_time, clip.cyclic)


def scaled(clip: Clip, factor: float) -> Clip:
    """The same motion of a body that is larger in every direction."""
    old = clip.skeleton
    sites = tuple(
        EndSite(site.joint, tuple((np.array(site.offset) * factor).tolist()))
        for site in old.end_sites
    )
    skeleton = Skeleton(old.names, old.parents, old.offsets * factor, sites, old.roles)
    return Clip(skeleton, clip.root_positions * factor, clip.rotations, clip.frame_time)


def edges(triangles: np.ndarray) -> np.ndarray:
    """(3F, 2) the directed edges of triangles (F, 3)."""
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def volume(positions: np.ndarray, triangles: np.ndarray) -> float:
    """Signed volume within a closed surface: above zero where the triangles face outward."""
    a, b, c = (positions[triangles[:, corner]] for corner in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)
