"""Limbs that go through the trunk, the head or each other: capsules along the bones."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.kinematics import WorldPose
from motion.quality.pair import Pair
from motion.quality.report import Measure, in_words

Array = NDArray[np.float64]

DEPTH = 0.01  # m, more than in the original
# Radii of a slim body, a little less than the drawn figure's: touching is no fault. Limbs as a
# share of the bone, the trunk's two columns as a share of its height, hip joints to shoulders.
_FOREARM, _HAND, _SHIN = 0.13, 0.12, 0.09
_TRUNK, _HEAD = 0.14, 0.16
_TRUNK_HIPS, _TRUNK_SHOULDERS = 0.5, 0.35  # how far out the columns stand, of the joints' distance


@dataclass(frozen=True, eq=False)
class Capsule:
    """All points within a radius of a line.

    Attributes:
        start, end: (T, 3) metres.
        radius: metres.
    """

    start: Array
    end: Array
    radius: float


def intersections(pair: Pair) -> Iterator[Measure]:
    """How deep forearms and hands are in the trunk and head, and the shins in each other."""
    before, after = (dict(_capsules(pair, pose)) for pose in (pair.before, pair.after))
    for part, obstacles in _meetings(after):
        depths = [
            np.max([depth(found[part], found[name]) for name in obstacles], axis=0)
            for found in (before, after)
        ]
        limit = DEPTH + max(0.0, float(depths[0].max()))
        yield Measure("intersection", in_words(part), "m", depths[1], limit)


def depth(one: Capsule, other: Capsule) -> Array:
    """How deep (T,) two capsules are in each other, metres; negative where they are apart."""
    return one.radius + other.radius - _distance(one.start, one.end, other.start, other.end)


def _meetings(capsules: dict[str, Capsule]) -> Iterator[tuple[str, list[str]]]:
    body = ["left_trunk", "right_trunk", "head"]
    for side in ("left", "right"):
        for part in ("forearm", "hand"):
            if f"{side}_{part}" in capsules:
                yield f"{side}_{part}", body
    yield "left_shin", ["right_shin"]


def _capsules(pair: Pair, pose: WorldPose) -> Iterator[tuple[str, Capsule]]:
    def at(role: str) -> Array:
        return pose.positions[:, pair.roles[role]]

    def between(a: str, b: str) -> float:
        """Distance of two joints in the original, on average: both clips get the same body."""
        where = pair.before.positions[:, [pair.roles[a], pair.roles[b]]]
        return float(np.linalg.norm(where[:, 0] - where[:, 1], axis=1).mean())

    hips = (at("left_thigh") + at("right_thigh")) / 2.0
    shoulders = (at("left_upper_arm") + at("right_upper_arm")) / 2.0
    height = between("left_thigh", "left_upper_arm")
    for side in ("left", "right"):
        low = hips + _TRUNK_HIPS * (at(f"{side}_thigh") - hips)
        high = shoulders + _TRUNK_SHOULDERS * (at(f"{side}_upper_arm") - shoulders)
        radius = _TRUNK * height
        top = high + radius * _unit(low - high)  # the round end stays below the shoulders
        yield f"{side}_trunk", Capsule(low, top, radius)
        if f"{side}_hand" in pair.roles:
            elbow, wrist = at(f"{side}_forearm"), at(f"{side}_hand")
            length = between(f"{side}_forearm", f"{side}_hand")
            middle = (elbow + wrist) / 2.0  # near the elbow an arm may press against the side
            yield f"{side}_forearm", Capsule(middle, wrist, _FOREARM * length)
            beyond = wrist + 0.35 * (wrist - elbow)
            yield f"{side}_hand", Capsule(wrist, beyond, _HAND * length)
        shin = between(f"{side}_shin", f"{side}_foot")
        yield f"{side}_shin", Capsule(at(f"{side}_shin"), at(f"{side}_foot"), _SHIN * shin)
    head = at("head")
    crown = head + 0.15 * height * _unit(shoulders - hips)
    yield "head", Capsule(head, crown, _HEAD * height)


def _distance(a: Array, b: Array, c: Array, d: Array) -> Array:
    """Shortest distance (T,) of the lines a–b and c–d, each (T, 3) to (T, 3).

    Either the lines are nearest within both, or one is nearest at one of its ends.
    """
    first, second, gap = b - a, d - c, a - c
    along, across, other = (_dot(first, first), _dot(first, second), _dot(second, second))
    to_first, to_second = _dot(first, gap), _dot(second, gap)
    span = along * other - across**2
    safe = np.where(span > 1e-12, span, 1.0)
    s = (across * to_second - other * to_first) / safe
    t = (along * to_second - across * to_first) / safe
    inside = (span > 1e-12) & (s >= 0) & (s <= 1) & (t >= 0) & (t <= 1)
    crossing = np.linalg.norm(gap + s[:, None] * first - t[:, None] * second, axis=1)
    ends = [_to_line(a, c, d), _to_line(b, c, d), _to_line(c, a, b), _to_line(d, a, b)]
    return np.where(inside, crossing, np.min(ends, axis=0))


def _to_line(place: Array, start: Array, end: Array) -> Array:
    way = end - start
    share = np.clip(_dot(place - start, way) / np.maximum(_dot(way, way), 1e-18), 0.0, 1.0)
    return np.linalg.norm(place - start - share[:, None] * way, axis=1)


def _dot(a: Array, b: Array) -> Array:
    return np.sum(a * b, axis=-1)


def _unit(vectors: Array) -> Array:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)
