"""A new motion between examples, by their weights."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_array

from motion.blending.example import Example, turned
from motion.blending.feet import BlendedFoot, read_foot
from motion.blending.legs import onto_feet
from motion.blending.time_warp import common_order, first_event, warped
from motion.clip import Clip
from motion.errors import MotionError
from motion.rotations import from_directions, make_continuous

Array = NDArray[np.float64]

_NONE = 1e-9  # a weight below this counts as none


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
        # For each foot and point of its sole, the examples' offsets (N, 3).
        self._soles = [
            [
                np.array([p.offset for p in point])
                for point in zip(*(f.points for f in foot), strict=True)
            ]
            for foot in feet
        ]
        self._order = common_order([example.phases for example in self._examples])
        self._events = self._events_of(range(len(clips)), self._order)
        self._uneven = any(set(e.phases) != set(self._order) for e in self._examples)

    def frames(self, weights: ArrayLike) -> int:
        """Number of frames that a blend would have."""
        return self._spans_of(*self._chosen(weights)) + 1

    def keytimes(self, weights: ArrayLike) -> dict[str, float]:
        """Event to seconds from the blend's first frame, of the events that order its time."""
        chosen, shares = self._chosen(weights)
        names, events = self._common(chosen)
        frames = self._spans_of(chosen, shares)
        duration = frames * float(self._steps[chosen].min())
        means = (shares @ events) % 1.0 if self.cyclic else shares @ events
        return dict(zip(names, (means * duration).tolist(), strict=True))

    def blend(self, weights: ArrayLike) -> Clip:
        """The clip between the examples.

        It has the shortest frame time of the examples that take part, and as many frames as come
        nearest to the weighted mean of their durations.

        Args:
            weights: (N,) not negative, not all 0; only their ratios count.

        Raises:
            MotionError: if the weights are none of that, or rotations cancel each other out.
        """
        chosen, shares = self._chosen(weights)
        frames = self._spans_of(chosen, shares)
        at = np.arange(frames if self.cyclic else frames + 1) / frames
        _, events = self._common(chosen)
        when = warped(at, events, shares, cyclic=self.cyclic)
        mixed = self._sampled(chosen, shares, when)
        gone = when.T @ (shares[:, None] * self._travel[chosen])
        joints = len(self.skeleton)
        directions = np.ascontiguousarray(mixed[:, : 6 * joints]).reshape(-1, joints, 6)
        rotations = from_directions(directions)
        root = mixed[:, 6 * joints : 6 * joints + 3] + gone
        feet = self._feet(chosen, shares, mixed[:, 6 * joints + 3 :], gone)
        step = float(self._steps[chosen].min())
        if feet:
            rotations = onto_feet(Clip(self.skeleton, root, rotations, step), feet)
        rotations = make_continuous(rotations)
        if self.cyclic:
            travel = shares @ self._travel[chosen]
            root = np.concatenate([root, root[:1] + travel])
            rotations = np.concatenate([rotations, rotations[:1]])
        clip = Clip(self.skeleton, root, rotations, step, self.cyclic)
        return turned(clip, float(np.angle(shares @ np.exp(1j * self._turned[chosen]))))

    def _chosen(self, weights: ArrayLike) -> tuple[NDArray[np.intp], Array]:
        weights = np.array(weights, dtype=float)
        if weights.shape != (len(self.clips),):
            raise MotionError(f"{len(self.clips)} clips need as many weights, not {weights.shape}.")
        if not np.isfinite(weights).all() or weights.min() < 0.0 or weights.sum() <= 0.0:
            raise MotionError("Weights must be 0 or more, and one of them above 0.")
        shares = weights / weights.sum()
        chosen = np.flatnonzero(shares > _NONE)
        return chosen, shares[chosen] / shares[chosen].sum()

    def _spans_of(self, chosen: NDArray[np.intp], shares: Array) -> int:
        duration = float(shares @ self._durations[chosen])
        return max(1, round(duration / float(self._steps[chosen].min())))

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

    def _sampled(self, chosen: NDArray[np.intp], shares: Array, when: Array) -> Array:
        """(T, C) weighted sum of the examples' rows at their shares (A, T) of time.

        Between frames a Catmull–Rom cubic: through every frame, and without a corner there.
        """
        at = when * self._spans[chosen, None]
        low = np.floor(at)
        f = at - low
        taps = np.stack(
            [
                f * (f * (1.0 - 0.5 * f) - 0.5),
                1.0 + f * f * (1.5 * f - 2.5),
                f * (0.5 + f * (2.0 - 1.5 * f)),
                f * f * (0.5 * f - 0.5),
            ],
            axis=-1,
        )
        places = low.astype(np.intp)[..., None] + np.arange(-1, 3)
        if self.cyclic:
            places %= self._spans[chosen, None, None]
        else:
            places = np.clip(places + 1, 0, self._spans[chosen, None, None] + 2)
        places += self._begin[chosen, None, None]
        data = (shares[:, None, None] * taps).transpose(1, 0, 2)
        indices = places.transpose(1, 0, 2)
        count, each = len(data), data[0].size
        pointer = np.arange(0, (count + 1) * each, each)
        parts = (np.ravel(data), np.ravel(indices), pointer)
        return np.asarray(csr_array(parts, shape=(count, len(self._rows))) @ self._rows)

    def _feet(
        self,
        chosen: NDArray[np.intp],
        shares: Array,
        columns: Array,
        gone: Array,
    ) -> list[BlendedFoot]:
        feet, start = [], 0
        travel = shares @ self._travel[chosen] if self.cyclic else None
        for foot, soles in zip(self._examples[0].feet, self._soles, strict=True):
            width = 11 + 3 * len(soles)
            offsets = [shares @ sole[chosen] for sole in soles]
            part = np.ascontiguousarray(columns[:, start : start + width])
            feet.append(read_foot(foot, offsets, part, gone, travel))
            start += width
        return feet


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
