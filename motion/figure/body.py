"""The parts of the body as shapes around a bind pose."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.figure import profile
from motion.figure.bind import BindPose
from motion.figure.field import (
    Above,
    EllipsoidShape,
    Frame,
    Loft,
    RoundCone,
    Shape,
    Union,
    foot_loft,
)
from motion.figure.profile import FootRing, Ring
from motion.figure.reference import SIDES
from motion.rotations import rotate

Array = NDArray[np.float64]

SIGN = {"left": 1.0, "right": -1.0}


@dataclass(frozen=True, eq=False)
class Limb:
    """An arm's or a leg's frame: x outward, y down the bones, z forward; lengths in metres.

    Attributes:
        frame: at the near joint.
        upper: length of the near bone.
        lower: length of the far bone.
        girth: what the profile's fractions are multiplied with, for the near and the far bone.
    """

    frame: Frame
    upper: float
    lower: float
    girth: tuple[float, float]

    @property
    def end(self) -> Frame:
        """The same axes at wrist or ankle."""
        return Frame(
            self.frame.world(np.array([0.0, self.upper + self.lower, 0.0])), self.frame.axes
        )


@dataclass(frozen=True, eq=False)
class Foot:
    """A foot's frame on its sole, under the ankle: x left, y up, z forward.

    Attributes:
        frame: see above.
        rings: its cross-sections, metres.
        ball: how far the ball lies ahead of the ankle, metres.
    """

    frame: Frame
    rings: tuple[FootRing, ...]
    ball: float

    @property
    def tip(self) -> float:
        """How far the toes' end lies ahead of the ankle, metres."""
        return self.rings[-1].ahead


@dataclass(frozen=True, eq=False)
class Trunk:
    """From the profile's heights to a skeleton's: hips, shoulders and head lie where they lie.

    Attributes:
        drawn: (3,) the landmarks' heights in the profile.
        found: (3, 3) their places on this skeleton.
        extra: (2,) metres by which hips and shoulders are wider (a side) than the profile's.
        scale: stature over the profile's.
    """

    drawn: Array
    found: Array
    extra: Array
    scale: float

    def centre(self, height: float) -> Array:
        """(3,) place on the body's middle line at one of the profile's heights."""
        place = np.array([np.interp(height, self.drawn, self.found[:, axis]) for axis in range(3)])
        beyond = height - np.clip(height, self.drawn[0], self.drawn[-1])
        place[1] += self.scale * beyond
        return place

    def drawn_height(self, heights: Array) -> Array:
        """(N,) the profile's heights of places at ``heights`` (N,) on this skeleton."""
        inside = np.interp(heights, self.found[:, 1], self.drawn)
        beyond = heights - np.clip(heights, self.found[0, 1], self.found[-1, 1])
        return inside + beyond / self.scale

    def widen(self, height: float) -> float:
        """Metres to add to a half-width at one of the profile's heights, less toward the neck."""
        hips, shoulders = self.extra
        stops = [self.drawn[0], 0.3, 0.36, 0.41]
        return float(np.interp(height, stops, [hips, shoulders, 0.7 * shoulders, 0.2 * shoulders]))

    def point(self, side: str, place: Sequence[float]) -> Array:
        """(3,) where a mirrored detail (outward, height, forward) of the profile lies."""
        outward, height, ahead = place
        result = self.centre(height)
        result[0] += SIGN[side] * (outward * self.scale + 0.6 * self.widen(height))
        result[2] += ahead * self.scale
        return result


@dataclass(frozen=True, eq=False)
class Body:
    """The body's parts and their union.

    Attributes:
        whole: the seamless body.
        parts: by name: torso, head, and left_ and right_ yoke, arm, leg.
        arms: by side.
        legs: by side.
        feet: by side.
        trunk: heights.
        pose: the bind pose that it stands in.
    """

    whole: Shape
    parts: dict[str, Shape]
    arms: dict[str, Limb]
    legs: dict[str, Limb]
    feet: dict[str, Foot]
    trunk: Trunk
    pose: BindPose


def make_body(pose: BindPose) -> Body:
    """The body around a bind pose."""
    trunk = _trunk(pose)
    arms = {side: _arm(pose, side) for side in SIDES}
    legs = {side: _leg(pose, side) for side in SIDES}
    feet = {side: _foot(pose, side) for side in SIDES}
    parts: dict[str, Shape] = {}
    for side in SIDES:
        parts[f"{side}_yoke"] = _shoulder(trunk, pose, side)
        parts[f"{side}_arm"] = _arm_shape(arms[side])
        parts[f"{side}_leg"] = _leg_shape(legs[side], feet[side], trunk, side)
    parts["torso"] = _torso(trunk)
    parts["head"] = _head(pose)
    return Body(_joined(parts, pose.scale), parts, arms, legs, feet, trunk, pose)


def _joined(parts: dict[str, Shape], scale: float) -> Shape:
    """Legs and arms are united among themselves first, then with the torso: thighs never web."""
    legs = Union(parts["left_leg"], (parts["right_leg"], profile.BLEND_LEGS * scale))
    arms = Union(parts["left_arm"], (parts["right_arm"], 0.0))
    return Union(
        parts["torso"],
        (Union(parts["left_yoke"], (parts["right_yoke"], 0.0)), profile.BLEND_SHOULDER * scale),
        (arms, profile.BLEND_ARM * scale),
        (legs, profile.BLEND_LEG * scale),
        (parts["head"], profile.BLEND_HEAD * scale),
    )


def _trunk(pose: BindPose) -> Trunk:
    left, right = ([pose.place(f"{s}_{p}") for p in ("thigh", "upper_arm")] for s in SIDES)
    middles = (np.array(left) + np.array(right)) / 2.0
    found = np.stack([*middles, pose.place("head")])
    # A head joint below the shoulders would fold the neck; keep the landmarks in order.
    found[:, 1] = np.maximum.accumulate(found[:, 1] + np.array([0.0, -0.02, -0.04])) + np.array(
        [0.0, 0.02, 0.04]
    )
    half = (np.array(left) - np.array(right))[:, 0] / 2.0
    usual = np.array([profile.HIP_HALF_WIDTH, profile.SHOULDER_HALF_WIDTH]) * pose.scale
    extra = np.clip((half - usual) * np.array([0.9, 0.7]), -0.03 * pose.scale, 0.055 * pose.scale)
    drawn = np.array([profile.HIP_HEIGHT, profile.SHOULDER_HEIGHT, profile.HEAD_HEIGHT])
    return Trunk(drawn, found, extra, pose.scale)


def _arm(pose: BindPose, side: str) -> Limb:
    shoulder, elbow = pose.place(f"{side}_upper_arm"), pose.place(f"{side}_forearm")
    upper = float(np.linalg.norm(elbow - shoulder))
    drawn = profile.UPPER_ARM_LENGTH, profile.FOREARM_LENGTH
    if f"{side}_hand" in pose.roles:
        lower = float(np.linalg.norm(pose.place(f"{side}_hand") - elbow))
    else:
        lower = upper * drawn[1] / drawn[0]
    return _limb(shoulder, elbow, (upper, lower), drawn, side)


def _leg(pose: BindPose, side: str) -> Limb:
    hip, knee, ankle = (pose.place(f"{side}_{part}") for part in ("thigh", "shin", "foot"))
    lengths = float(np.linalg.norm(knee - hip)), float(np.linalg.norm(ankle - knee))
    return _limb(hip, knee, lengths, (profile.THIGH_LENGTH, profile.SHIN_LENGTH), side)


def _limb(
    near: Array, middle: Array, lengths: tuple[float, float], drawn: tuple[float, float], side: str
) -> Limb:
    along = (middle - near) / lengths[0]
    ahead = np.array([0.0, 0.0, 1.0])
    ahead = ahead - (ahead @ along) * along
    ahead = ahead / np.linalg.norm(ahead)
    outward = SIGN[side] * np.cross(ahead, along)
    frame = Frame(near, np.stack([outward, along, ahead], axis=1))
    # Girth follows the whole limb, so that both bones meet in one knee whatever their lengths.
    share = sum(lengths) / sum(drawn)
    return Limb(frame, *lengths, (drawn[0] * share, drawn[1] * share))


def _limb_rings(limb: Limb, upper: Sequence[Ring], lower: Sequence[Ring]) -> list[Ring]:
    rings = []
    for source, start, length, girth in (
        (upper, 0.0, limb.upper, limb.girth[0]),
        (lower, limb.upper, limb.lower, limb.girth[1]),
    ):
        rings += [_scaled(ring, start + ring.at * length, girth) for ring in source]
    return rings


def _scaled(ring: Ring, at: float, girth: float) -> Ring:
    w, f, b, x, z = (value * girth for value in ring[1:6])
    return Ring(at, w, f, b, x, z, ring.n)


def _arm_shape(limb: Limb) -> Shape:
    """Upper arm, forearm and hand are one loft, so that no seam marks the wrist."""
    size = profile.HAND_LENGTH * limb.girth[1]
    rings = _limb_rings(limb, profile.UPPER_ARM, profile.FOREARM)
    wrist = limb.upper + limb.lower
    for ring in profile.HAND:
        curled = ring._replace(x=-hand_curl(ring.at), n=profile.HAND_EXPONENT)
        rings.append(_scaled(curled, wrist + ring.at * size, size))
    caps = 0.8 * rings[0].w, 0.3 * rings[-1].b
    arm = Loft(limb.frame, rings, caps, soften=0.027 * limb.girth[1])
    joints = [
        limb.end.world(np.array([-inward, -up, ahead]) * size)
        for inward, up, ahead in profile.THUMB
    ]
    radii = [radius * size for radius in profile.THUMB_RADII]
    blend = profile.BLEND_HAND * size / (profile.HAND_LENGTH * profile.FOREARM_LENGTH)
    thumb = Union(
        RoundCone(joints[0], joints[1], (radii[0], radii[1])),
        (RoundCone(joints[1], joints[2], (radii[1], radii[2])), 0.4 * blend),
    )
    return Union(arm, (thumb, blend))


def hand_curl(at: float) -> float:
    """How far a hand's middle lies toward the palm, both in hand lengths."""
    amount, start, power = profile.HAND_CURL
    return float(amount * max(0.0, at - start) ** power)


def _leg_shape(limb: Limb, foot: Foot, trunk: Trunk, side: str) -> Shape:
    rings = _limb_rings(limb, profile.THIGH, profile.SHIN)
    leg = Loft(limb.frame, rings, (1.5 * rings[0].w, 0.6 * rings[-1].w), 0.014 * trunk.scale)
    seat = EllipsoidShape(
        Frame(trunk.point(side, profile.SEAT.centre), np.eye(3)),
        np.zeros(3),
        np.array(profile.SEAT.radii) * trunk.scale,
    )
    edge = profile.SOLE_EDGE * trunk.scale
    sole = foot_loft(foot.frame, foot.rings, profile.FOOT_EXPONENT, edge)
    joined = Union(
        leg, (seat, profile.SEAT.blend * trunk.scale), (sole, profile.BLEND_FOOT * trunk.scale)
    )
    return Above(joined, foot.frame, edge)


def _foot(pose: BindPose, side: str) -> Foot:
    ankle = pose.place(f"{side}_foot")
    # One floor for both soles, even where one leg is a little longer.
    ankles = [float(pose.place(f"{each}_foot")[1]) for each in SIDES]
    floor = float(np.mean(ankles) - np.mean(list(pose.ankle_height.values())))
    height = float(ankle[1]) - floor
    ahead = profile.TOE_AHEAD * pose.scale
    if f"{side}_toes" in pose.roles:
        found = float((pose.place(f"{side}_toes") - ankle)[2])
        ahead = float(np.clip(found, 0.8 * ahead, 1.25 * ahead))
    frame = Frame(ankle - np.array([0.0, height, 0.0]), np.eye(3))
    toes = _toe_stretch(pose, side) * pose.scale
    lift = height / profile.ANKLE_HEIGHT
    rings = tuple(
        FootRing(
            min(r.ahead, profile.TOE_AHEAD) * ahead / profile.TOE_AHEAD
            + max(r.ahead - profile.TOE_AHEAD, 0.0) * toes,
            r.w * pose.scale,
            r.top * lift,
        )
        for r in profile.FOOT
    )
    return Foot(frame, rings, ahead)


def _toe_stretch(pose: BindPose, side: str) -> float:
    """Length of the toes over the profile's, from the skeleton's own tip where it has one."""
    joint = pose.roles.get(f"{side}_toes", -1)
    tips = [np.array(s.offset) for s in pose.skeleton.end_sites if s.joint == joint]
    if not tips:
        return 1.0
    length = float(rotate(pose.rotations[joint], tips[0])[2])
    usual = (profile.FOOT[-1].ahead - profile.TOE_AHEAD) * pose.scale
    return float(np.clip(length / usual, 0.75, 1.15)) if length > 0.3 * usual else 1.0


def _torso(trunk: Trunk) -> Shape:
    shape = _trunk_loft(trunk, profile.TORSO, profile.PELVIS_DEPTH)
    backs = [
        EllipsoidShape(
            Frame(trunk.point(side, profile.BACK.centre), np.eye(3)),
            np.zeros(3),
            np.array(profile.BACK.radii) * trunk.scale,
        )
        for side in SIDES
    ]
    neck = _trunk_loft(trunk, profile.NECK, 0.015)
    return Union(
        shape,
        (Union(backs[0], (backs[1], 0.0)), profile.BACK.blend * trunk.scale),
        (neck, profile.BLEND_NECK * trunk.scale),
    )


def _trunk_loft(trunk: Trunk, source: Sequence[Ring], below: float) -> Loft:
    rings = []
    for ring in source:
        centre = trunk.centre(ring.at)
        sized = _scaled(ring, float(centre[1]), trunk.scale)
        wide = sized.w + (trunk.widen(ring.at) if source is profile.TORSO else 0.0)
        rings.append(
            sized._replace(w=wide, x=sized.x + float(centre[0]), z=sized.z + float(centre[2]))
        )
    return Loft(
        Frame(np.zeros(3), np.eye(3)),
        rings,
        (below * trunk.scale, 0.5 * rings[-1].f),
        0.016 * trunk.scale,
    )


def _shoulder(trunk: Trunk, pose: BindPose, side: str) -> Shape:
    start = trunk.point(side, profile.SHOULDER_FROM)
    joint = pose.place(f"{side}_upper_arm")
    end = joint - np.array([SIGN[side] * 0.02, 0.004, 0.0]) * trunk.scale
    # Wide shoulders need a stronger slope from the neck, or they stand out like pads.
    more = 0.2 * max(float(trunk.extra[1]), 0.0)
    first, second = (radius * trunk.scale + more for radius in profile.SHOULDER_RADII)
    return RoundCone(start, end, (first, second))


def _head(pose: BindPose) -> Shape:
    scale = pose.scale
    origin = pose.place("head") + np.array([0.0, profile.HEAD_SHIFT * scale, 0.0])
    frame = Frame(origin, np.eye(3))
    shapes = [
        (
            EllipsoidShape(frame, np.array(e.centre) * scale, np.array(e.radii) * scale),
            e.blend * scale,
        )
        for e in profile.HEAD
    ]
    ends = [frame.world(np.array(place) * scale) for place in profile.RIDGE]
    first, second = profile.RIDGE_RADII
    ridge = RoundCone(ends[0], ends[1], (first * scale, second * scale))
    return Union(shapes[0][0], *shapes[1:], (ridge, profile.BLEND_RIDGE * scale))
