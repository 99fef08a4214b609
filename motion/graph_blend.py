"""From one clip into another: where it is put on the floor, and the cross-fade between them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from motion.clip import Clip
from motion.editing.foot_plants import ContactPoint, find_feet
from motion.errors import MotionError
from motion.graph_window import Windows, frames_of
from motion.kinematics import pose_to_world
from motion.rotations import from_axis_angle, from_directions, multiply, rotate, to_directions

Array = NDArray[np.float64]
Frames = tuple[Array, Array]  # root positions (n, 3), rotations (n, J, 4)

_UP = np.array([0.0, 1.0, 0.0])
_LEVEL = np.array([1.0, 0.0, 1.0])
_SOFT = 0.04  # s, standard deviation: how softly a foot is taken for standing


@dataclass(frozen=True)
class Placement:
    """Where on the floor a clip is played.

    Attributes:
        turn: rad about the vertical.
        shift: (x, z) m, after the turn.
    """

    turn: float = 0.0
    shift: tuple[float, float] = (0.0, 0.0)

    def then(self, turn: float, shift: tuple[float, float]) -> Placement:
        """Where the target of a transition is played, if its source is played here."""
        x, _, z = self.place(np.array([shift[0], 0.0, shift[1]]))
        return Placement(self.turn + turn, (float(x), float(z)))

    def moved(self, way: Array) -> Placement:
        """Moved on by (3,) m, as the world has it."""
        return Placement(self.turn, (self.shift[0] + float(way[0]), self.shift[1] + float(way[2])))

    def apply(self, frames: Frames) -> Frames:
        """The frames, moved there."""
        positions, rotations = frames
        moved = rotations.copy()
        moved[:, 0] = multiply(from_axis_angle(_UP, self.turn), rotations[:, 0])
        return self.place(positions), moved

    def place(self, points: Array) -> Array:
        """Points (..., 3), moved there."""
        shift = np.array([self.shift[0], 0.0, self.shift[1]])
        return rotate(from_axis_angle(_UP, self.turn), points) + shift


def fit(
    source: Clip, leave: int, target: Clip, enter: int, fade: int
) -> tuple[float, tuple[float, float]]:
    """Turn (rad) and shift (x, z) that fit the target from one frame on onto the source from one.

    The frames of a cyclic clip may lie beyond its end.
    """
    one, here = _window(source, leave, fade)
    other, there = _window(target, enter, fade)
    return one.alignment(other, here, there)


def _window(clip: Clip, frame: int, fade: int) -> tuple[Windows, int]:
    # One frame more at both sides, where there is one, for the velocities at the ends.
    start = frame - 1 if clip.cyclic else max(frame - 1, 0)
    stop = frame + fade + 2 if clip.cyclic else min(frame + fade + 2, clip.frames)
    short = Clip(clip.skeleton, *frames_of(clip, start, stop), clip.frame_time)
    return Windows.of(short, fade), frame - start


@dataclass(frozen=True, eq=False)
class Side:
    """One of two clips that go over into each other.

    Attributes:
        clip, frame: what is played from that frame on.
        placement: where on the floor.
    """

    clip: Clip
    frame: int
    placement: Placement

    def frames(self, count: int) -> Frames:
        """So many frames, the first of them one before its own; a clip's last frame is held."""
        clip = self.clip
        start, stop = self.frame - 1, self.frame - 1 + count
        if clip.cyclic:
            return self.placement.apply(frames_of(clip, start, stop))
        index = np.clip(np.arange(start, stop), 0, clip.frames - 1)
        return self.placement.apply((clip.root_positions[index], clip.rotations[index]))

    def planted(self, standing: Array, count: int) -> Array:
        """Values (T,) at the frames after the first of those."""
        index = np.arange(self.frame, self.frame + count)
        last = self.clip.frames - 1
        return standing[index % last if self.clip.cyclic else np.minimum(index, last)]


def blend(old: Side, new: Side, fade: int) -> tuple[Frames, Placement]:
    """The ``fade`` frames in which one clip goes over into another, and where that is played then.

    The hips are carried along such that the feet on the floor stay there: a blend of two plants
    in different places would slide from the one to the other.
    """
    before, after = old.frames(fade + 2), new.frames(fade + 2)
    t = np.linspace(0.0, 1.0, fade + 2)
    share = t * t * (3.0 - 2.0 * t)  # no corner at either end
    first, last = to_directions(before[1]), to_directions(after[1])
    rotations = from_directions(first + share[:, None, None] * (last - first))
    roots = before[0] + share[:, None] * (after[0] - before[0])
    slip, total = np.zeros((fade + 1, 3)), np.zeros(fade + 1)
    mixed = pose_to_world(old.clip.skeleton, roots, rotations)
    for side, own, part in ((old, before, 1.0 - share[1:]), (new, after, share[1:])):
        alone = pose_to_world(side.clip.skeleton, *own)
        for point, standing in _support(side.clip):
            weight = part * side.planted(standing, fade + 1)
            slid = point.positions(mixed) - point.positions(alone)
            slip += weight[:, None] * np.diff(slid, axis=0)
            total += weight
    way = -np.cumsum(slip / np.maximum(total, 1.0)[:, None], axis=0) * _LEVEL
    return (roots[1:-1] + way[:-1], rotations[1:-1]), new.placement.moved(way[-1])


@lru_cache(maxsize=64)
def _support(clip: Clip) -> tuple[tuple[ContactPoint, Array], ...]:
    """The points of both soles and how much (T,) each stands; none on a body without legs."""
    try:
        feet = find_feet(clip)
    except MotionError:
        return ()
    width = _SOFT / clip.frame_time
    mode: Literal["wrap", "nearest"] = "wrap" if clip.cyclic else "nearest"
    return tuple(
        (point, np.asarray(gaussian_filter1d(planted.astype(float), width, mode=mode)))
        for foot in feet
        for point, planted in zip(foot.points, foot.planted, strict=True)
    )
