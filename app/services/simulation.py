"""Simulated participants: whole sessions through the same services as people's.

Each rater has a bias on every scale; answers follow from the effects, the bias and noise. The
sessions are of the kind ``simulated``: they hold no participant's slot and are in no result and no
export that does not ask for them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any
from uuid import UUID

import numpy as np
from sqlalchemy.orm import Session

from app.persistence.models import now
from app.persistence.responses import Counted
from app.schemas.effects import Effects
from app.schemas.sessions import Answer, Move, ViewingRecord, Viewport
from app.schemas.study import (
    ABX,
    Catch,
    CommentPage,
    Form,
    FormField,
    FreeText,
    Instructed,
    Ranking,
    StudyDefinition,
    Trials,
)
from app.services import answers, matching, sessions, simulated_matching
from app.services.effects import SLIDER_STEP, Taste, choosing
from app.services.plans import PAUSE, Step, planned_steps
from app.services.studies import definition_of, find, newest
from app.statistics.intervals import Samples
from app.statistics.raters import felt, matched, ranked, rated

Within = Callable[[Callable[[Session], Any]], Any]  # does it in a session of the database
TEXT = "simulated"
INDIFFERENT = 0.5  # steps, below which two figures show no difference


@dataclass
class Rater:
    """One simulated participant.

    Attributes:
        noise, bias_sd: in steps.
        generator: of all that this rater does.
    """

    tastes: dict[str, Taste]
    noise: float
    bias_sd: float
    generator: np.random.Generator

    def __post_init__(self) -> None:
        """Draw the biases, part by part."""
        self._biases = {
            name: self.generator.normal(0, self.bias_sd * taste.scale, len(taste.measures))
            for name, taste in self.tastes.items()
        }

    def answer(self, definition: StudyDefinition, step: Step) -> dict[str, Any]:
        """What is answered to a step."""
        if step["part"] == PAUSE.id:
            return {}
        part = definition.part(step["part"])
        match part:
            case Trials():
                return self._trial(part, step)
            case Form():
                given = {one.id: self._field(one) for one in part.fields}
                return {name: value for name, value in given.items() if value is not None}
            case CommentPage():
                return {"text": TEXT if part.required else ""}
            case _:
                return {}

    def _trial(self, part: Trials, step: Step) -> dict[str, Any]:
        taste = self.tastes[part.id]
        if isinstance(part.task, FreeText):
            return {"text": TEXT}
        if (check := step.get("check")) is not None and (asked := _asked(part, check)):
            return {**self._numbers(taste, self._latent(taste, step)), **asked}
        if choosing(taste):
            return {"choice": self._choice(taste, self._latent(taste, step)[:, 0], step)}
        if part.task.kind in ("parallel", "ranking"):
            return self._each(taste, self._latent(taste, step)[:, 0])
        return self._numbers(taste, self._latent(taste, step))

    def _latent(self, taste: Taste, step: Step) -> Samples:
        """(figures, measures), without the bias; a check's own clip is felt as nothing."""
        places = {one.clip: index for index, one in enumerate(taste.part.stimuli)}
        blank = np.zeros(len(taste.measures))
        known = [taste.latent[places[c]] if c in places else blank for c in step["clips"]]
        return np.array(known)

    def _numbers(self, taste: Taste, latent: Samples) -> dict[str, Any]:
        biased = latent[0] + self._biases[taste.part.id]
        return {
            one.id: self._number(taste, one.middle + value, one.lowest or 0, one.highest or 0)
            for one, value in zip(taste.measures, biased, strict=True)
        }

    def _number(self, taste: Taste, latent: float, lowest: float, highest: float) -> int:
        value = rated(
            np.array(latent), self.noise * taste.scale, self.generator,
            lowest=lowest, highest=highest,
        )  # fmt: skip
        return int(value)

    def _each(self, taste: Taste, latent: Samples) -> dict[str, Any]:
        if isinstance(taste.part.task, Ranking):
            given = ranked(felt(latent, self.noise, self.generator))
        else:
            middle = taste.measures[0].middle + self._biases[taste.part.id][0]
            given = rated(
                latent + middle, self.noise * SLIDER_STEP, self.generator, lowest=0, highest=100
            )
        return {str(place): int(value) for place, value in enumerate(given)}

    def _choice(self, taste: Taste, utility: Samples, step: Step) -> int:
        task = taste.part.task
        if isinstance(task, ABX):
            third = np.array(step["x"])
            return int(matched(utility[:2], third, self.noise, self.generator))
        if getattr(task, "allow_none", False):  # as one figure more, about which nothing is felt
            utility = np.append(utility, 0.0)
        seeming = felt(utility, self.noise, self.generator)
        if getattr(task, "allow_same", False) and abs(seeming[0] - seeming[1]) < INDIFFERENT:
            return -1
        best = int(np.argmax(seeming))
        return best if best < len(step["clips"]) else -1

    def _field(self, field: FormField) -> Any:  # noqa: ANN401 -- as its type is
        if field.type == "number":
            return self._within(field.minimum, field.maximum)
        if field.type in ("choice", "choices"):
            staying = [one.id for one in field.options if not one.screens_out]
            chosen = str(self.generator.choice(staying or [field.options[0].id]))
            return [chosen] if field.type == "choices" else chosen
        return TEXT if field.required else None

    def _within(self, minimum: float | None, maximum: float | None) -> float:
        """A whole number if one lies between the limits; an age where there are none."""
        low = min(18.0, np.inf if maximum is None else maximum) if minimum is None else minimum
        high = low + 60 if maximum is None else maximum
        first, last = int(np.ceil(low)), int(np.floor(high))
        return low if first > last else int(self.generator.integers(first, last + 1))


def _asked(part: Trials, check: str) -> dict[str, Any] | None:
    """What an attentive person answers to a check; None where it is only a clip again."""
    for one in part.checks:
        if one.id == check and isinstance(one, Instructed):
            return dict(one.answers)
        if one.id == check and isinstance(one, Catch):
            return {name: round((low + high) / 2) for name, (low, high) in one.answers.items()}
    return None


@dataclass(frozen=True)
class Course:
    """One simulated participant's way: the token, and the answers that count if it is complete."""

    token: str
    complete: bool
    counted: list[tuple[str, Counted]]


@dataclass(frozen=True)
class Begun:
    """A session that has begun: its secret, and what it leads through."""

    token: str
    definition: StudyDefinition
    steps: list[Step]
    session_id: UUID
    version_id: int

    def counted(self, step: Step, given: dict[str, Any]) -> list[tuple[str, Counted]]:
        """The answer to a step, if it is one that results are made of."""
        if "clips" not in step or step["practice"] or "check" in step:
            return []
        return [(step["part"], Counted(self.session_id, self.version_id, figures(step), given))]


def begin(db: Session, slug: str, rater: Rater) -> Begun:
    """A session of a simulated participant; the commit is the writer's."""
    consent = definition_of(newest(db, find(db, slug))).consent.version
    seed = int(rater.generator.integers(2**sessions.SEED_BITS))
    token = sessions.begin(db, slug, sessions.Beginning(consent, kind="simulated", seed=seed))
    session = sessions.open_session(db, token)
    definition, steps = definition_of(session.version), planned_steps(session.plan)
    return Begun(token, definition, steps, session.id, session.version_id)


@dataclass(frozen=True)
class Way:
    """What a participant answers, one answer a step from the first on."""

    answers: list[Answer]
    to_the_end: bool


def take_part(db: Session, slug: str, rater: Rater, stop_after: float = 1.0) -> Course:
    """A whole session through the services; the commit is the writer's.

    Args:
        db: where to write.
        slug: which study.
        rater: who takes part.
        stop_after: the part of the steps after which the participant leaves; 1 completes.
    """
    begun = begin(db, slug, rater)
    return hand_in(db, begun, way_through(db, begun, rater, stop_after))


def way_through(db: Session, begun: Begun, rater: Rater, stop_after: float) -> Way:
    """All answers of a session, without storing any: matching takes seconds of computing."""
    elapsed, given = 0.0, []
    for index, step in enumerate(begun.steps[: int(stop_after * len(begun.steps))]):
        told, taken, path = _given(db, begun.definition, step, rater)
        elapsed += taken
        given.append(_answer(index, told, taken, elapsed, path, rater.generator))
    return Way(given, stop_after >= 1)


def hand_in(db: Session, begun: Begun, way: Way) -> Course:
    """Store the answers, as far as the study lets the participant come."""
    counted: list[tuple[str, Counted]] = []
    for step, answer in zip(begun.steps, way.answers, strict=False):
        receipt, _ = answers.record(db, begun.token, answer)
        counted += begun.counted(step, answer.answers)
        if receipt.state != "active":
            return Course(begun.token, False, [])
    if not way.to_the_end:
        return Course(begun.token, False, [])
    sessions.complete(db, begun.token)
    return Course(begun.token, True, counted)


def _given(
    db: Session, definition: StudyDefinition, step: Step, rater: Rater
) -> tuple[dict[str, Any], float, list[Move] | None]:
    """The answer to a step, the milliseconds that it took and, of a match, the sliders' way."""
    task = matching.task_of(definition, step)
    if task is not None:
        hand = simulated_matching.taken(db, task, step, rater.generator)
        return {**hand.at, matching.SECONDS: hand.seconds}, 1000 * hand.seconds, hand.path
    taken = float(rater.generator.lognormal(np.log(6000), 0.4))
    return rater.answer(definition, step), taken, None


def figures(step: Step) -> list[str]:
    """The clips as the answer keeps them: of A/B/X with X at the end."""
    clips: list[str] = step["clips"]
    return [*clips, clips[step["x"]]] if "x" in step else clips


def raters(
    tastes: Sequence[Taste], effects: Effects, number: int, generator: np.random.Generator
) -> list[Rater]:
    """So many raters, each with a random stream of its own."""
    by_part = {taste.part.id: taste for taste in tastes}
    return [Rater(by_part, effects.noise, effects.rater_sd, own) for own in generator.spawn(number)]


def run(
    read: Within,
    write: Within,
    slug: str,
    raters: Sequence[Rater],
    dropout: float,
    generator: np.random.Generator,
) -> Iterator[Course]:
    """All raters' sessions, one after the other; so many of them leave somewhere on the way."""
    leaving = set(
        generator.choice(len(raters), round(dropout * len(raters)), replace=False).tolist()
    )
    for index, rater in enumerate(raters):
        stop = float(generator.uniform(0, 0.999)) if index in leaving else 1.0
        # Two short transactions a session, and the computing between them: a commit an answer would
        # take most of the time, and during one long one nobody else's answers would be stored.
        begun: Begun = write(partial(begin, slug=slug, rater=rater))
        way: Way = read(partial(way_through, begun=begun, rater=rater, stop_after=stop))
        course: Course = write(partial(hand_in, begun=begun, way=way))
        yield course


def _answer(
    index: int,
    given: dict[str, Any],
    taken: float,
    elapsed: float,
    path: list[Move] | None,
    generator: np.random.Generator,
) -> Answer:
    return Answer(
        trial_index=index,
        revision=1,
        answers=given,
        touched=list(given if path is None else dict.fromkeys(name for _, name, _ in path)),
        rt_ms=round(taken, 1),
        time_elapsed_ms=round(elapsed, 1),
        client_time=now(),
        record=ViewingRecord(
            plays=int(generator.integers(1, 4)), viewing_ms=round(0.9 * taken, 1), camera_moves=0,
            hidden_ms=0, blur_count=0, dropped_frames=0, tier=TEXT,
            viewport=Viewport(width=1280, height=800, pixel_ratio=1), path=path,
        ),
    )  # fmt: skip
