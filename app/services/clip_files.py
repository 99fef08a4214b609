"""From a clip to what the library keeps of it. Computing only: no database."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from motion import Clip, MotionError
from motion.figure import build_figure
from motion.glb import write_clip_glb, write_figure_glb
from motion.kinematics import end_site_positions, forward_kinematics
from motion.storage import clip_to_bytes
from motion.units import standing_height


@dataclass(frozen=True)
class ClipFiles:
    """A clip's content hash, measures and files.

    Attributes:
        stature: metres; poster_time: second of the frame that shows most.
        clip: the lossless clip; glb: what the viewer plays.
    """

    id: str
    skeleton_hash: str
    frames: int
    frame_time: float
    duration: float
    cyclic: bool
    stature: float
    poster_time: float
    clip: bytes
    glb: bytes


def make_files(clip: Clip, stature: float | None = None) -> ClipFiles:
    """All files of one clip; its stature is measured unless it is known."""
    return ClipFiles(
        id=clip.content_hash,
        skeleton_hash=clip.skeleton.content_hash,
        frames=clip.frames,
        frame_time=clip.frame_time,
        duration=clip.duration,
        cyclic=clip.cyclic,
        stature=measure_stature(clip) if stature is None else stature,
        poster_time=poster_time(clip),
        clip=clip_to_bytes(clip),
        glb=write_clip_glb(clip),
    )


def make_figure(clip: Clip) -> bytes | None:
    """The GLB of the mannequin for the clip's skeleton; none for one that lacks a body's parts."""
    try:
        return write_figure_glb(build_figure(clip))
    except MotionError:
        return None


def poster_time(clip: Clip) -> float:
    """Second of the widest stride in the middle half: the frame that best shows a walk."""
    roles = clip.skeleton.roles
    if not {"left_foot", "right_foot"} <= set(roles):
        return clip.duration / 2
    positions = forward_kinematics(clip).positions
    between = positions[:, roles["left_foot"]] - positions[:, roles["right_foot"]]
    start, end = clip.frames // 4, max(clip.frames * 3 // 4, clip.frames // 4 + 1)
    widest = start + int(np.argmax(np.linalg.norm(between[start:end], axis=1)))
    return widest * clip.frame_time


def measure_stature(clip: Clip) -> float:
    """Metres that a clip's body is tall, whatever it does.

    Without the body roles for that, from its lowest to its highest point at its most upright.
    """
    pose = forward_kinematics(clip)
    if height := standing_height(clip, pose):
        return height
    tips = end_site_positions(clip.skeleton, pose)
    heights = np.concatenate([pose.positions[..., 1], tips[..., 1]], axis=1)
    return float(np.max(np.ptp(heights, axis=1)))
