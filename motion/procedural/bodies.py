"""Three bodies that differ in stature and proportions.

Segment lengths are rounded shares of the stature in the range of anthropometric tables (Winter,
Biomechanics and Motor Control of Human Movement); widths are round values of our own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from motion.skeleton import EndSite, Skeleton

SIDES = (("left", 1.0), ("right", -1.0))  # the left side is +x when the body faces +z


@dataclass(frozen=True)
class Body:
    """Proportions in metres.

    Attributes:
        name: "female", "male" or "adult".
        stature: floor to crown.
        leg: floor to hip joint, as a share of the stature.
        hip_half: half the distance of the hip joints.
        shoulder_half: half the distance of the shoulder joints.
    """

    name: str
    stature: float
    leg: float
    hip_half: float
    shoulder_half: float

    @property
    def leg_length(self) -> float:
        """Thigh + shin + height of the ankle, metres."""
        return self.leg * self.stature

    @property
    def ankle_height(self) -> float:
        """Floor to ankle joint with the sole flat, metres."""
        return 0.052 * self.stature

    @property
    def thigh(self) -> float:
        """Hip to knee, metres."""
        return 0.512 * (self.leg_length - self.ankle_height)

    @property
    def shin(self) -> float:
        """Knee to ankle, metres."""
        return self.leg_length - self.ankle_height - self.thigh

    @property
    def foot(self) -> Foot:
        """The sole's outline."""
        return Foot(
            ankle=self.ankle_height,
            heel=-0.030 * self.stature,
            ball=0.064 * self.stature,
            ball_height=0.018 * self.stature,
            tip=0.104 * self.stature,
        )


@dataclass(frozen=True)
class Foot:
    """Side view of a flat foot, metres; distances ahead of the ankle, heights above the floor."""

    ankle: float
    heel: float
    ball: float
    ball_height: float
    tip: float


BODIES = {
    body.name: body
    for body in (
        Body("adult", stature=1.72, leg=0.535, hip_half=0.080, shoulder_half=0.147),
        Body("female", stature=1.65, leg=0.538, hip_half=0.083, shoulder_half=0.134),
        Body("male", stature=1.79, leg=0.533, hip_half=0.080, shoulder_half=0.164),
    )
}


def build_skeleton(body: Body) -> Skeleton:
    """The body in a T-pose with identity rotations: y up, facing +z, left towards +x."""
    joints = _trunk(body)
    tips: list[tuple[str, tuple[float, float, float]]] = [
        ("head", (0.0, 0.112 * body.stature, 0.0))
    ]
    for side, sign in SIDES:
        joints += _arm(body, side, sign) + _leg(body, side, sign)
        tips.append((f"{side}_hand", (sign * 0.105 * body.stature, 0.0, 0.0)))
        foot = body.foot
        tips.append((f"{side}_toes", (0.0, -foot.ball_height, foot.tip - foot.ball)))
    names = tuple(name for name, _, _ in joints)
    index = {name: i for i, name in enumerate(names)}
    return Skeleton(
        names=names,
        parents=np.array([index.get(parent, -1) for _, parent, _ in joints], dtype=np.intp),
        offsets=np.array([offset for _, _, offset in joints]),
        end_sites=tuple(EndSite(index[name], offset) for name, offset in tips),
        roles=index,
    )


_Joint = tuple[str, str, tuple[float, float, float]]


def _trunk(body: Body) -> list[_Joint]:
    above_hips = body.stature - body.leg_length
    return [
        ("hips", "", (0.0, body.leg_length, 0.0)),
        ("spine", "hips", (0.0, 0.135 * above_hips, -0.008)),
        ("chest", "spine", (0.0, 0.195 * above_hips, -0.004)),
        ("neck", "chest", (0.0, 0.290 * above_hips, -0.006)),
        ("head", "neck", (0.0, 0.143 * above_hips, 0.018)),
    ]


def _arm(body: Body, side: str, sign: float) -> list[_Joint]:
    above_hips = body.stature - body.leg_length
    inner = 0.016 * body.stature
    return [
        (f"{side}_clavicle", "chest", (sign * inner, 0.255 * above_hips, 0.012)),
        (
            f"{side}_upper_arm",
            f"{side}_clavicle",
            (sign * (body.shoulder_half - inner), -0.010 * above_hips, -0.016),
        ),
        (f"{side}_forearm", f"{side}_upper_arm", (sign * 0.163 * body.stature, 0.0, 0.0)),
        (f"{side}_hand", f"{side}_forearm", (sign * 0.143 * body.stature, 0.0, 0.0)),
    ]


def _leg(body: Body, side: str, sign: float) -> list[_Joint]:
    foot = body.foot
    return [
        (f"{side}_thigh", "hips", (sign * body.hip_half, 0.0, 0.0)),
        (f"{side}_shin", f"{side}_thigh", (0.0, -body.thigh, 0.0)),
        (f"{side}_foot", f"{side}_shin", (0.0, -body.shin, 0.0)),
        (f"{side}_toes", f"{side}_foot", (0.0, foot.ball_height - foot.ankle, foot.ball)),
    ]
