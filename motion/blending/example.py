"""A clip made ready to be blended: begun at its left strike, headed for +z, its feet known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from motion.blending.feet import firmness
from motion.clip import Clip
from motion.editing.cycles import three_cycles
from motion.editing.foot_plants import SIDES, Foot, find_feet
from motion.errors import MotionError
from motion.graph_window import frames_of
from motion.kinematics import forward_kinematics
from motion.rotations import from_axis_angle, multiply, rotate, to_directions
from motion.units import heading, overall_heading

Array = NDArray[np.float64]

_UP = np.array([0.0, 1.0, 0.0])
_GOING = 0.2  # m a cycle: whoever goes less far has no heading but their body's
_LEG = ("thigh", "shin", "foot")


@dataclass(frozen=True, eq=False)
class Example:
    """A clip as signals over its frames.

    Attributes:
        clip: as it was given.
        rows: (F, C) for each frame: six direction vectors' components of each joint, the root's
            place and, for each foot, those of ``sole_rows``. Places are less the even travel. Of a
            cycle without its closing frame; otherwise with one frame more before and after.
        phases: event to share of the clip, ascending.
        travel: (3,) m, taken out of the places.
        turned: rad about the vertical that the blend is to be turned back by.
        feet: the feet with their contact points; none for a body without legs.
    """

    clip: Clip
    rows: Array
    phases: Mapping[str, float]
    travel: Array
    turned: float
    feet: tuple[Foot, ...]

    @property
    def spans(self) -> int:
        """Number of steps from frame to frame."""
        return self.clip.frames - 1

    @classmethod
    def of(cls, clip: Clip, keytimes: Mapping[str, float], anchor: str | None) -> Example:
        """A clip with its keytimes, begun at one of them; what was made is remembered.

        Raises:
            MotionError: if the clip has no two frames or a keytime is not within it.
        """
        return _prepared(clip, tuple(sorted(keytimes.items())), anchor)


@lru_cache(maxsize=256)
def _prepared(clip: Clip, keytimes: tuple[tuple[str, float], ...], anchor: str | None) -> Example:
    if clip.frames < 2:
        raise MotionError("A clip of a single frame cannot be blended.")
    for name, moment in keytimes:
        if not 0.0 <= moment <= clip.duration:
            raise MotionError(
                f"The {name.replace('_', ' ')} at {moment:g} s is not within the clip, "
                f"0 to {clip.duration:.3f} s."
            )
    start = 0
    if clip.cyclic and anchor is not None:
        start = round(dict(keytimes)[anchor] / clip.frame_time) % (clip.frames - 1)
    begun = _begun_at(clip, start)
    aligned, turned = _aligned(begun)
    feet = _feet(aligned)
    rows = _signals(aligned, feet)
    if not clip.cyclic:
        rows = np.vstack([2.0 * rows[:1] - rows[1:2], rows, 2.0 * rows[-1:] - rows[-2:-1]])
    phases = {name: moment / clip.duration for name, moment in keytimes}
    if clip.cyclic:
        phases = _from(phases, start / (clip.frames - 1), anchor)
    ordered = dict(sorted(phases.items(), key=lambda item: item[1]))
    travel = aligned.travel if clip.cyclic else np.zeros(3)
    return Example(clip, rows, ordered, travel, turned, feet)


def _begun_at(clip: Clip, frame: int) -> Clip:
    """The cycle from another frame on, where it would be had it begun there at the same place."""
    if frame == 0:
        return clip
    root, rotations = frames_of(clip, frame, frame + clip.frames)
    root = root - clip.travel * (frame / (clip.frames - 1))
    return replace(clip, root_positions=root, rotations=rotations)


def _from(phases: Mapping[str, float], start: float, anchor: str | None) -> dict[str, float]:
    """Shares of a cycle that begins at another share, within half a frame of the anchor.

    An anchor between two frames keeps its place there, just before 0 or after: so a blend's frames
    are frames of an example that is alone.
    """
    shifted = {name: (phase - start) % 1.0 for name, phase in phases.items()}
    if anchor is not None and shifted[anchor] > 0.5:
        shifted[anchor] -= 1.0
    return shifted


def _aligned(clip: Clip) -> tuple[Clip, float]:
    """The clip turned about its start to go, or else to face, along +z; and the turn to restore."""
    x, _, z = clip.travel
    going = clip.cyclic and np.hypot(x, z) >= _GOING
    if going:
        angle = float(np.arctan2(x, z))
    else:
        pose = forward_kinematics(clip)
        angle, _ = overall_heading(heading(pose, clip.skeleton.roles), clip.frame_time)
    return turned(clip, -angle), 0.0 if going else angle


def turned(clip: Clip, angle: float) -> Clip:
    """The clip turned about the vertical through its first root position, by rad."""
    if angle == 0.0:
        return clip
    turn, start = from_axis_angle(_UP, angle), clip.root_positions[0]
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    root = start + rotate(turn, clip.root_positions - start)
    return replace(clip, root_positions=root, rotations=rotations)


def _feet(clip: Clip) -> tuple[Foot, ...]:
    """The feet with the points of their soles; none for a body without legs."""
    roles = clip.skeleton.roles
    if any(f"{side}_{part}" not in roles for side in SIDES for part in _LEG):
        return ()
    return find_feet(three_cycles(clip) if clip.cyclic else clip)


def _signals(clip: Clip, feet: tuple[Foot, ...]) -> Array:
    """(F, C) rows; see ``Example``."""
    count = clip.frames - 1 if clip.cyclic else clip.frames
    travel = clip.travel if clip.cyclic else np.zeros(3)
    gone = np.linspace(0.0, 1.0, clip.frames)[:, None] * travel
    pose = forward_kinematics(clip)
    columns = [to_directions(clip.rotations).reshape(clip.frames, -1), clip.root_positions - gone]
    for foot in feet:
        ankle = pose.positions[:, foot.ankle] - gone
        about = ankle - ankle[:count].mean(axis=0)
        columns += [ankle, np.sum(about**2, axis=1, keepdims=True)]
        columns += [to_directions(pose.rotations[:, foot.ankle])]
        soles = [point.positions(pose) for point in foot.points]
        columns += [np.min(soles, axis=0)[:, 1:2]]
        for places in soles:
            share = np.zeros((clip.frames, 1))
            share[:count, 0] = firmness(
                places[:count], clip.travel if clip.cyclic else None, clip, foot.side
            )
            steps = np.diff(places, axis=0, append=places[-1:]) * (clip.frames - 1)
            columns += [share, share * steps[:, [0, 2]]]
    return np.ascontiguousarray(np.hstack(columns)[:count])
