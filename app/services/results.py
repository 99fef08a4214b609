"""A study's results: live counts, every clip on every axis, and "Is every emotion seen?".

Analysed are the newest answers of complete participants, practice left out. The raw answers hold
all that is needed to compute every number again.
"""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime, timedelta
from functools import lru_cache
from statistics import median

import numpy as np
from sqlalchemy.orm import Session

from app.persistence import responses, sessions
from app.persistence.models import Study, now
from app.schemas.results import Axis, Cell, Clip, Counts, PoleRow, StudyResults
from app.schemas.study import Scale, StudyDefinition
from app.services import sentences
from app.services.studies import definition_of, find
from app.statistics.intervals import Samples, mean_interval, present
from app.statistics.poles import Against, BestClip, best_clip, chance_of_best
from app.statistics.tests import holm

NEEDED = 5
STILL_THERE = timedelta(minutes=30)
RULE = (
    "Analysed are complete participants only; of each clip the newest answer; the practice clips "
    "are left out."
)


def results(db: Session, slug: str, against: Against = "others") -> StudyResults:
    """All numbers of the results page.

    Args:
        db: where to read.
        slug: which study.
        against: whether a best clip is compared with its body's other clips, or with all of them.
    """
    study = find(db, slug)
    definition = definition_of(study)
    ratings = rating_array(db, study, definition)
    clips = [
        Clip(id=s.clip, name=s.name, label=s.label, body=s.body, style=s.style)
        for s in definition.stimuli
    ]
    return StudyResults(
        slug=slug,
        title=definition.title,
        study_hash=study.definition_hash,
        needed=NEEDED,
        participants=len(ratings),
        rule=RULE,
        against=against,
        counts=count(db, study, now()),
        steps=list(definition.steps),
        clips=clips,
        axes=[
            _axis(scale, clips, ratings[:, :, index], definition.reach)
            for index, scale in enumerate(definition.scales)
        ],
        poles=_poles(definition, clips, ratings, against),
    )


def counts(db: Session, slug: str) -> Counts:
    """How far the participants are at this moment."""
    return count(db, find(db, slug), now())


def count(db: Session, study: Study, moment: datetime) -> Counts:
    """How far the participants were at the given moment, which the half hour is counted from."""
    every = sessions.progress(db, study)
    active = [one for one in every if one.state == "active"]
    left = [one for one in active if moment - _last_sign(one) > STILL_THERE]
    trials = definition_of(study).trials
    times = [
        (one.completed_at - one.consented_at).total_seconds()
        for one in every
        if one.completed_at and one.consented_at
    ]
    return Counts(
        complete=sum(one.state == "complete" for one in every),
        under_way=len(active) - len(left),
        left_early=len(left),
        left_at=sorted(min(one.answered + 1, trials) for one in left),
        withdrawn=sum(one.state == "withdrawn" for one in every),
        answers=responses.count(db, study),
        median_seconds=median(times) if times else None,
    )


def rating_array(db: Session, study: Study, definition: StudyDefinition) -> Samples:
    """The analysed answers, (participants, clips, scales); NaN where one is missing."""
    rows = responses.analysed(db, study)
    people = {session: index for index, session in enumerate(dict.fromkeys(r[0] for r in rows))}
    clips = {stimulus.clip: index for index, stimulus in enumerate(definition.stimuli)}
    ratings = np.full((len(people), len(clips), len(definition.scales)), np.nan)
    for session, clip, answers in rows:
        ratings[people[session], clips[clip]] = [answers[s.id] for s in definition.scales]
    return ratings


def _last_sign(progress: sessions.Progress) -> datetime:
    times = [time for time in (progress.last_answer, progress.consented_at) if time]
    return max(times, default=now())


def _axis(scale: Scale, clips: Sequence[Clip], ratings: Samples, reach: int) -> Axis:
    """All clips on one scale; ratings (participants, clips)."""
    cells = [_cell(clip, ratings[:, index], reach) for index, clip in enumerate(clips)]
    means = [(cell.mean, clip.label) for cell, clip in zip(cells, clips, strict=True)]
    known = [(mean, label) for mean, label in means if mean is not None]
    sentence = _too_few(len(ratings))
    if known:
        (low, lowest), (high, highest) = min(known), max(known)
        sentence = sentences.extremes((scale.left, lowest, low), (scale.right, highest, high))
    return Axis(id=scale.id, left=scale.left, right=scale.right, cells=cells, sentence=sentence)


def _cell(clip: Clip, values: Samples, reach: int) -> Cell:
    given = present(values)
    found = mean_interval(given) if given.size >= NEEDED else None
    if found is None:
        return Cell(
            clip=clip.id, n=given.size, mean=None, sd=None, low=None, high=None, shares=None
        )
    return Cell(
        clip=clip.id,
        n=found.n,
        mean=found.mean,
        sd=found.sd,
        low=found.low,
        high=found.high,
        shares=[float(np.mean(given == step)) for step in range(-reach, reach + 1)],
    )


def _poles(
    definition: StudyDefinition, clips: Sequence[Clip], ratings: Samples, against: Against
) -> list[PoleRow]:
    """Figure 31: two rows a scale, the left pole's first."""
    enough = len(ratings) >= NEEDED
    bodies = [clip.body for clip in clips]
    asked = [
        (scale, pole, more, sign * ratings[:, :, index])
        for index, scale in enumerate(definition.scales)
        for pole, more, sign in (
            (scale.left, scale.left_more, -1),
            (scale.right, scale.right_more, 1),
        )
    ]
    found = [best_clip(toward, bodies, against) if enough else None for *_, toward in asked]
    adjusted = holm([best.welch.p if best and best.welch else None for best in found])
    permuted = [
        _chance(toward.tobytes(), toward.shape, tuple(bodies), against, definition.content_hash)
        if best
        else None
        for (*_, toward), best in zip(asked, found, strict=True)
    ]
    rows = zip(asked, found, adjusted, permuted, holm(permuted), strict=True)
    return [
        _pole_row(scale, pole, more, clips[best.clip], best, p_holm, against).model_copy(
            update={"p_permuted": chance, "p_permuted_holm": chance_holm}
        )
        if best
        else _empty_row(scale, pole)
        for (scale, pole, more, _), best, p_holm, chance, chance_holm in rows
    ]


@lru_cache(maxsize=256)
def _chance(
    toward: bytes, shape: tuple[int, int], bodies: tuple[str, ...], against: Against, study: str
) -> float | None:
    """The permutation test, drawn from the study's hash: the same answers give the same p.

    Remembered, for a page that is open asks for the same numbers again and again.
    """
    generator = np.random.default_rng(int(study[:16], 16))
    ratings = np.frombuffer(toward).reshape(shape)
    return chance_of_best(ratings, bodies, generator, against)


def _pole_row(
    scale: Scale, pole: str, more: str, clip: Clip,
    best: BestClip, p_holm: float | None, against: Against,
) -> PoleRow:  # fmt: skip
    test, effect, pair = best.welch, best.effect, best.paired
    sentence = None
    if test and effect and p_holm is not None:
        sentence = sentences.best_clip(
            label=clip.label, more=more, against=against, t=test.t, df=test.df, p_holm=p_holm,
            d=effect.d, low=effect.low, high=effect.high,
        )  # fmt: skip
    return _empty_row(scale, pole).model_copy(
        update={
            "clip": clip,
            "mean": best.mean,
            "others": best.rest_mean,
            "difference": best.mean - best.rest_mean,
            "p_holm": p_holm,
            "sentence": sentence,
            **({"t": test.t, "df": test.df, "p": test.p} if test else {}),
            **({"d": effect.d, "d_low": effect.low, "d_high": effect.high} if effect else {}),
            **({"paired_t": pair.t, "paired_df": pair.df, "paired_p": pair.p} if pair else {}),
        }
    )


def _empty_row(scale: Scale, pole: str) -> PoleRow:
    unknown = dict.fromkeys(PoleRow.model_fields)
    return PoleRow.model_validate({**unknown, "scale": scale.id, "pole": pole})


def _too_few(participants: int) -> str:
    return f"This needs five complete participants; so far there are {participants}."
