"""Matching a target with the sliders of a space: what they make, and how near it came."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import clips, responses
from app.persistence.engine import Database
from app.persistence.models import StudySession
from app.schemas.spaces import Point, SpaceDefinition
from app.schemas.study import Interface, Match, StudyDefinition, Trials
from app.services.engine_version import engine_version
from app.services.plans import Step, planned_steps
from app.services.sessions import open_session, refuse_ended
from app.services.studies import definition_of

if TYPE_CHECKING:  # they bring SciPy, for which the server's start shall not wait
    from app.services.space_motion import Prepared
    from motion import Clip

MEASURED = ("interface", "seen", "distance", "solved", "engine")
SECONDS = "seconds"
BESIDE_SLIDERS = (SECONDS, *MEASURED)  # in a stored answer
TARGETS_KEPT = 64


class Made(NamedTuple):
    """The motion that sliders make.

    Attributes:
        glb: without a figure.
        weights: of the examples.
        outside: how far the sliders are outside of what the examples span.
        distance: metres from the target.
        solved: whether that is below the threshold.
    """

    glb: bytes
    weights: list[float]
    outside: float
    distance: float
    solved: bool


def motion(db: Session, token: str, index: int, values: Mapping[str, float]) -> Made:
    """What the sliders of a step make, and how near to its target it is.

    Raises:
        NotFoundError: no such session.
        ConflictError: the step is a guess, in which nothing is seen; its turn has not come, or it
            was answered by other positions; or the session has ended.
        InvalidError: the step matches nothing, or has no such slider.
    """
    session = open_session(db, token)
    refuse_ended(session.state)
    _refuse_out_of_turn(db, session, index, values)
    definition = definition_of(session.version)
    return made_in(db, definition, planned_steps(session.plan), index, values)


def _refuse_out_of_turn(
    db: Session, session: StudySession, index: int, values: Mapping[str, float]
) -> None:
    """Nobody practises on a target beforehand; of a step behind, what was handed in is shown."""
    answered = responses.answered(db, session.id)
    if index not in answered and not answered.issuperset(range(index)):
        raise ConflictError(
            "An earlier step has no answer yet, so this one shows no motion.",
            code="too_early",
            where={"trial_index": index},
            mend="Answer the steps in their order.",
        )
    if index in answered and values != _sliders_in(responses.newest_of(db, session.id, index)):
        raise ConflictError(
            "This step is answered, and shows only the motion that was handed in.",
            code="already_answered",
            where={"trial_index": index},
            mend="Reload the page: it shows what is stored.",
        )


def _sliders_in(answers: Mapping[str, Any] | None) -> dict[str, float]:
    return {name: at for name, at in (answers or {}).items() if name not in BESIDE_SLIDERS}


def made_in(
    db: Session,
    definition: StudyDefinition,
    steps: list[Step],
    index: int,
    values: Mapping[str, float],
) -> Made:
    """The same for the steps of any way through a study.

    Raises:
        ConflictError: the step is a guess.
        InvalidError: as `motion`.
    """
    step = steps[index] if index < len(steps) else {}
    task = task_of(definition, step)
    if task is None:
        raise InvalidError(
            f"Nothing is to be matched in step {index}.",
            code="trial_unknown",
            where={"trial_index": index},
            mend="Reload the page.",
        )
    if not step["seen"]:
        raise ConflictError(
            "This is a guess: its motion is not shown.",
            code="unseen",
            where={"trial_index": index},
            mend="Reload the page.",
        )
    space, target = space_of(db, task), _target(db, step)
    db.close()  # others wait for the connection, and computing takes longer than reading
    weighed = space.weights(point_of(space.definition, step["interface"], values))
    created = space.clip(weighed.weights)
    distance = _distance(target, created)
    glb = _glb(created)
    return Made(glb, weighed.weights, weighed.outside, distance, distance < task.threshold)


def is_match(answers: Mapping[str, Any]) -> bool:
    """Whether an answer, as sent, may be one to a match; a few others look the same."""
    return SECONDS in answers


def prepare(database: Database, token: str, index: int) -> None:
    """Have the space of a step ready, if it matches a target.

    Reading 27 clips takes half a second, which the writer would take from everybody else's answers,
    so whoever hands it an answer to a match does this first.

    Raises:
        NotFoundError: no such session.
    """
    with database.reading() as db:
        session = open_session(db, token)
        step = dict(enumerate(planned_steps(session.plan))).get(index, {})
        task = task_of(definition_of(session.version), step)
        if task is not None and session.state == "active":
            space_of(db, task)


def measured(db: Session, task: Match, step: Step, answers: Mapping[str, Any]) -> dict[str, Any]:
    """An answer with what the server measures of it: see `app.schemas.study.tasks`.

    Raises:
        InvalidError: the space has no such slider.
    """
    values = {name: value for name, value in answers.items() if name != SECONDS}
    distance = measure(db, task, step)(values)
    in_time = not step["seen"] or answers[SECONDS] <= task.seconds
    return {
        **answers,
        "interface": step["interface"],
        "seen": int(step["seen"]),
        "distance": round(distance, 6),
        "solved": int(distance < task.threshold and in_time),
        "engine": engine_version(),
    }


def measure(db: Session, task: Match, step: Step) -> Callable[[Mapping[str, float]], float]:
    """What tells of the sliders' positions how far, in metres, their motion is from the target.

    It raises InvalidError if the space has no such slider.
    """
    space, target = space_of(db, task), _target(db, step)

    def apart(values: Mapping[str, float]) -> float:
        point = point_of(space.definition, step["interface"], values)
        return _distance(target, space.clip(space.weights(point).weights))

    return apart


def as_sent(answers: Mapping[str, Any]) -> dict[str, Any]:
    """An answer without what the server measured of it."""
    if "distance" not in answers or "interface" not in answers:
        return dict(answers)
    return {name: value for name, value in answers.items() if name not in MEASURED}


def task_of(definition: StudyDefinition, step: Step) -> Match | None:
    """What a step matches; None for steps of other kinds."""
    part = next((one for one in definition.parts if one.id == step.get("part")), None)
    return part.task if isinstance(part, Trials) and isinstance(part.task, Match) else None


def point_of(
    definition: SpaceDefinition, interface: Interface, values: Mapping[str, float]
) -> Point:
    """The page's sliders as a point of the space; bare weights are called `e0`, `e1`, … there.

    Raises:
        InvalidError: the page has no such slider, or has others that are not given: fewer would
            span another space than the one that is shown.
    """
    ids = sliders_of(definition, interface)
    strange = [name for name in values if name not in ids]
    absent = [name for name in ids if name not in values and interface != "weights"]
    if strange or absent or not values:
        what = f"no slider “{strange[0][:60]}”" if strange else "sliders that are not given"
        raise InvalidError(
            f"This trial has {what}.",
            code="answer_invalid",
            where={"sliders": (strange or absent)[:5]},
            mend="Reload the page.",
        )
    # All at the bottom: as good a place as any, and nobody is told off for having been there.
    given = values if any(values.values()) or interface != "weights" else dict.fromkeys(ids, 1.0)
    return Point(interface=interface, values={ids[name]: value for name, value in given.items()})


def sliders_of(definition: SpaceDefinition, interface: Interface) -> dict[str, str]:
    """What the page calls each slider of an interface, and what the space calls it."""
    sliders = definition.sliders(interface)
    if sliders is not None:
        return {one.id: one.id for one in sliders.primary}
    if interface == "weights":
        return {f"e{number}": one.clip for number, one in enumerate(definition.examples)}
    return {}


def space_of(db: Session, task: Match) -> Prepared:
    """The space of a task, ready."""
    from app.services import space_motion

    return space_motion.prepared_in(db, task.space)


def _target(db: Session, step: Step) -> Clip:
    target = step["clips"][0]
    return _clip(clips.contents(db, [target])[target])


def _distance(target: Clip, created: Clip) -> float:
    from motion.blending.distance import matching_distance

    return float(matching_distance(target, created))


@lru_cache(maxsize=TARGETS_KEPT)
def _clip(content: bytes) -> Clip:
    from motion.storage import clip_from_bytes

    return clip_from_bytes(content)


def _glb(clip: Clip) -> bytes:
    from motion.glb import write_clip_glb

    return write_clip_glb(clip)
