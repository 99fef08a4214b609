"""A new motion between examples, by their weights."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motion.blending.example import Example, turned
from motion.blending.feet import BlendedFoot, foot_columns, read_foot
from motion.blending.legs import onto_feet
from motion.blending.sampling import catmull_rom, weighted_sums
from motion.blending.time_warp import common_order, first_event, warped
from motion.clip import Clip
from motion.editing.foot_plants import Foot
from motion.errors import MotionError
from motion.rotations import from_directions, make_continuous

Array = NDArray[np.float64]

_NONE = 1e-9  # a weight below this counts as none


@dataclass(frozen=True, eq=False)
class _Mixture:
    """The examples that take part in a blend.

    Attributes:
        chosen: (A,) which.
        shares: (A,) their weights, of sum 1.
        step: s, the blend's frame time: the shortest of theirs.
        spans: number of steps from frame to frame that come nearest to their mean duration.
    """

    chosen: NDArray[np.intp]
    shares: Array
    step: float
    spans: int


class Blender:
    """Blends of clips that share a skeleton, prepared once.

    Time is warped such that events meet (``warped``); there, joints' direction vectors and the
    places of root, ankles and soles are mixed by the weights, after Rose, Cohen & Bodenheimer
    (1998) and Oshita et al. (4.2). A foot stands in all walks while it stands in the blend, so the
    mean of the feet's places stands too, and hips that are the mean of the examples' hips, seen
    from there, move with the mean of their velocities. The legs are then brought to the feet by
    two-bone inverse kinematics.

    Cycles begin at their left strike and, if they go anywhere, go along +z; the closing frame is
    kept. Of one example all comes back unchanged.

    Args:
        clips: all cyclic or none; the same skeleton.
        keytimes: for each clip, event to seconds; none warps time evenly.

    Raises:
        MotionError: naming the clip (by its place, from 1) that does not fit and what to do.
    """

    def __init__(
        self, clips: Sequence[Clip], keytimes: Sequence[Mapping[str, float]] | None = None
    ) -> None:
        _check(clips, keytimes)
        self.clips = tuple(clips)
        self.skeleton = clips[0].skeleton
        self.cyclic = clips[0].cyclic
        moments: Sequence[Mapping[str, float]] = keytimes or [{} for _ in clips]
        pairs = zip(clips, moments, strict=True)
        anchor = first_event(moments)
        self._examples = [Example.of(clip, own, anchor) for clip, own in pairs]
        self._rows = np.concatenate([example.rows for example in self._examples])
        lengths = [len(example.rows) for example in self._examples]
        self._begin = np.cumsum([0, *lengths[:-1]])
        self._spans = np.array([example.spans for example in self._examples])
        self._travel = np.array([example.travel for example in self._examples])
        self._durations = np.array([clip.duration for clip in clips])
        self._steps = np.array([clip.frame_time for clip in clips])
        self._turned = np.array([example.turned for example in self._examples])
        feet = zip(*(example.feet for example in self._examples), strict=True)
        self._soles = [_offsets(foot) for foot in feet]
        self._order = common_order([example.phases for example in self._examples])
        self._events = self._events_of(range(len(clips)), self._order)
        self._uneven = any(set(e.phases) != set(self._order) for e in self._examples)

    def frames(self, weights: ArrayLike) -> int:
        """Number of frames that a blend would have."""
        return self._mixture(weights).spans + 1

    def keytimes(self, weights: ArrayLike) -> dict[str, float]:
        """Event to seconds from the blend's first frame, of the events that order its time."""
        mixture = self._mixture(weights)
        names, events = self._common(mixture.chosen)
        means = mixture.shares @ events
        moments = (means % 1.0 if self.cyclic else means) * mixture.spans * mixture.step
        return dict(zip(names, moments.tolist(), strict=True))

    def blend(self, weights: ArrayLike) -> Clip:
        """The clip between the examples.

        It has the shortest frame time of the examples that take part, and as many frames as come
        nearest to the weighted mean of their durations.

        Args:
            weights: (N,) not negative, not all 0; only their ratios count.

        Raises:
            MotionError: if the weights are none of that, or rotations cancel each other out.
        """
        mixture = self._mixture(weights)
        when = self._when(mixture)
        mixed = self._sampled(mixture, when)
        gone = when.T @ (mixture.shares[:, None] * self._travel[mixture.chosen])
        own = 6 * len(self.skeleton)
        directions = np.ascontiguousarray(mixed[:, :own]).reshape(len(mixed), -1, 6)
        root = mixed[:, own : own + 3] + gone
        rough = Clip(self.skeleton, root, from_directions(directions), mixture.step)
        feet = self._feet(mixture, mixed[:, own + 3 :], gone)
        return self._finished(mixture, replace(rough, rotations=onto_feet(rough, feet)))

    def _mixture(self, weights: ArrayLike) -> _Mixture:
        weights = np.array(weights, dtype=float)
        if weights.shape != (len(self.clips),):
            raise MotionError(f"{len(self.clips)} clips need as many weights, not {weights.shape}.")
        if not np.isfinite(weights).all() or weights.min() < 0.0 or weights.sum() <= 0.0:
            raise MotionError("Weights must be 0 or more, and one of them above 0.")
        shares = weights / weights.sum()
        chosen = np.flatnonzero(shares > _NONE)
        shares = shares[chosen] / shares[chosen].sum()
        step = float(self._steps[chosen].min())
        duration = float(shares @ self._durations[chosen])
        return _Mixture(chosen, shares, step, max(1, round(duration / step)))

    def _when(self, mixture: _Mixture) -> Array:
        """Share of each example (A, T) that is shown in each frame, without a closing one."""
        at = np.arange(mixture.spans + (not self.cyclic)) / mixture.spans
        _, events = self._common(mixture.chosen)
        return warped(at, events, mixture.shares, cyclic=self.cyclic)

    def _common(self, chosen: NDArray[np.intp]) -> tuple[tuple[str, ...], Array]:
        """Events of the examples that take part, and their shares (A, K).

        Only those that take part count: to leave out an example without weight changes nothing.
        """
        if not self._uneven:
            return self._order, self._events[chosen]
        names = common_order([self._examples[index].phases for index in chosen])
        return names, self._events_of(chosen.tolist(), names)

    def _events_of(self, chosen: Sequence[int], names: tuple[str, ...]) -> Array:
        rows = [[self._examples[index].phases[name] for name in names] for index in chosen]
        return np.array(rows).reshape(len(rows), len(names))

    def _sampled(self, mixture: _Mixture, when: Array) -> Array:
        """(T, C) weighted sum of the examples' rows at their shares (A, T) of time."""
        spans = self._spans[mixture.chosen, None, None]
        places, taps = catmull_rom(when * spans[..., 0])
        # Rows that are no cycle have one more before the first.
        places = places % spans if self.cyclic else np.clip(places + 1, 0, spans + 2)
        places += self._begin[mixture.chosen, None, None]
        return weighted_sums(self._rows, places, mixture.shares[:, None, None] * taps)

    def _feet(self, mixture: _Mixture, columns: Array, gone: Array) -> list[BlendedFoot]:
        feet, start = [], 0
        travel = mixture.shares @ self._travel[mixture.chosen] if self.cyclic else None
        for foot, soles in zip(self._examples[0].feet, self._soles, strict=True):
            width = foot_columns(len(soles))
            offsets = [mixture.shares @ sole[mixture.chosen] for sole in soles]
            part = np.ascontiguousarray(columns[:, start : start + width])
            feet.append(read_foot(foot, offsets, part, gone, travel))
            start += width
        return feet

    def _finished(self, mixture: _Mixture, clip: Clip) -> Clip:
        """The clip with its closing frame, and facing where the examples face in the mean."""
        root, rotations = clip.root_positions, make_continuous(clip.rotations)
        if self.cyclic:
            travel = mixture.shares @ self._travel[mixture.chosen]
            root = np.concatenate([root, root[:1] + travel])
            rotations = np.concatenate([rotations, rotations[:1]])
        facing = float(np.angle(mixture.shares @ np.exp(1j * self._turned[mixture.chosen])))
        return turned(Clip(self.skeleton, root, rotations, clip.frame_time, self.cyclic), facing)


def _offsets(feet: Sequence[Foot]) -> list[Array]:
    """For each point of a foot's sole its place (N, 3) on the examples' feet."""
    points = zip(*(foot.points for foot in feet), strict=True)
    return [np.array([point.offset for point in each]) for each in points]


def _check(clips: Sequence[Clip], keytimes: Sequence[Mapping[str, float]] | None) -> None:
    if not clips:
        raise MotionError("There is no clip to blend.")
    if keytimes is not None and len(keytimes) != len(clips):
        raise MotionError(f"{len(clips)} clips need as many keytimes, not {len(keytimes)}.")
    for place, clip in enumerate(clips[1:], start=2):
        if clip.skeleton.content_hash != clips[0].skeleton.content_hash:
            raise MotionError(
                f"Clip {place} has another skeleton than clip 1: "
                "retarget it onto that skeleton first."
            )
        if clip.cyclic != clips[0].cyclic:
            kinds = ("is a cycle", "is none")
            one, other = kinds if clips[0].cyclic else kinds[::-1]
            raise MotionError(
                f"Clip 1 {one} and clip {place} {other}: cut one cycle out of those that are none."
            )
    names = [set(moments) for moments in keytimes or ()]
    for place in range(2, len(names) + 1):
        if any(names) and not set.intersection(*names[:place]):
            raise MotionError(
                f"Clip {place} has no keytime in common with those before it: "
                "give all clips the same keytimes, or none to any."
            )
