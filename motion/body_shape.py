"""Body roles from the skeleton's shape alone: two legs, a trunk, two arms and a head."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from motion.kinematics import WorldPose
from motion.rotations import conjugate, multiply
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

_ALIKE = 0.2  # limbs of a pair differ in length by less than this share
_FINGER = 0.4  # of an arm's longest bone: a bone shorter than this belongs to the hand
_CANDIDATES = 8  # a hand full of fingers at one joint is no reason to compare every two of them
_NOTHING = 1e-3  # of the longest bone: a bone shorter than this only repeats a joint


@dataclass(frozen=True)
class _Tree:
    """The joints that have a place of their own, each with its children and longest way down."""

    children: dict[int, list[int]]
    lengths: Array  # (J,) distance to the next kept ancestor
    depth: Array  # (J,) length of the longest chain that starts with this joint's own bone
    still: set[int]  # joints that never turn in their parent


def roles_by_shape(skeleton: Skeleton, pose: WorldPose) -> dict[str, int]:
    """Roles by topology and proportion; empty where the shape is no body's."""
    tree = _tree(skeleton, pose)
    for hips in range(len(skeleton)):
        found = _pair(tree, tree.children.get(hips, []))
        if found is None:
            continue
        legs, rest = found
        chest = _next_fork(tree, rest)
        if chest is None:
            continue
        arms, skull = chest.arms, chest.skull
        roles = {"hips": hips} | _trunk(tree, rest, chest.joint, skull)
        sides = _sides(tree, pose, legs, arms, roles)
        for side, leg, arm in sides:
            roles |= {f"{side}_{part}": joint for part, joint in leg.items()}
            roles |= {f"{side}_{part}": joint for part, joint in arm.items()}
        return roles
    return {}


def is_left(pose: WorldPose, roles: Mapping[str, int]) -> bool | None:
    """Whether left roles lie on the body's left; None where the shape cannot tell.

    Left is up × forward; up points from the feet to the head, forward from the ankles to the toes.
    """
    needed = (
        "left_thigh",
        "right_thigh",
        "left_foot",
        "right_foot",
        "left_toes",
        "right_toes",
        "head",
    )
    if any(role not in roles for role in needed):
        return None
    at = {role: pose.positions[:, roles[role]] for role in needed}
    up = at["head"] - (at["left_foot"] + at["right_foot"]) / 2
    forward = at["left_toes"] + at["right_toes"] - at["left_foot"] - at["right_foot"]
    across = at["left_thigh"] - at["right_thigh"]
    votes = np.sum(np.cross(up, forward) * across, axis=-1)
    size = float(np.abs(votes).max(initial=0.0))
    return None if size == 0 else bool(np.median(votes) > 0)


def _tree(skeleton: Skeleton, pose: WorldPose) -> _Tree:
    own = np.linalg.norm(skeleton.offsets, axis=-1)
    tiny = _NOTHING * own.max(initial=0.0)
    children: dict[int, list[int]] = {}
    for joint in range(1, len(skeleton)):
        parent = int(skeleton.parents[joint])
        children.setdefault(parent, []).append(joint)
    depth = own.copy()
    for joint in range(len(skeleton) - 1, 0, -1):
        parent = int(skeleton.parents[joint])
        depth[parent] = max(depth[parent], own[parent] + depth[joint])
    own = np.where(own > tiny, own, 0.0)
    still = {joint for joint in range(1, len(skeleton)) if _never_turns(skeleton, pose, joint)}
    return _Tree(children, own, depth, still)


def _never_turns(skeleton: Skeleton, pose: WorldPose, joint: int) -> bool:
    parent = skeleton.parents[joint]
    local = multiply(conjugate(pose.rotations[:, parent]), pose.rotations[:, joint])
    return bool(np.ptp(local, axis=0).max() < 1e-6)


def _pair(tree: _Tree, branches: list[int]) -> tuple[tuple[int, int], list[int]] | None:
    """The two longest branches that are alike, and the others."""
    best: tuple[float, tuple[int, int]] | None = None
    longest = sorted(branches, key=lambda joint: -tree.depth[joint])[:_CANDIDATES]
    for first, second in combinations(longest, 2):
        a, b = tree.depth[first], tree.depth[second]
        alike = abs(a - b) <= _ALIKE * max(a, b)
        if alike and min(_bones(tree, first), _bones(tree, second)) >= 2:
            score = _likeness(tree, first, second) * min(a, b)
            if best is None or score > best[0]:
                best = (float(score), (first, second))
    if best is None:
        return None
    rest = [branch for branch in branches if branch not in best[1]]
    return (best[1], rest) if rest else None


def _likeness(tree: _Tree, first: int, second: int) -> float:
    """1 for branches whose bones have the same lengths, towards 0 for others."""
    a, b = np.zeros(4), np.zeros(4)
    for bones, branch in ((a, first), (b, second)):
        chain = _chain(tree, branch)[1:5]
        bones[: len(chain)] = tree.lengths[chain]
    return 1.0 - min(1.0, float(np.abs(a - b).sum() / max(a.sum() + b.sum(), 1e-12)) * 2)


def _bones(tree: _Tree, joint: int) -> int:
    return sum(tree.lengths[part] > 0 for part in _chain(tree, joint)[1:])


def _chain(tree: _Tree, joint: int) -> list[int]:
    """A joint and its descendants along the longest way down."""
    path = [joint]
    while below := tree.children.get(path[-1]):
        path.append(max(below, key=lambda child: tree.depth[child]))
    return path


@dataclass(frozen=True)
class _Chest:
    joint: int
    arms: tuple[int, int]
    skull: int


def _next_fork(tree: _Tree, branches: list[int]) -> _Chest | None:
    """The first joint below ``branches`` from which two arms and a neck leave."""
    queue = list(branches)
    while queue:
        joint = queue.pop(0)
        below = tree.children.get(joint, [])
        found = _pair(tree, below)
        if found is not None:
            arms, others = found
            return _Chest(joint, arms, max(others, key=lambda other: tree.depth[other]))
        queue += below
    return None


def _trunk(tree: _Tree, rest: list[int], chest: int, skull: int) -> dict[str, int]:
    path = _path_to(tree, rest, chest)
    neck_path = _neck_path(tree, skull)
    roles = {"chest": chest, "head": neck_path[-1]}
    before = [joint for joint in path[:-1] if tree.lengths[joint] > 0] or path[:-1]
    if before:
        roles["spine"] = before[0]
    if len(neck_path) > 1:
        roles["neck"] = neck_path[0]
    return roles


def _neck_path(tree: _Tree, skull: int) -> list[int]:
    """From the neck to the head: up to a fork (a face), without a tip that never turns."""
    path = [skull]
    while len(below := tree.children.get(path[-1], [])) == 1:
        path.append(below[0])
    if len(path) > 1 and path[-1] in tree.still and path[-2] not in tree.still:
        path.pop()
    return path


def _path_to(tree: _Tree, starts: list[int], end: int) -> list[int]:
    for start in starts:
        if start == end:
            return [start]
        below = _path_to(tree, tree.children.get(start, []), end)
        if below:
            return [start, *below]
    return []


def _long_bones(tree: _Tree, start: int) -> list[int]:
    """The joints of a branch down its longest way, those that only repeat a place left out."""
    chain = [start]
    for joint in _chain(tree, start)[1:]:
        if tree.lengths[joint] > 0:
            chain.append(joint)
        elif len(chain) == 1 or tree.lengths[chain[-1]] == 0:
            chain[-1] = joint
    return chain


def _leg(tree: _Tree, start: int) -> dict[str, int]:
    """Thigh and shin are the two longest bones in a row."""
    chain = _long_bones(tree, start)
    if len(chain) < 3:
        return {}
    bones = tree.lengths[chain]
    first = int(np.argmax(bones[1:-1] + bones[2:]))
    return dict(zip(("thigh", "shin", "foot", "toes"), chain[first:], strict=False))


def _arm(tree: _Tree, start: int) -> dict[str, int]:
    """Upper arm and forearm are the last two long bones; what follows is the hand."""
    chain = _long_bones(tree, start)
    bones = tree.lengths[chain]
    long = np.flatnonzero(bones[1:] >= _FINGER * bones[1:].max(initial=0.0)) + 1
    hand = int(long[-1]) if len(long) else 0
    if hand < 2:
        return {}
    roles = dict(zip(("upper_arm", "forearm", "hand"), chain[hand - 2 :], strict=False))
    return roles | ({"clavicle": chain[hand - 3]} if hand > 2 else {})


def _sides(
    tree: _Tree,
    pose: WorldPose,
    legs: tuple[int, int],
    arms: tuple[int, int],
    trunk: dict[str, int],
) -> list[tuple[str, dict[str, int], dict[str, int]]]:
    """Legs and arms with the side each is on."""
    leg_roles = [_leg(tree, leg) for leg in legs]
    arm_roles = [_arm(tree, arm) for arm in arms]
    if not (all(leg_roles) and all(arm_roles)):
        return []
    if _first_is_left(pose, leg_roles, trunk["head"]) is False:
        leg_roles.reverse()
    if _crossed(pose, leg_roles, arm_roles):
        arm_roles.reverse()
    return list(zip(("left", "right"), leg_roles, arm_roles, strict=True))


def _first_is_left(pose: WorldPose, legs: list[dict[str, int]], head: int) -> bool | None:
    roles = {"head": head}
    for side, leg in zip(("left", "right"), legs, strict=True):
        roles |= {f"{side}_{part}": joint for part, joint in leg.items()}
        if "toes" not in leg:  # without toes, the knees point forward
            roles |= {f"{side}_foot": leg["thigh"], f"{side}_toes": leg["shin"]}
    return is_left(pose, roles)


def _crossed(pose: WorldPose, legs: list[dict[str, int]], arms: list[dict[str, int]]) -> bool:
    hips = pose.positions[:, legs[0]["thigh"]] - pose.positions[:, legs[1]["thigh"]]
    shoulders = pose.positions[:, arms[0]["upper_arm"]] - pose.positions[:, arms[1]["upper_arm"]]
    return bool(np.median(np.sum(hips * shoulders, axis=-1)) < 0)
