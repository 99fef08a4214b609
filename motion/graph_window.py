"""Short stretches of clips as point clouds, and how well two of them fit onto each other."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.kinematics import end_site_positions, forward_kinematics

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

_SAMPLES = 5  # frames of a window that are compared
_VELOCITY = 0.15  # s: what a metre a second counts, in metres


@dataclass(frozen=True, eq=False)
class Windows:
    """All windows of a clip.

    Attributes:
        level: (N, K) forward + i·left of each window's points about their middle, then of their
            velocities.
        upright: (N, K) heights and vertical velocities.
        middle: (N,) forward + i·left, the middle of each window's points.
        points: number of points of a window.
        cyclic: windows wrap around.
    """

    level: Complex
    upright: Array
    middle: Complex
    points: int
    cyclic: bool

    @property
    def count(self) -> int:
        """Number N of windows; each begins at the frame of its own number."""
        return len(self.middle)

    @classmethod
    def of(cls, clip: Clip, frames: int) -> Windows:
        """The windows of so many frames of a clip."""
        count = clip.frames - 1 if clip.cyclic else clip.frames - frames
        if count <= 0:
            empty = np.zeros((0, 1), dtype=np.complex128)
            return cls(empty, np.zeros((0, 1)), empty[:, 0], 1, clip.cyclic)
        places = _points(clip, frames)
        velocities = _VELOCITY * np.gradient(places, clip.frame_time, axis=0)
        samples = np.round(np.linspace(0, frames, _SAMPLES)).astype(int)
        rows = np.arange(count)[:, None] + samples
        position = places[rows].reshape(count, -1, 3)
        velocity = velocities[rows].reshape(count, -1, 3)
        flat = _flat(position)
        middle = flat.sum(axis=1) / flat.shape[1]
        return cls(
            level=np.hstack([flat - middle[:, None], _flat(velocity)]),
            upright=np.hstack([position[..., 1], velocity[..., 1]]),
            middle=middle,
            points=position.shape[1],
            cyclic=clip.cyclic,
        )

    def distances(self, other: Windows) -> Array:
        """(N, M) m, between each window and each of the other's, fitted onto it.

        Turning z′ by θ leaves |z|² + |z′|² − 2·Re(e^(−iθ)·⟨z, z′⟩), least where the last term is
        the product's magnitude.
        """
        level = _squares(self.level)[:, None] + _squares(other.level)
        level -= 2.0 * np.abs(self.level @ other.level.conj().T)
        upright = _squares(self.upright)[:, None] + _squares(other.upright)
        upright -= 2.0 * self.upright @ other.upright.T
        return np.sqrt(np.maximum(level + upright, 0.0) / self.points)

    def distance(self, other: Windows, here: int, there: int) -> float:
        """m, between one window and one of the other's, fitted onto it."""
        one, two = (
            replace(w, level=w.level[i : i + 1], upright=w.upright[i : i + 1])
            for w, i in ((self, here), (other, there))
        )
        return float(one.distances(two)[0, 0])

    def alignment(self, other: Windows, here: int, there: int) -> tuple[float, tuple[float, float]]:
        """Turn (rad about the vertical) and shift (x, z) that fit the other's window onto ours."""
        match = np.vdot(other.level[there], self.level[here])
        turn = float(np.angle(match))
        shift = complex(self.middle[here] - np.exp(1j * turn) * other.middle[there])
        return turn, (shift.imag, shift.real)


def frames_of(clip: Clip, start: int, stop: int) -> tuple[Array, Array]:
    """Root positions (n, 3) and rotations (n, J, 4) of frames start … stop − 1.

    A cyclic clip goes on after its end, and each cycle where the one before ended.
    """
    index = np.arange(start, stop)
    if not clip.cyclic:
        return clip.root_positions[start:stop], clip.rotations[start:stop]
    cycle, frame = np.divmod(index, clip.frames - 1)
    return clip.root_positions[frame] + cycle[:, None] * clip.travel, clip.rotations[frame]


def _points(clip: Clip, frames: int) -> Array:
    """World positions (T′, P, 3) of joints and tips; of a cyclic clip beyond its end."""
    longer = clip
    if clip.cyclic:
        root, rotations = frames_of(clip, 0, clip.frames + frames)
        longer = Clip(clip.skeleton, root, rotations, clip.frame_time)
    pose = forward_kinematics(longer)
    return np.concatenate([pose.positions, end_site_positions(clip.skeleton, pose)], axis=1)


def _flat(points: Array) -> Complex:
    """Points (..., 3) seen from above, as forward + i·left."""
    seen: Complex = points[..., 2] + 1j * points[..., 0]
    return seen


def _squares(values: Complex | Array) -> Array:
    return np.sum(np.abs(values) ** 2, axis=1)
