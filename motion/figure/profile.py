"""The body's measures: every ring, ellipsoid and join of the mannequin, as plain data.

Half-widths: ``w`` sideways, ``f`` forward, ``b`` backward; ``x`` outward and ``z`` forward shift of
the centre; ``n`` exponent of the super-ellipse. Limbs: fractions of the bone's own length at ``t``
(0 = near joint). Torso, neck, head and foot: metres at a stature of 1.58 m, torso and neck at a
height above the pelvis joint. The shape is androgynous on purpose: masculine against feminine is
a question that studies ask, so the body must not answer it.
"""

from __future__ import annotations

from typing import NamedTuple

STATURE = 1.58  # metres: the stature at which every length below holds

LEGS_OUT = 13.0  # degrees from the vertical in the bind pose
ARMS_OUT = 46.0


class Ring(NamedTuple):
    """One cross-section of a loft, at ``at`` along its axis."""

    at: float
    w: float
    f: float
    b: float
    x: float = 0.0
    z: float = 0.0
    n: float = 2.0


class FootRing(NamedTuple):
    """One cross-section of the foot, ``ahead`` of the ankle."""

    ahead: float
    w: float
    top: float


class Ellipsoid(NamedTuple):
    """Centre and radii, and the smooth union with what came before."""

    centre: tuple[float, float, float]
    radii: tuple[float, float, float]
    blend: float


# The joints of the body for which the metres below were drawn, at STATURE.
THIGH_LENGTH = 0.3908
SHIN_LENGTH = 0.4098
UPPER_ARM_LENGTH = 0.2433
FOREARM_LENGTH = 0.2229
HIP_HEIGHT = -0.022  # hip joints, relative to the pelvis joint
SHOULDER_HEIGHT = 0.377
HEAD_HEIGHT = 0.475
NECK_HEIGHT = 0.411
HIP_HALF_WIDTH = 0.0647
SHOULDER_HALF_WIDTH = 0.1033

THIGH = (
    Ring(-0.02, 0.166, 0.188, 0.198, z=-0.006),
    Ring(0.14, 0.174, 0.198, 0.198),
    Ring(0.34, 0.169, 0.2, 0.188, z=0.004),
    Ring(0.6, 0.153, 0.172, 0.152, z=0.01),
    Ring(0.82, 0.127, 0.138, 0.124, z=0.008),
    Ring(0.93, 0.121, 0.134, 0.112, z=0.01),
    Ring(1.0, 0.119, 0.132, 0.106, z=0.01),
)
SHIN = (
    Ring(0.08, 0.113, 0.118, 0.11, z=0.004),
    Ring(0.25, 0.119, 0.104, 0.142, z=-0.01),
    Ring(0.4, 0.112, 0.098, 0.136, z=-0.014),
    Ring(0.65, 0.088, 0.086, 0.094, z=-0.014),
    Ring(0.86, 0.074, 0.079, 0.079, z=-0.012),
    Ring(1.0, 0.0735, 0.082, 0.082, z=-0.012),
    Ring(1.09, 0.068, 0.076, 0.072, z=-0.012),
)
UPPER_ARM = (
    Ring(-0.06, 0.19, 0.196, 0.2, x=0.04),
    Ring(0.1, 0.208, 0.216, 0.216, x=0.054),
    Ring(0.26, 0.192, 0.202, 0.196, x=0.04),
    Ring(0.52, 0.152, 0.17, 0.162, x=0.006),
    Ring(0.84, 0.13, 0.138, 0.132),
    Ring(1.0, 0.126, 0.13, 0.128),
)
FOREARM = (
    Ring(0.1, 0.14, 0.15, 0.138),
    Ring(0.24, 0.146, 0.156, 0.142),
    Ring(0.46, 0.128, 0.138, 0.13),
    Ring(0.76, 0.094, 0.108, 0.104),
    Ring(1.0, 0.078, 0.102, 0.1),
)

HAND_LENGTH = 0.72  # of the forearm; the hand's rings and thumb are fractions of it
HAND = (
    Ring(0.08, 0.092, 0.142, 0.142),
    Ring(0.26, 0.093, 0.194, 0.194, z=0.01),
    Ring(0.44, 0.088, 0.208, 0.208, z=0.008),
    Ring(0.6, 0.08, 0.204, 0.204),
    Ring(0.74, 0.073, 0.19, 0.19, z=-0.006),
    Ring(0.84, 0.07, 0.171, 0.171, z=-0.01),
    Ring(0.91, 0.065, 0.144, 0.144, z=-0.012),
    Ring(0.96, 0.058, 0.114, 0.114, z=-0.014),
    Ring(0.99, 0.05, 0.087, 0.087, z=-0.015),
    Ring(1.01, 0.041, 0.063, 0.063, z=-0.015),
    Ring(1.02, 0.033, 0.045, 0.045, z=-0.015),
)
HAND_EXPONENT = 2.5  # fuller than an ellipse: the edge of the palm is soft
HAND_CURL = (0.42, 0.2, 1.7)  # the centre moves a·max(0, t − b)^c toward the palm
# Toward the palm, up (so negative is toward the fingers), toward the thumb's side.
THUMB = ((0.02, -0.1, 0.06), (0.075, -0.34, 0.24), (0.135, -0.62, 0.285))
THUMB_RADII = (0.088, 0.072, 0.054)

ANKLE_HEIGHT = 0.117
TOE_AHEAD = 0.0895
FOOT = (
    FootRing(-0.034, 0.0338, 0.082),
    FootRing(-0.026, 0.0348, 0.0855),
    FootRing(-0.006, 0.0365, 0.114),
    FootRing(0.018, 0.0355, 0.106),
    FootRing(0.042, 0.0375, 0.084),
    FootRing(0.07, 0.0425, 0.066),
    FootRing(0.096, 0.0455, 0.053),
    FootRing(0.122, 0.0445, 0.044),
    FootRing(0.146, 0.0395, 0.038),
    FootRing(0.16, 0.0345, 0.034),
    FootRing(0.171, 0.027, 0.03),
    FootRing(0.178, 0.021, 0.027),
)
FOOT_EXPONENT = 2.2
SOLE_EDGE = 0.012  # the heel, half an ellipsoid behind the first ring, is 2.2 of them long

# Below its first ring the torso ends in half an ellipsoid, which thighs meet without a crease.
PELVIS_DEPTH = 0.135
TORSO = (
    Ring(0.035, 0.116, 0.083, 0.09, z=-0.004, n=2.2),
    Ring(0.095, 0.1165, 0.083, 0.082, n=2.2),
    Ring(0.16, 0.1165, 0.083, 0.079, z=0.002, n=2.15),
    Ring(0.23, 0.123, 0.089, 0.088, z=0.001, n=2.15),
    Ring(0.29, 0.133, 0.094, 0.097, z=-0.002, n=2.15),
    Ring(0.33, 0.129, 0.088, 0.094, z=-0.006, n=2.1),
    Ring(0.36, 0.112, 0.074, 0.082, z=-0.009),
    Ring(0.386, 0.084, 0.056, 0.064, z=-0.012),
    Ring(0.408, 0.056, 0.04, 0.046, z=-0.014),
)
NECK = (
    Ring(0.38, 0.052, 0.049, 0.054, z=-0.016),
    Ring(0.42, 0.0485, 0.047, 0.049, z=-0.013),
    Ring(0.46, 0.0465, 0.0455, 0.047, z=-0.008),
    Ring(0.5, 0.046, 0.046, 0.046, z=-0.004),
    Ring(0.535, 0.046, 0.046, 0.048, z=-0.004),
)
# Mirrored pairs: centre and radii, in the pelvis joint's frame.
BACK = Ellipsoid((0.066, 0.297, -0.04), (0.054, 0.085, 0.044), 0.06)
SEAT = Ellipsoid((0.053, -0.046, -0.042), (0.06, 0.08, 0.052), 0.08)
SHOULDER_FROM = (0.018, NECK_HEIGHT - 0.014, -0.016)
SHOULDER_RADII = (0.03, 0.038)

HEAD_SHIFT = 0.018  # up from the head joint
HEAD = (
    Ellipsoid((0, 0.086, -0.012), (0.065, 0.073, 0.085), 0.0),
    Ellipsoid((0, 0.04, 0.026), (0.0515, 0.074, 0.0585), 0.065),
    Ellipsoid((0, 0.008, 0.008), (0.0455, 0.032, 0.044), 0.045),
    Ellipsoid((0, -0.014, 0.046), (0.026, 0.022, 0.026), 0.05),
)
RIDGE = ((0, 0.078, 0.073), (0, 0.037, 0.0795))
RIDGE_RADII = (0.0056, 0.0074)

# Radius of each smooth union, metres.
BLEND_NECK = 0.045
BLEND_HEAD = 0.03
BLEND_SHOULDER = 0.075
BLEND_ARM = 0.048
BLEND_LEG = 0.064
BLEND_LEGS = 0.06
BLEND_FOOT = 0.034
BLEND_HAND = 0.016
BLEND_RIDGE = 0.022

# Skinning: how fast a part's share fades with distance, and where one joint hands over to the
# next, metres relative to the joint (torso: above it; limbs: along the bone).
FADE_TORSO = 0.016
FADE_HEAD = 0.008
FADE_LEG = 0.02
FADE_ARM = 0.014
SPINE_BANDS = {
    "spine": (-0.107, 0.043),
    "chest": (-0.037, 0.063),
    "neck": (-0.016, 0.034),
    "head": (-0.007, 0.045),
}
KNEE_BAND = (-0.055, 0.055)
ELBOW_BAND = (-0.04, 0.04)
WRIST_BAND = (-0.022, 0.016)
ANKLE_BAND = (0.15, 0.07)  # height above the sole: all shin above the first, all foot below
TOE_BAND = (-0.028, 0.022)
CROTCH_BELOW = 0.055  # under the hip joints: where the thighs' inner roots begin to follow the hips
CROTCH_DEPTH = 0.1
CROTCH_WIDTH = 0.05
CROTCH_SHARE = 0.85
YOKE_SHARE = 0.35  # of the upper arm's root, turning with the shoulder girdle
YOKE_REACH = 0.4  # of the upper arm's length
