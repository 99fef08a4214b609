"""Balls along the bones, with which a viewer shades one limb by another, and the soles."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motion.figure import profile
from motion.figure.body import SIGN, Body, hand_curl
from motion.figure.mesh import Sole, Sphere
from motion.figure.reference import SIDES
from motion.rotations import conjugate, rotate

Array = NDArray[np.float64]

# Where the balls lie: along each limb (fraction of the bone, radius as a fraction of its girth),
# along the foot (fraction of the way to the ball), up the torso (height in the profile, outward,
# radius in metres at the profile's stature).
_THIGH = ((0.12, 0.17), (0.42, 0.165), (0.72, 0.13))
_SHIN = ((0.06, 0.116), (0.42, 0.11), (0.82, 0.08))
_UPPER_ARM = ((0.08, 0.2), (0.45, 0.16), (0.8, 0.13))
_FOREARM = ((0.12, 0.14), (0.5, 0.12), (0.85, 0.09))
_HAND = ((0.3, 0.12), (0.66, 0.11))
_FOOT = (-0.11, 0.5, 1.2)
_TORSO = (
    (-0.03, 0.045, 0.072),
    (0.07, 0.04, 0.078),
    (0.16, 0.04, 0.076),
    (0.26, 0.045, 0.083),
    (0.335, 0.05, 0.068),
)
_TORSO_ROLES = ("hips", "hips", "spine", "chest", "chest")


def occlusion_spheres(body: Body) -> tuple[Sphere, ...]:
    """About forty balls that fill the body, each fixed to the joint that moves its place."""
    found: list[Sphere] = []
    scale = body.trunk.scale
    for (height, outward, radius), role in zip(_TORSO, _TORSO_ROLES, strict=True):
        joint = body.pose.carrier(role, "chest" if role == "spine" else "spine", "hips")
        found += [
            _sphere(body, joint, body.trunk.point(s, (outward, height, 0)), radius * scale, "torso")
            for s in SIDES
        ]
    neck = body.trunk.centre(0.44)
    found.append(_sphere(body, body.pose.carrier("neck", "head"), neck, 0.046 * scale, "head"))
    for up, ahead, radius in ((0.104, -0.012, 0.07), (0.045, 0.02, 0.056)):
        place = body.pose.place("head") + np.array([0.0, up, ahead]) * scale
        found.append(_sphere(body, body.pose.carrier("head"), place, radius * scale, "head"))
    for side in SIDES:
        found += _arm(body, side) + _leg(body, side)
    return tuple(found)


def soles(body: Body) -> tuple[Sole, ...]:
    """The outline of each sole; the part ahead of the ball belongs to the toes."""
    found = []
    for side in SIDES:
        shape = body.feet[side]
        foot = body.pose.carrier(f"{side}_foot")
        toes = body.pose.carrier(f"{side}_toes", f"{side}_foot")
        for joint, rings in ((foot, shape.rings[:7]), (toes, shape.rings[6:])):
            local = [
                (sign * 0.85 * ring.w, 0.0, ring.ahead)
                for sign, order in ((1, 1), (-1, -1))
                for ring in rings[::order]
            ]
            points = _into(body, joint, shape.frame.world(np.array(local)))
            found.append(Sole(joint, tuple((x, y, z) for x, y, z in points.tolist())))
    return tuple(found)


def _arm(body: Body, side: str) -> list[Sphere]:
    limb = body.arms[side]
    size = profile.HAND_LENGTH * limb.girth[1]
    arm = f"{side}_arm"
    balls = [(f"{side}_upper_arm", t * limb.upper, r * limb.girth[0]) for t, r in _UPPER_ARM] + [
        (f"{side}_forearm", limb.upper + t * limb.lower, r * limb.girth[1]) for t, r in _FOREARM
    ]
    hand = body.pose.carrier(f"{side}_hand", f"{side}_forearm")
    found = [
        _sphere(
            body, body.pose.carrier(role), limb.frame.world(np.array([0.0, along, 0.0])), r, arm
        )
        for role, along, r in balls
    ]
    for t, r in _HAND:
        place = limb.end.world(np.array([-hand_curl(t), t, 0.0]) * size)
        found.append(_sphere(body, hand, place, r * size, arm))
    return found


def _leg(body: Body, side: str) -> list[Sphere]:
    limb, leg = body.legs[side], f"{side}_leg"
    balls = [(f"{side}_thigh", t * limb.upper, r * limb.girth[0]) for t, r in _THIGH]
    balls += [(f"{side}_shin", limb.upper + t * limb.lower, r * limb.girth[1]) for t, r in _SHIN]
    found = [
        _sphere(
            body, body.pose.carrier(role), limb.frame.world(np.array([0.0, along, 0.0])), r, leg
        )
        for role, along, r in balls
    ]
    foot, scale = body.feet[side], body.trunk.scale
    aheads, tops = ([ring.ahead for ring in foot.rings], [ring.top for ring in foot.rings])
    for share in _FOOT:
        role = f"{side}_toes" if share > 1.0 else f"{side}_foot"
        joint = body.pose.carrier(role, f"{side}_foot")
        size = min(0.48 * float(np.interp(share * foot.ball, aheads, tops)), 0.034 * scale)
        place = foot.frame.world(np.array([0.0, size, share * foot.ball]))
        found.append(_sphere(body, joint, place, size, leg))
    return found


def _sphere(body: Body, joint: int, place: Array, radius: float, limb: str) -> Sphere:
    x, y, z = _into(body, joint, place[None])[0].tolist()
    return Sphere(joint, (x, y, z), radius, limb)


def _into(body: Body, joint: int, places: Array) -> Array:
    """Places (N, 3) of the bind pose in a joint's own frame."""
    pose = body.pose
    return rotate(conjugate(pose.rotations[joint]), places - pose.positions[joint])


def limb_of_joints(body: Body) -> dict[int, str]:
    """Joint index to limb; a joint without a role goes with its parent."""
    pose = body.pose
    by_role: dict[int, str] = {}
    for role, joint in pose.roles.items():
        side, _, part = role.partition("_")
        if side not in SIGN:
            by_role[joint] = "head" if role in ("neck", "head") else "torso"
        elif part == "clavicle":
            by_role[joint] = "torso"
        else:
            by_role[joint] = f"{side}_{'arm' if part in _ARM_PARTS else 'leg'}"
    found: dict[int, str] = {}
    for joint, parent in enumerate(pose.skeleton.parents.tolist()):
        found[joint] = by_role.get(joint, found.get(parent, "torso"))
    return found


_ARM_PARTS = ("upper_arm", "forearm", "hand")
