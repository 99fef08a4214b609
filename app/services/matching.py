"""Matching a target with the sliders of a space: what is shown, and how near a motion came."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import clips, studies
from app.persistence.engine import Database
from app.persistence.studies import Media
from app.schemas.spaces import START, Point, Primary, Sliders, SpaceDefinition
from app.schemas.study import Interface, Language, Match, StudyDefinition, Trials
from app.services.engine_version import engine_version
from app.services.plans import Step, planned_steps
from app.services.sessions import open_session, refuse_ended
from app.services.studies import definition_of, media_url

if TYPE_CHECKING:  # they bring SciPy, for which the server's start shall not wait
    from app.services.space_motion import Prepared
    from motion import Clip

SHOWN_WORDS = 3  # of a cluster's pairs, at the ends of its slider
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
        ConflictError: the step is a guess, in which nothing is seen, or the session has ended.
        InvalidError: the step matches nothing, or has no such slider.
    """
    session = open_session(db, token)
    refuse_ended(session.state)
    definition = definition_of(session.version)
    return made_in(db, definition, planned_steps(session.plan), index, values)


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
    space = _space(db, task)
    weighed = space.weights(point_of(space.definition, step["interface"], values))
    created = space.clip(weighed.weights)
    distance = _distance(db, step, created)
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
            _space(db, task)


def measured(db: Session, task: Match, step: Step, answers: Mapping[str, Any]) -> dict[str, Any]:
    """An answer with what the server measures of it: see `app.schemas.study.tasks`.

    Raises:
        InvalidError: the space has no such slider.
    """
    space = _space(db, task)
    values = {name: value for name, value in answers.items() if name != SECONDS}
    weights = space.weights(point_of(space.definition, step["interface"], values)).weights
    distance = _distance(db, step, space.clip(weights))
    in_time = not step["seen"] or answers[SECONDS] <= task.seconds
    return {
        **answers,
        "interface": step["interface"],
        "seen": int(step["seen"]),
        "distance": round(distance, 6),
        "solved": int(distance < task.threshold and in_time),
        "engine": engine_version(),
    }


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
    ids = _sliders_of(definition, interface)
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


def _sliders_of(definition: SpaceDefinition, interface: Interface) -> dict[str, str]:
    """What the page calls each slider of an interface, and what the space calls it."""
    sliders = definition.sliders(interface)
    if sliders is not None:
        return {one.id: one.id for one in sliders.primary}
    if interface == "weights":
        return {f"e{number}": one.clip for number, one in enumerate(definition.examples)}
    return {}


def page(db: Session, task: Match, language: Language) -> dict[str, Any]:
    """What the page of a match is told besides the task: sliders, and the examples' motions.

    The examples have numbers instead of names, which would give away how they were meant.
    """
    definition = _space(db, task).definition
    examples = [one.clip for one in definition.examples]
    shown = studies.media(db, examples) if task.examples else {}
    return {
        "start": START,
        "sliders": {one: _sliders(definition, one, language) for one in task.interfaces},
        "example_figures": [
            _figure(shown[clip], str(number)) for number, clip in enumerate(examples, 1) if shown
        ],
    }


def _figure(media: Media, caption: str) -> dict[str, Any]:
    return {
        "glb_url": media_url(media.glb),
        "figure_url": media.figure and media_url(media.figure),
        "cyclic": media.cyclic,
        "caption": caption,
    }


def _sliders(
    definition: SpaceDefinition, interface: Interface, language: Language
) -> list[dict[str, str]]:
    sliders = definition.sliders(interface)
    if sliders is None:
        bare = enumerate(_sliders_of(definition, interface), start=1)
        return [{"id": name, "title": str(n), "left": "", "right": ""} for n, name in bare]
    return [_slider(sliders, one, language) for one in sliders.primary]


def _slider(sliders: Sliders, one: Primary, language: Language) -> dict[str, str]:
    parameters = {parameter.id: parameter for parameter in sliders.parameters}
    members = [parameters[name] for name in one.members[:SHOWN_WORDS]]
    return {
        "id": one.id,
        "title": str(one.title.into(language)),
        "left": _listed(p.left.into(language) for p in members),
        "right": _listed(p.right.into(language) for p in members),
    }


def _listed(words: Iterable[object]) -> str:
    """Each once: the ends of all features are “less” and “more”."""
    return ", ".join(dict.fromkeys(map(str, words)))


def _space(db: Session, task: Match) -> Prepared:
    from app.services import space_motion

    return space_motion.prepared_in(db, task.space)


def _distance(db: Session, step: Step, created: Clip) -> float:
    from motion.blending.distance import matching_distance

    target = step["clips"][0]
    return float(matching_distance(_clip(clips.contents(db, [target])[target]), created))


@lru_cache(maxsize=TARGETS_KEPT)
def _clip(content: bytes) -> Clip:
    from motion.storage import clip_from_bytes

    return clip_from_bytes(content)


def _glb(clip: Clip) -> bytes:
    from motion.glb import write_clip_glb

    return write_clip_glb(clip)
