"""One stride of a walk, ready to loop."""

from __future__ import annotations

import numpy as np

from motion.clip import Clip
from motion.procedural.bodies import Body
from motion.procedural.channels import walking_channels
from motion.procedural.feet import foot_path
from motion.procedural.plan import LEFT, RIGHT, cycle_frames, plan_cycle
from motion.procedural.pose import build_clip
from motion.procedural.style import Style


def walk_cycle(style: Style, body: Body) -> Clip:
    """One stride from left contact to left contact, at 60 frames a second, walking along +z.

    The closing frame is the first one exactly, moved forward by the stride.
    """
    plan = plan_cycle(style, body)
    feet = (foot_path(plan, style, body, LEFT), foot_path(plan, style, body, RIGHT))
    clip = build_clip(plan, style, body, walking_channels(plan, style), feet)
    frames = cycle_frames(style)
    middle = slice(frames, 2 * frames + 1)
    root, rotations = clip.root_positions[middle].copy(), clip.rotations[middle].copy()
    root[:, 2] -= root[0, 2]
    root[-1] = root[0] + np.array([0.0, 0.0, style.stride * body.leg_length])
    rotations[-1] = rotations[0]
    return Clip(clip.skeleton, root, rotations, clip.frame_time, cyclic=True)
