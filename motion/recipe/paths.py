"""Operations on the ways of limbs: longer, shorter, by frequency, at random."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.editing.grid import cached_nine_motions
from motion.editing.path_length import (
    ANGLES,
    DIRECTIONS,
    QUATERNIONS,
    PathLength,
    change_path_length,
)
from motion.editing.variation import vary
from motion.recipe.feet import LEGS, standing_again, standing_in_place
from motion.recipe.operation import Context, operation
from motion.recipe.parameters import Choice, Group, ListOf, Number

Array = NDArray[np.float64]

_USUAL = PathLength()


@dataclass(frozen=True)
class Equaliser:
    """Gains given at some frequencies, on a straight line over log frequency between them.

    Attributes:
        frequencies: Hz, in rising order; beyond the ends the gains go on as they are.
        gains: one for each.
    """

    frequencies: tuple[float, ...]
    gains: tuple[float, ...]

    def __call__(self, frequency: Array) -> Array:
        """Gain (...) at frequencies (...) in Hz."""
        octave = np.log(np.maximum(frequency, 1e-12))
        return np.interp(octave, np.log(self.frequencies), self.gains)


def _grid(clip: Clip, _: Context, *, path: float, timing: float) -> Clip:
    if path == timing == 1.0 or clip.frames < 2:
        return clip
    edited = cached_nine_motions(clip).at(path, timing)
    return edited if timing == 1.0 else standing_in_place(clip, edited)


def _path_length(clip: Clip, _: Context, *, representation: str, **settings: float) -> Clip:
    gains = PathLength(**settings)
    if gains.gain == 1.0:
        return clip
    return standing_again(clip, change_path_length(clip, gains, representation))


def _bands(clip: Clip, _: Context, *, gains: list[dict[str, float]]) -> Clip:
    ordered = sorted((band["frequency"], band["gain"]) for band in gains)
    if all(gain == 1.0 for _, gain in ordered):
        return clip
    frequencies, values = zip(*ordered, strict=True)
    return standing_again(clip, change_path_length(clip, Equaliser(frequencies, values)))


def _vary(clip: Clip, _: Context, *, path: float, rhythm: float, seed: int) -> Clip:
    return vary(clip, path, rhythm, np.random.default_rng(seed))


def _rhythm_only(clip: Clip, context: Context, *, path: float, rhythm: float, seed: int) -> Clip:
    return _vary(clip, context, path=0.0, rhythm=rhythm, seed=seed)


def _rising(values: Mapping[str, Any]) -> tuple[str, str] | None:
    names = ("low_edge", "full_from", "high_edge", "high_full")
    edges = [values[name] for name in names]
    if all(low < high for low, high in pairwise(edges)):
        return None
    given = ", ".join(f"{edge:g}" for edge in edges)
    return f"The edges {given} Hz do not rise.", f"Give {', '.join(names)} in rising order."


def _each_once(values: Mapping[str, Any]) -> tuple[str, str] | None:
    frequencies = [band["frequency"] for band in values["gains"]]
    if len(set(frequencies)) == len(frequencies):
        return None
    return "A frequency has two gains.", "Give each frequency once."


def _edge(name: str, title: str, description: str) -> Number:
    return Number(
        title=title,
        description=description,
        unit="Hz",
        minimum=0.01,
        maximum=200.0,
        default=float(getattr(_USUAL, name)),
    )


GRID = operation(
    "grid@1",
    "Path length and timing",
    "A point between Förger's nine motions: shorter to longer paths, even speed to bursts.",
    {
        "path": Number(
            title="Path length",
            description="0 shorter, 1 as it is, 2 longer.",
            minimum=0.0,
            maximum=2.0,
            default=1.0,
            neutral=1.0,
        ),
        "timing": Number(
            title="Timing",
            description="0 even speed, 1 as it is, 2 added acceleration.",
            minimum=0.0,
            maximum=2.0,
            default=1.0,
            neutral=1.0,
        ),
    },
    _grid,
    needs=LEGS,
)

PATH_LENGTH = operation(
    "path_length@1",
    "Path length by frequency",
    "Lengthens or shortens the ways of all limbs: one gain for the frequencies of the movement.",
    {
        "gain": Number(
            title="Gain",
            description="Above 1 longer paths, below 1 shorter ones.",
            minimum=0.0,
            maximum=3.0,
            default=1.0,
            neutral=1.0,
        ),
        "low_edge": _edge("low_edge", "Low edge", "Below it nothing changes."),
        "full_from": _edge("full_from", "Full from", "From here on the gain is in force."),
        "high_edge": _edge("high_edge", "High edge", "From here on the gain falls or rises."),
        "high_full": _edge("high_full", "Noise from", "From here on the noise's gain holds."),
        "high_gain": Number(
            title="Noise",
            description="The gain of noise and jitter.",
            minimum=0.0,
            maximum=2.0,
            default=_USUAL.high_gain,
        ),
        "representation": Choice(
            title="Filtered as",
            description="Direction vectors; the others show why those.",
            options=(DIRECTIONS, QUATERNIONS, ANGLES),
            default=DIRECTIONS,
        ),
    },
    _path_length,
    rule=_rising,
)

BANDS = operation(
    "bands@1",
    "Frequency bands",
    "An equaliser: gains at chosen frequencies, on a straight line between them.",
    {
        "gains": ListOf(
            title="Gains",
            description="One for each chosen frequency.",
            shortest=1,
            longest=24,
            item=Group(
                title="Band",
                members={
                    "frequency": Number(title="Frequency", unit="Hz", minimum=0.01, maximum=200.0),
                    "gain": Number(
                        title="Gain",
                        description="1 leaves the frequency as it is.",
                        minimum=0.0,
                        maximum=4.0,
                        default=1.0,
                        neutral=1.0,
                    ),
                },
            ),
        )
    },
    _bands,
    rule=_each_once,
)

VARY = operation(
    "vary@1",
    "Vary at random",
    "Path length and rhythm change smoothly at random; the motion lasts as long as before.",
    {
        "path": Number(
            title="Path length",
            description="How far the paths' gain strays from 1.",
            minimum=0.0,
            maximum=1.0,
            default=0.0,
            neutral=0.0,
        ),
        "rhythm": Number(
            title="Rhythm",
            description="How far the pace strays.",
            minimum=0.0,
            maximum=1.0,
            default=0.0,
            neutral=0.0,
        ),
        "seed": Number(
            title="Seed",
            description="Another number, another course.",
            minimum=0,
            maximum=2**32 - 1,
            default=1,
            whole=True,
        ),
    },
    _vary,
    follow=_rhythm_only,
    needs=LEGS,
)
