"""Feet that slide, parts that sink into the floor, and a body that would tip over."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_opening

from motion.centre_of_mass import centre_of_mass
from motion.editing.foot_plants import leg_length, runs
from motion.kinematics import WorldPose
from motion.quality.pair import Pair
from motion.quality.report import Measure, in_words

Array = NDArray[np.float64]

SLIP = 0.005  # m within one plant
DEPTH = 0.01  # m below the floor
# m beyond the line between heel and ball: a sole reaches farther than the points that it is known
# by, and people lean on their toes.
OVERHANG = 0.06
_STILL = 0.15  # leg lengths a second, below which the hips stand
_STILL_FOR = 0.5  # s
_LEVEL = [0, 2]


def slips(pair: Pair) -> Iterator[Measure]:
    """How far each sole's point has moved on the floor since its plant began."""
    for foot in pair.feet:
        for point, planted in zip(foot.points, foot.planted, strict=True):
            before, after = point.positions(pair.before), point.positions(pair.after)
            for plant in runs(planted):
                values = np.zeros(len(after))
                values[plant] = _drift(after[plant])
                allowed = max(SLIP, float(_drift(before[plant]).max()))
                yield Measure("foot slip", f"{foot.side} foot", "m", values, allowed)


def sunk(pair: Pair) -> Iterator[Measure]:
    """How deep soles, hands, knees, hips and head are below the floor."""
    for foot in pair.feet:
        before, after = (
            -np.min([p.positions(pose)[:, 1] for p in foot.points], axis=0)
            for pose in (pair.before, pair.after)
        )
        yield Measure("floor", f"{foot.side} foot", "m", after, max(DEPTH, float(before.max())))
    for role, joint in pair.roles.items():
        if role.removeprefix("left_").removeprefix("right_") in ("hand", "shin", "hips", "head"):
            before, after = -pair.before.positions[:, joint, 1], -pair.after.positions[:, joint, 1]
            yield Measure("floor", in_words(role), "m", after, max(DEPTH, float(before.max())))


def imbalance(pair: Pair) -> Iterator[Measure]:
    """How far the centre of mass is outside the feet's support while the body stands still."""
    still = _standing_still(pair)
    if not still.any():
        return
    before, after = (
        np.where(still, distance_outside(_support(pair, pose), _over_floor(pair, pose)), 0.0)
        for pose in (pair.before, pair.after)
    )
    yield Measure("balance", "body", "m", after, max(OVERHANG, float(before.max())))


def distance_outside(support: Array, place: Array) -> Array:
    """Distance (T,) of places (T, 2) from the convex hull of a support's N points (T, N, 2)."""
    distance = np.full(len(place), np.inf)
    for a, b in combinations(range(support.shape[1]), 2):
        distance = np.minimum(distance, _from_line(support[:, a], support[:, b], place))
    for corners in combinations(range(support.shape[1]), 3):
        inside = _in_triangle(support[:, list(corners)], place)
        distance = np.where(inside, 0.0, distance)
    return distance


def _drift(places: Array) -> Array:
    return np.linalg.norm((places - places[0])[:, _LEVEL], axis=1)


def _standing_still(pair: Pair) -> NDArray[np.bool_]:
    hips = pair.before.positions[:, pair.roles["hips"]][:, _LEVEL]
    if len(hips) < 3:
        return np.zeros(len(hips), dtype=bool)
    step = pair.original.frame_time
    speed = np.linalg.norm(np.gradient(hips, step, axis=0), axis=1)
    slow = speed < _STILL * leg_length(pair.original, "left")
    for foot in pair.feet:
        slow &= foot.stands
    return np.asarray(binary_opening(slow, np.ones(max(1, round(_STILL_FOR / step)), dtype=bool)))


def _support(pair: Pair, pose: WorldPose) -> Array:
    return np.stack([p.positions(pose)[:, _LEVEL] for f in pair.feet for p in f.points], axis=1)


def _over_floor(pair: Pair, pose: WorldPose) -> Array:
    return centre_of_mass(pair.original.skeleton, pose)[:, _LEVEL]


def _from_line(start: Array, end: Array, place: Array) -> Array:
    way = end - start
    length = np.maximum(np.sum(way**2, axis=1), 1e-18)
    share = np.clip(np.sum((place - start) * way, axis=1) / length, 0.0, 1.0)
    return np.linalg.norm(place - start - share[:, None] * way, axis=1)


def _in_triangle(corners: Array, place: Array) -> NDArray[np.bool_]:
    turns = []
    for a, b in ((0, 1), (1, 2), (2, 0)):
        way, to = corners[:, b] - corners[:, a], place - corners[:, a]
        turns.append(way[:, 0] * to[:, 1] - way[:, 1] * to[:, 0])
    sides = np.array(turns)
    return np.all(sides > 0, axis=0) | np.all(sides < 0, axis=0)
