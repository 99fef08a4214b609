"""Does the way from ratings to clusters find what simulated raters had in mind?

Raters whose impressions follow the published tables answer the questionnaire on sets A and B, with
more or less noise, more or fewer of them, many times over; and again with their answers shuffled.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from app.jobs import executor
from app.statistics.intervals import present
from app.statistics.latent_raters import (
    PAPER_NOISE,
    Recovery,
    recover,
    shuffle_answers,
    shuffle_clips,
)
from app.studies.published_clusters import published
from app.studies.simulated_impressions import latent, simulated_ratings

SETS = ("set_a", "set_b")
RATERS = 14  # in the paper
NOISES = (0.1, 0.2, 0.4, 0.6, PAPER_NOISE, 0.9, 1.0, 1.2, 1.6)  # steps
PARTICIPANTS = (3, 5, 7, 10, 14, 20, 30, 50)
Control = Literal["none", "answers", "clips", "motions"]
_CONTROLS: tuple[Control, ...] = ("none", "answers", "clips", "motions")
_SHUFFLES = {"answers": shuffle_answers, "clips": shuffle_clips}


class Setting(NamedTuple):
    """One point of a curve: what is varied.

    Attributes:
        motion_set: set_a or set_b.
        noise: of the raters, in steps.
        participants: how many raters.
        control: which structure is taken out by shuffling; or "motions", where each study has
            motions of its own, of which nothing is known.
    """

    motion_set: str
    noise: float = PAPER_NOISE
    participants: int = RATERS
    control: Control = "none"


@dataclass(frozen=True)
class Share:
    """Mean over the seeds, and where the middle 90 % of them lie; NaN where nothing is defined."""

    mean: float
    low: float
    high: float

    @staticmethod
    def of(values: Iterable[float]) -> Share:
        """Of all values that are defined."""
        known = present(list(values))
        if not known.size:
            return Share(np.nan, np.nan, np.nan)
        low, high = np.quantile(known, [0.05, 0.95])
        return Share(float(known.mean()), float(low), float(high))


@dataclass(frozen=True)
class Point:
    """What was found at one setting.

    Attributes:
        setting: what was varied.
        seeds: how many simulated studies.
        kept: share of the table's pairs that were kept.
        dropped: share of the other pairs that were dropped.
        rand: adjusted Rand index of the clusters with the table, over the table's pairs that were
            kept, where at least four pairs were.
        solved: in how many studies they were.
        rand_of_all: the same with no pair dropped but those that the table does not list.
        exact: in how many studies everything was as in the table.
    """

    setting: Setting
    seeds: int
    kept: Share
    dropped: Share
    rand: Share
    solved: int
    rand_of_all: Share
    exact: int


def settings() -> list[Setting]:
    """Every noise with every number of raters, and the controls along both curves."""
    grid = [
        Setting(motion_set, noise, participants)
        for motion_set in SETS
        for noise in NOISES
        for participants in PARTICIPANTS
    ]
    curves = [one for one in grid if one.noise == PAPER_NOISE or one.participants == RATERS]
    return grid + [one._replace(control=control) for control in _CONTROLS[1:] for one in curves]


def points(
    wanted: Iterable[Setting],
    seeds: int,
    seed: int,
    tell: Callable[[int], object] = lambda done: None,
    processes: int | None = None,
) -> dict[Setting, Point]:
    """Run every setting, on all processors; the same seed gives the same whatever their number.

    Args:
        wanted: the settings.
        seeds: how many simulated studies each.
        seed: of all draws.
        tell: is told how many settings are done.
        processes: None for one a processor.
    """
    wanted = list(wanted)
    found = {}
    with executor(processes=processes) as pool:
        work = [pool.submit(point, setting, seeds, seed) for setting in wanted]
        for done, (setting, one) in enumerate(zip(wanted, work, strict=True), 1):
            found[setting] = one.result()
            tell(done)
    return found


def point(setting: Setting, seeds: int, seed: int) -> Point:
    """What is found at one setting in so many simulated studies."""
    both = [_studied(setting, _generator(setting, seed, number)) for number in range(seeds)]
    studies, of_all = zip(*both, strict=True)
    rand = [study.rand for study in studies]
    return Point(
        setting,
        seeds,
        Share.of(study.kept for study in studies),
        Share.of(study.dropped for study in studies),
        Share.of(rand),
        len(present(rand)),
        Share.of(study.rand for study in of_all),
        sum(study.exact for study in studies),
    )


def _studied(setting: Setting, generator: np.random.Generator) -> tuple[Recovery, Recovery]:
    """One simulated study, analysed with the thresholds and without."""
    set_, noise, participants, control = setting
    own = generator.uniform(-1, 1, latent(set_).shape) if control == "motions" else None
    ratings = simulated_ratings(set_, generator, participants, noise, own)
    if shuffle := _SHUFFLES.get(control):
        ratings = shuffle(ratings, generator)
    factors = published(set_)
    return recover(ratings, factors), recover(ratings, factors, thresholds=False)


def _generator(setting: Setting, seed: int, number: int) -> np.random.Generator:
    """Of one study; no setting depends on which others are asked for."""
    return np.random.default_rng(
        [
            seed,
            SETS.index(setting.motion_set),
            round(1000 * setting.noise),
            setting.participants,
            _CONTROLS.index(setting.control),
            number,
        ]
    )
