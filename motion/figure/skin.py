"""Which joints carry each vertex, and how much."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from motion.figure import profile
from motion.figure.body import Body
from motion.figure.reference import SIDES

Array = NDArray[np.float64]

INFLUENCES = 4
_FADES = {
    "torso": profile.FADE_TORSO,
    "head": profile.FADE_HEAD,
    "yoke": profile.FADE_TORSO,
    "arm": profile.FADE_ARM,
    "leg": profile.FADE_LEG,
}


@dataclass
class _Shares:
    """Weights being summed up, by joint."""

    table: Array
    body: Body = field(repr=False)

    def add(self, share: Array, *roles: str) -> None:
        """Give a share to the joint of the first role that the skeleton has."""
        self.table[:, self.body.pose.carrier(*roles)] += share


def skin_weights(body: Body, points: Array) -> tuple[NDArray[np.intp], Array]:
    """Joints (V, 4), strongest first, and their weights (V, 4), sum 1, of points (V, 3)."""
    shares = _Shares(np.zeros((len(points), len(body.pose.skeleton))), body)
    parts = _part_shares(body, points)
    _add_torso(shares, parts["torso"], points)
    shares.add(parts["head"], "head")
    for side in SIDES:
        shares.add(parts[f"{side}_yoke"], f"{side}_clavicle", "chest", "spine", "hips")
        _add_arm(shares, parts[f"{side}_arm"], points, side)
        _add_leg(shares, parts[f"{side}_leg"], points, side)
    return _strongest(shares.table)


def _strongest(table: Array) -> tuple[NDArray[np.intp], Array]:
    if table.shape[1] < INFLUENCES:
        table = np.pad(table, ((0, 0), (0, INFLUENCES - table.shape[1])))
    joints = np.argsort(-table, axis=1, kind="stable")[:, :INFLUENCES]
    weights = np.take_along_axis(table, joints, axis=1)
    weights = weights / weights.sum(axis=1, keepdims=True)
    weights[weights < 1.0 / 255.0] = 0.0
    return np.where(weights > 0, joints, 0), weights / weights.sum(axis=1, keepdims=True)


def _part_shares(body: Body, points: Array) -> dict[str, Array]:
    """Each part's share of every vertex: it fades with the distance beyond the nearest part."""
    names = list(body.parts)
    fades = np.array([_FADES[name.rpartition("_")[2]] for name in names]) * body.trunk.scale
    distances = np.stack([body.parts[name].distance(points) for name in names])
    raw = np.exp(-(distances - distances.min(axis=0)) / fades[:, None])
    raw /= raw.sum(axis=0)
    return dict(zip(names, raw, strict=True))


def smoothstep(low: float, high: float, values: Array) -> Array:
    """0 at ``low``, 1 at ``high`` (which may be the smaller), smooth between."""
    share = np.clip((values - low) / (high - low), 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)


def _band(middle: float, band: tuple[float, float], scale: float, values: Array) -> Array:
    return smoothstep(middle + band[0] * scale, middle + band[1] * scale, values)


def _add_torso(shares: _Shares, share: Array, points: Array) -> None:
    body = shares.body
    scale = body.trunk.scale
    drawn = body.trunk.drawn_height(points[:, 1])
    rises = []
    for role in ("spine", "chest", "neck", "head"):
        band = profile.SPINE_BANDS[role]
        if role in ("neck", "head"):
            middle = profile.NECK_HEIGHT if role == "neck" else profile.HEAD_HEIGHT
            rises.append(_band(middle, band, 1.0, drawn))
        elif role in body.pose.roles:
            rises.append(_band(float(body.pose.place(role)[1]), band, scale, points[:, 1]))
        else:
            rises.append(np.zeros(len(points)) if role == "spine" else rises[-1])
    spine, chest, neck, head = rises
    shares.add(share * (1 - np.maximum(spine, chest)) * (1 - neck), "hips")
    shares.add(share * np.maximum(spine - chest, 0) * (1 - neck), "spine", "hips")
    shares.add(share * chest * (1 - neck), "chest", "spine", "hips")
    shares.table[:, _neck_joint(body)] += share * neck * (1 - head)
    shares.add(share * neck * head, "head")


def _neck_joint(body: Body) -> int:
    """The last joint below the head: where a neck has several, it carries most of the turn."""
    roles, parents = body.pose.roles, body.pose.skeleton.parents
    above = int(parents[roles["head"]])
    if above < 0 or "neck" not in roles:
        return roles.get("neck", roles["head"])
    joint = above
    while joint >= 0 and joint != roles["neck"]:
        joint = int(parents[joint])
    return above if joint >= 0 else roles["neck"]


def _add_arm(shares: _Shares, share: Array, points: Array, side: str) -> None:
    body = shares.body
    limb, scale = body.arms[side], body.trunk.scale
    along = limb.frame.local(points)[:, 1]
    elbow = _band(limb.upper, profile.ELBOW_BAND, scale, along)
    wrist = _band(limb.upper + limb.lower, profile.WRIST_BAND, scale, along)
    yoke = profile.YOKE_SHARE * (1 - smoothstep(0.0, profile.YOKE_REACH * limb.upper, along))
    shares.add(share * yoke, f"{side}_clavicle", "chest", "spine", "hips")
    shares.add(share * (1 - yoke) * (1 - elbow), f"{side}_upper_arm")
    shares.add(share * (1 - yoke) * elbow * (1 - wrist), f"{side}_forearm")
    shares.add(share * (1 - yoke) * wrist, f"{side}_hand", f"{side}_forearm")


def _inner_root(body: Body, points: Array) -> Array:
    """Share of the hips in the thighs' inner roots, so that the crotch does not fold."""
    scale = body.trunk.scale
    middle = body.trunk.found[0]
    away = np.abs(points[:, 0] - middle[0])
    below = middle[1] - points[:, 1] - profile.CROTCH_BELOW * scale
    near = 1 - smoothstep(0.2 * profile.CROTCH_WIDTH * scale, profile.CROTCH_WIDTH * scale, away)
    high = 1 - smoothstep(0.0, profile.CROTCH_DEPTH * scale, below)
    return profile.CROTCH_SHARE * near * high


def _add_leg(shares: _Shares, share: Array, points: Array, side: str) -> None:
    body = shares.body
    limb, scale = body.legs[side], body.trunk.scale
    along = limb.frame.local(points)[:, 1]
    knee = _band(limb.upper, profile.KNEE_BAND, scale, along)
    foot = body.feet[side].frame.local(points)
    height = float((limb.end.origin - body.feet[side].frame.origin)[1])
    high, low = (value * height / profile.ANKLE_HEIGHT for value in profile.ANKLE_BAND)
    ankle = smoothstep(high, low, foot[:, 1])
    toes = _band(body.feet[side].ball, profile.TOE_BAND, scale, foot[:, 2])
    inner = _inner_root(body, points)
    shares.add(share * inner, "hips")
    shares.add(share * (1 - inner) * (1 - knee), f"{side}_thigh")
    shares.add(share * knee * (1 - ankle), f"{side}_shin")
    shares.add(share * knee * ankle * (1 - toes), f"{side}_foot")
    shares.add(share * knee * ankle * toes, f"{side}_toes", f"{side}_foot")
