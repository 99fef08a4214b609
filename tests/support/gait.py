"""Gait measures of a looping clip, each from world positions alone.

The definitions are those under which the published ranges are given: phase from the contact of the
own foot, a foot in contact while a point of its sole is below 3 cm and slow, angles of thigh and
upper arm against the vertical along the line of travel, hips as the middle of the hip joints.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from motion.clip import Clip
from motion.kinematics import end_site_positions, forward_kinematics
from motion.procedural.bodies import Body
from motion.rotations import rotate

SIDES = {"left": 1.0, "right": -1.0}


@dataclass(frozen=True)
class Gait:
    """A clip and the body that it was made for."""

    clip: Clip
    body: Body

    @cached_property
    def world(self):
        return forward_kinematics(self.clip)

    @cached_property
    def tips(self):
        joints = [site.joint for site in self.clip.skeleton.end_sites]
        tips = end_site_positions(self.clip.skeleton, self.world)
        return {self.clip.skeleton.names[j]: tips[:, i] for i, j in enumerate(joints)}

    def at(self, role: str):
        return self.world.positions[:, self.clip.skeleton.roles[role]]

    def turn(self, role: str):
        return self.world.rotations[:, self.clip.skeleton.roles[role]]

    def sole(self, side: str):
        """(3, T, 3) heel, ball and tip of the toes on the underside."""
        foot = self.body.foot
        ankle, turn = self.at(f"{side}_foot"), self.turn(f"{side}_foot")
        heel = ankle + rotate(turn, np.array([0.0, -foot.ankle, foot.heel]))
        # The ball's pad belongs to the toes: it stays on the floor while the heel rises.
        pad = np.array([0.0, -foot.ball_height, 0.0])
        ball = self.at(f"{side}_toes") + rotate(self.turn(f"{side}_toes"), pad)
        return np.stack([heel, ball, self.tips[f"{side}_toes"]])

    def velocity(self, values):
        """Central differences over the loop, per second; the last frame repeats the first."""
        if not self.clip.cyclic:
            return np.gradient(values, self.clip.frame_time, axis=-2)
        gain = values[..., -1:, :] - values[..., :1, :]
        wrapped = np.concatenate(
            [values[..., -2:-1, :] - gain, values, values[..., 1:2, :] + gain], axis=-2
        )
        return (wrapped[..., 2:, :] - wrapped[..., :-2, :]) / (2.0 * self.clip.frame_time)

    def down(self, side: str):
        """(3, T) which sole points are on the ground: below 3 cm and slow."""
        sole = self.sole(side)
        speed = np.linalg.norm(self.velocity(sole), axis=-1)
        return (sole[..., 1] < 0.03) & (speed < 0.35)

    def stance(self, side: str):
        """(T,) whether the foot carries."""
        return self.down(side).any(axis=0)

    def contact(self, side: str) -> int:
        """The frame at which the foot is set down."""
        carries = self.stance(side)[:-1]
        starts = np.flatnonzero(carries & ~np.roll(carries, 1))
        assert len(starts) == 1, f"{side} foot is set down {len(starts)} times in one stride"
        return int(starts[0])

    def from_contact(self, side: str, values):
        """Values (T,) of the loop turned so that they begin at the contact of ``side``."""
        return np.roll(values[:-1], -self.contact(side))

    # --- steps

    @property
    def cadence(self) -> float:
        return 120.0 / self.clip.duration

    @property
    def stride(self) -> float:
        """In legs."""
        return float(self.clip.travel[2]) / self.body.leg_length

    @property
    def speed(self) -> float:
        return float(self.clip.travel[2]) / self.clip.duration

    @property
    def stance_share(self) -> float:
        """% of the cycle, mean of both feet."""
        return 50.0 * sum(self.stance(side)[:-1].mean() for side in SIDES)

    @property
    def double_support(self) -> float:
        """% of the cycle with both feet down minus % with none."""
        return 2.0 * self.stance_share - 100.0

    @property
    def step_width(self) -> float:
        """cm between the ankles sideways, each in its mid-stance."""
        sides = [
            float(np.median(self.at(f"{side}_foot")[:-1][self.stance(side)[:-1], 0]))
            for side in SIDES
        ]
        return 100.0 * (sides[0] - sides[1])

    @property
    def toe_clearance(self) -> float:
        """cm, the lowest that the toes' tip comes in the middle half of swing."""
        lowest = []
        for side in SIDES:
            height = self.from_contact(side, self.sole(side)[2, :, 1])
            swing = np.flatnonzero(~self.from_contact(side, self.stance(side)))
            quarter = len(swing) // 4
            lowest.append(height[swing[quarter:-quarter]].min())
        return 100.0 * float(min(lowest))

    # --- hips

    @cached_property
    def hips(self):
        return (self.at("left_thigh") + self.at("right_thigh")) / 2.0

    @property
    def bounce(self) -> float:
        return 100.0 * float(np.ptp(self.hips[:, 1]))

    @property
    def sway(self) -> float:
        return 100.0 * float(np.ptp(self.hips[:, 0]))

    def yaw(self, left: str, right: str):
        """(T,) degrees, left side forward, of the line between two joints."""
        line = self.at(left) - self.at(right)
        return np.degrees(np.arctan2(line[:, 2], line[:, 0]))

    @property
    def pelvis_yaw(self):
        return self.yaw("left_thigh", "right_thigh")

    @property
    def shoulder_yaw(self):
        return self.yaw("left_upper_arm", "right_upper_arm")

    @property
    def pelvis_roll(self):
        line = self.at("left_thigh") - self.at("right_thigh")
        return np.degrees(np.arctan2(line[:, 1], np.hypot(line[:, 0], line[:, 2])))

    @property
    def lean(self) -> float:
        """Degrees that the line from hips to neck leans forward of standing, mean."""
        line = self.at("neck") - self.hips
        chain = [self.clip.skeleton.roles[role] for role in ("spine", "chest", "neck")]
        rest = self.clip.skeleton.offsets[chain].sum(axis=0)
        angle = np.arctan2(line[:, 2], line[:, 1]) - np.arctan2(rest[2], rest[1])
        return float(np.degrees(angle).mean())

    @property
    def head_pitch(self):
        """(T,) degrees, nose down."""
        gaze = rotate(self.turn("head"), np.array([0.0, 0.0, 1.0]))
        return np.degrees(-np.arcsin(gaze[:, 1]))

    # --- limbs

    def forward_angle(self, near: str, far: str):
        """(T,) degrees that a bone points forward of straight down."""
        bone = self.at(far) - self.at(near)
        return np.degrees(np.arctan2(bone[:, 2], -bone[:, 1]))

    def bend(self, near: str, middle: str, far: str):
        """(T,) degrees between two bones; straight is 0."""
        first, second = self.at(middle) - self.at(near), self.at(far) - self.at(middle)
        dot = np.sum(first * second, axis=-1)
        return np.degrees(np.arctan2(np.linalg.norm(np.cross(first, second), axis=-1), dot))

    def thigh(self, side: str):
        return self.forward_angle(f"{side}_thigh", f"{side}_shin")

    def knee(self, side: str):
        return self.bend(f"{side}_thigh", f"{side}_shin", f"{side}_foot")

    def arm(self, side: str):
        return self.forward_angle(f"{side}_upper_arm", f"{side}_forearm")

    def elbow(self, side: str):
        return self.bend(f"{side}_upper_arm", f"{side}_forearm", f"{side}_hand")

    def foot_pitch(self, side: str):
        """(T,) degrees, toes up; 0 flat."""
        along = rotate(self.turn(f"{side}_foot"), np.array([0.0, 0.0, 1.0]))
        return np.degrees(np.arcsin(along[:, 1]))

    @property
    def arm_swing(self) -> float:
        return float(np.mean([np.ptp(self.arm(side)) for side in SIDES]))

    @property
    def wrist_outside(self) -> float:
        """cm that the wrist hangs outside the hip joint, mean."""
        return 100.0 * float(
            np.mean(
                [
                    sign * (self.at(f"{side}_hand") - self.at(f"{side}_thigh"))[:, 0]
                    for side, sign in SIDES.items()
                ]
            )
        )

    def hand_jerk(self) -> float:
        """Mean jerk of the wrists against the hips, m/s³."""
        jerk = []
        for side in SIDES:
            way = self.at(f"{side}_hand") - self.hips
            for _ in range(3):
                way = self.velocity(way)
            jerk.append(np.linalg.norm(way, axis=-1).mean())
        return float(np.mean(jerk))
