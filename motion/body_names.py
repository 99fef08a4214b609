"""Body roles from joint names, in the conventions that capture and modelling programs use."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from motion.skeleton import Skeleton

_WORD = re.compile(r"[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+|\d+")
_SIDES = {
    "left": "left", "l": "left", "lft": "left", "lt": "left",
    "right": "right", "r": "right", "rgt": "right", "rt": "right",
}  # fmt: skip
# What rigs put before or after every name.
_NOISE = re.compile(
    "bip|biped|mixamorig|j|jt|jnt|joint|c|cc|b|bone|m|def|org|bind|skel|skin|hik|character|avatar|valve"
)

# Words for a role, the surest first: "shoulder" is an upper arm only where nothing else is.
_LIMBS: dict[str, tuple[str, ...]] = {
    "upper_arm": (
        "upperarm",
        "uparm",
        "shldr",
        "shldrbend",
        "upperarmbend",
        "humerus",
        "arm",
        "shoulder",
    ),
    "forearm": (
        "forearm",
        "lowerarm",
        "lowarm",
        "forearmbend",
        "lowerarmbend",
        "elbow",
        "radius",
        "ulna",
    ),
    "hand": ("wrist", "hand", "palm"),
    "clavicle": ("clavicle", "collar", "collarbone", "clavicula", "scapula", "shoulder"),
    "thigh": ("upleg", "upperleg", "thigh", "thighbend", "uplegbend", "femur", "hip", "hipjoint"),
    "shin": ("shin", "calf", "lowerleg", "lowleg", "shinbend", "knee", "tibia", "leg"),
    "foot": ("ankle", "foot", "heel"),
    "toes": ("toebase", "toes", "toe", "ball", "metatarsals", "forefoot", "foot"),
}
_CENTRES: dict[str, tuple[str, ...]] = {
    "hips": ("hips", "pelvis", "hip", "root"),
    "neck": ("neck", "neckbase", "necklower", "lowerneck"),
    "head": ("head", "skull"),
}
_SIDED = frozenset(word for words in _LIMBS.values() for word in words)


@dataclass(frozen=True)
class _Name:
    """A joint's name taken apart: side or None, the words run together, the first number in it."""

    side: str | None
    stem: str
    number: int


def roles_by_name(skeleton: Skeleton) -> dict[str, int]:
    """Roles that the names tell; a role is left out where no name fits."""
    names = [_take_apart(name) for name in skeleton.names]
    roles: dict[str, int] = {}
    for role, words in _CENTRES.items():
        _assign(roles, role, names, None, words)
    for side in ("left", "right"):
        for part, words in _LIMBS.items():
            _assign(roles, f"{side}_{part}", names, side, words)
    _assign_spine(roles, skeleton, names)
    return roles


def _take_apart(name: str) -> _Name:
    words = [word.lower() for word in _WORD.findall(name.rpartition(":")[2])]
    number = next((int(word) for word in words if word.isdigit()), 0)
    words = [word for word in words if not word.isdigit()]
    side = next((_SIDES[word] for word in words if word in _SIDES), None)
    kept = [word for word in words if word not in _SIDES and not _NOISE.fullmatch(word)]
    if words[:2] == ["cc", "base"]:
        kept = kept[1:]
    stem = "hipjoint" if words[-2:] == ["hip", "joint"] else "".join(kept)
    if side is None:
        side, stem = _side_of_stem(stem)
    return _Name(side, stem, number)


def _side_of_stem(stem: str) -> tuple[str | None, str]:
    """A side written without a gap, as in ``rthigh`` or ``leftupleg``."""
    for prefix, side in (("left", "left"), ("right", "right"), ("l", "left"), ("r", "right")):
        if stem.startswith(prefix) and stem[len(prefix) :] in _SIDED:
            return side, stem[len(prefix) :]
    return None, stem


def _assign(
    roles: dict[str, int], role: str, names: list[_Name], side: str | None, words: tuple[str, ...]
) -> None:
    taken = set(roles.values())
    for word in words:
        found = [
            (name.number, index)
            for index, name in enumerate(names)
            if name.side == side and name.stem == word and index not in taken
        ]
        if found:
            roles[role] = min(found)[1]
            return


def _assign_spine(roles: dict[str, int], skeleton: Skeleton, names: list[_Name]) -> None:
    """The first and the last joint between hips and neck that have a length behind them."""
    end = roles.get("neck", roles.get("head"))
    if end is None or "hips" not in roles:
        return
    lengths = np.linalg.norm(skeleton.offsets, axis=-1)
    tiny = 1e-3 * lengths.max(initial=0.0)
    path = []
    joint = int(skeleton.parents[end])
    while joint > roles["hips"]:
        if names[joint].side is None:
            path.append(joint)
        joint = int(skeleton.parents[joint])
    if joint != roles["hips"] or not path:
        return
    arms = [roles[role] for role in ("left_upper_arm", "right_upper_arm") if role in roles]
    below = [joint for joint in path if all(skeleton.hangs_from(arm, joint) for arm in arms)]
    path = below or path  # the chest is where the arms leave the spine
    roles["chest"] = path[0]
    if len(path) > 1:
        solid = [index for index in reversed(path[1:]) if lengths[index] > tiny]
        roles["spine"] = solid[0] if solid else path[-1]
