"""Which stated effects a study would find: its analysis rehearsed on simulated answers.

Each effect is tested as a contrast within participants: what a participant answers on average to
the clips that the effect moves, less the same of the part's other clips, by a t-test against zero;
p is adjusted by Holm's method over the effects of a part. Found means p < .05 and the right sign.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.persistence.responses import Counted
from app.schemas.effects import Effects
from app.schemas.study import OF_ONE, StudyDefinition
from app.services.effects import Taste, choosing, felt_of
from app.services.plans import Unit, draw_plan, planned_steps, units
from app.services.result_axes import rating_array
from app.services.simulation import INDIFFERENT
from app.services.versions import Pooled
from app.statistics.intervals import Samples
from app.statistics.power import Power, about_zero, found_in
from app.statistics.raters import felt, matched, ranked, rated
from app.statistics.tests import holm

LEVEL = 0.05
RIGHT = "right answers"  # what A/B/X is tested for, against guessing


@dataclass(frozen=True)
class Effect:
    """One stated effect as the study can see it.

    Attributes:
        part, value: where it is asked; about: the clip, style or body that it moves.
        size: of the contrast, in steps.
    """

    part: str
    value: str
    about: str
    size: float


@dataclass(frozen=True)
class Found:
    """An effect after one run: p after Holm's correction, and whether it was found."""

    effect: Effect
    p: float
    found: bool


def from_answers(
    tastes: Sequence[Taste], effects: Effects, counted: Sequence[tuple[str, Counted]]
) -> list[Found]:
    """What the answers of one simulated run show."""
    found: list[Found] = []
    for taste in tastes:
        rows = [row for part, row in counted if part == taste.part.id]
        if rows:
            found += _tested(taste, effects, _observed(taste, rows))
    return found


def repeated(
    definition: StudyDefinition,
    tastes: Sequence[Taste],
    effects: Effects,
    participants: int,
    generator: np.random.Generator,
    runs: int,
    tell: Callable[[int], None] = lambda run: None,
) -> list[tuple[Effect, Power]]:
    """How often each effect is found in so many runs, of which nothing is stored.

    Args:
        definition: the study.
        tastes: of its parts.
        effects: from which they were made.
        participants: complete ones.
        generator: of all draws.
        runs: how many.
        tell: is told each run's number.
    """
    shown = _shown(definition, participants, generator)
    hits: dict[Effect, list[bool]] = {}
    for number in range(runs):
        for taste in tastes:
            values = _drawn(taste, effects, shown[taste.part.id], generator)
            for one in _tested(taste, effects, values):
                hits.setdefault(one.effect, []).append(one.found)
        tell(number + 1)
    return [(effect, found_in(found)) for effect, found in hits.items()]


def _tested(taste: Taste, effects: Effects, values: Samples) -> list[Found]:
    """All effects of a part; values (people, clips, measures), of A/B/X (people,)."""
    wanted = list(_effects(taste, effects))
    if not wanted:
        return []
    contrasts = [_contrast(taste, effect, values) for effect in wanted]
    adjusted = holm([float(about_zero(contrast)) for contrast in contrasts])
    return [
        Found(effect, p or 0.0, bool((p or 0) < LEVEL and np.nanmean(contrast) * effect.size > 0))
        for effect, contrast, p in zip(wanted, contrasts, adjusted, strict=True)
    ]


def _effects(taste: Taste, effects: Effects) -> Iterator[Effect]:
    part = taste.part.id
    if taste.part.task.kind == "abx":
        if spread := float(np.ptp(taste.latent)):
            yield Effect(part, RIGHT, "all pairs", spread)
        return
    for column, measure in enumerate(taste.measures):
        for key in felt_of(measure, effects):
            moved = np.zeros(len(taste.latent), dtype=bool)
            moved[taste.matching(key)] = True
            if moved.any() and not moved.all():
                latent = taste.latent[:, column] / taste.scale
                size = float(latent[moved].mean() - latent[~moved].mean())
                if abs(size) > 1e-9:
                    yield Effect(part, measure.id, key, size)


def _contrast(taste: Taste, effect: Effect, values: Samples) -> Samples:
    """(people,) the effect as each participant's answers show it; NaN where they do not."""
    if effect.value == RIGHT:
        return values - 0.5
    column = [measure.id for measure in taste.measures].index(effect.value)
    moved = taste.matching(effect.about)
    others = [index for index in range(len(taste.latent)) if index not in moved]
    sign = -1.0 if effect.value == "rank" else 1.0  # the first rank is the best one
    found = values[:, :, column]
    return np.asarray(sign * (_mean(found[:, moved]) - _mean(found[:, others])))


def _mean(values: Samples) -> Samples:
    """Row means of what is there; NaN where nothing is, without NumPy's warning."""
    n = np.sum(~np.isnan(values), axis=1)
    with np.errstate(invalid="ignore"):
        return np.asarray(np.nansum(values, axis=1) / n)


def _observed(taste: Taste, rows: Sequence[Counted]) -> Samples:
    if not choosing(taste):
        part = taste.part
        pooled = Pooled(part.id, part.task, list(part.stimuli), taste.measures, [], [], [])
        return rating_array(pooled, rows)
    people = {one: index for index, one in enumerate(dict.fromkeys(r.session_id for r in rows))}
    places = {one.clip: index for index, one in enumerate(taste.part.stimuli)}
    tally = _Tally(len(people), len(places))
    for row in rows:
        person = np.array([people[row.session_id]])
        choice = row.answers["choice"]
        if taste.part.task.kind == "abx":
            tally.add(person, [0], np.array([[float(row.clips[choice] == row.clips[2])]]))
        else:
            taken = np.arange(len(row.clips)) == choice
            tally.add(person, [places[clip] for clip in row.clips], taken[None].astype(float))
    return tally.means[:, 0] if taste.part.task.kind == "abx" else tally.means[:, :, None]


class _Tally:
    """Means over what each participant answered to each clip."""

    def __init__(self, people: int, clips: int) -> None:
        self._sums, self._times = np.zeros((people, clips)), np.zeros((people, clips))

    def add(self, people: NDArray[np.intp], clips: Sequence[int], values: Samples) -> None:
        """Answers (people, clips) of these people to these clips."""
        where = np.ix_(people, np.array(clips, dtype=np.intp))
        self._sums[where] += values
        self._times[where] += 1

    @property
    def means(self) -> Samples:
        """(people, clips); NaN where nothing was answered."""
        nothing = np.full_like(self._sums, np.nan)
        return np.divide(self._sums, self._times, out=nothing, where=self._times > 0)


Shown = list[tuple[Unit, NDArray[np.intp]]]


def _shown(
    definition: StudyDefinition, participants: int, generator: np.random.Generator
) -> dict[str, Shown]:
    """Of each part its trials, each with the participants that see it."""
    seen: dict[tuple[str, frozenset[str]], list[int]] = {}
    for slot in range(participants):
        plan = draw_plan(definition, int(generator.integers(2**48)), slot, definition.content_hash)
        for step in planned_steps(plan):
            if "clips" in step and not step["practice"] and "check" not in step:
                seen.setdefault((step["part"], frozenset(step["clips"])), []).append(slot)
    return {
        part.id: [
            (unit, np.array(seen.get((part.id, frozenset(
                part.stimuli[place].clip or "" for place in unit)), []), dtype=np.intp))
            for unit in units(part)
        ]
        for part in definition.trials
    }  # fmt: skip


def _drawn(taste: Taste, effects: Effects, shown: Shown, generator: np.random.Generator) -> Samples:
    """One run's answers to a part, all participants at once."""
    people = 1 + max((int(who.max()) for _, who in shown if len(who)), default=0)
    if taste.part.task.kind in OF_ONE:
        return _all_rated(taste, effects, shown, people, generator)
    tally = _Tally(people, len(taste.latent))
    bias = generator.normal(0, effects.rater_sd * taste.scale, people)
    for unit, who in shown:
        latent = np.broadcast_to(taste.latent[list(unit), 0], (len(who), len(unit)))
        if taste.part.task.kind == "abx":
            third = generator.integers(2, size=len(who))
            right = matched(latent, third, effects.noise, generator) == third
            tally.add(who, [0], right[:, None].astype(float))
        elif taste.part.task.kind == "parallel":
            middled = latent + taste.measures[0].middle + bias[who, None]
            noise = effects.noise * taste.scale
            tally.add(who, unit, rated(middled, noise, generator, lowest=0, highest=100))
        else:
            tally.add(who, unit, _compared(taste, felt(latent, effects.noise, generator), effects,
                                           generator))  # fmt: skip
    return tally.means[:, 0] if taste.part.task.kind == "abx" else tally.means[:, :, None]


def _compared(
    taste: Taste, seeming: Samples, effects: Effects, generator: np.random.Generator
) -> Samples:
    """Ranks, or 1 for the chosen figure and 0 for the others, (people, figures)."""
    task = taste.part.task
    if task.kind == "ranking":
        return ranked(seeming)
    best = np.argmax(seeming, axis=1)
    chosen = np.arange(seeming.shape[1]) == best[:, None]
    if getattr(task, "allow_none", False):
        none = felt(np.zeros(len(seeming)), effects.noise, generator)
        chosen &= (seeming.max(axis=1) >= none)[:, None]
    if getattr(task, "allow_same", False):
        chosen &= (np.ptp(seeming, axis=1) >= INDIFFERENT)[:, None]
    return chosen.astype(float)


def _all_rated(
    taste: Taste, effects: Effects, shown: Shown, people: int, generator: np.random.Generator
) -> Samples:
    """(people, clips, measures) answers of who saw the clip; NaN of who did not."""
    values = np.full((people, *taste.latent.shape), np.nan)
    noise = effects.noise * taste.scale
    for column, measure in enumerate(taste.measures):
        bias = generator.normal(0, effects.rater_sd * taste.scale, people)
        latent = measure.middle + taste.latent[None, :, column] + bias[:, None]
        values[:, :, column] = rated(
            latent, noise, generator, lowest=measure.lowest or 0, highest=measure.highest or 0
        )
    for (clip,), who in shown:
        unseen = np.ones(people, dtype=bool)
        unseen[who] = False
        values[unseen, clip] = np.nan
    return values
