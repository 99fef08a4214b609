"""The authoring spaces that a study file names: to match targets in, and to make stimuli with."""

from __future__ import annotations

from collections.abc import Iterator

from sqlalchemy.orm import Session

from app.errors import MannerError
from app.persistence import spaces
from app.persistence.spaces import Space
from app.schemas.edits import Edit
from app.schemas.spaces import Point, SpaceDefinition
from app.schemas.studies_api import Problem
from app.schemas.study import Authored, Match
from app.services.study_text import Path, short


def find(db: Session, reference: str) -> Space | None:
    """The space with this id, or the newest one of this name."""
    return spaces.by_id(db, reference) or spaces.newest_named(db, reference)


def named(content: object) -> set[str]:
    """The names and ids of all spaces in a study file, however wrong it is otherwise."""
    if isinstance(content, dict):
        own = content.get("space")
        return set().union([own] if isinstance(own, str) else [], *map(named, content.values()))
    if isinstance(content, list):
        return set().union(*map(named, content))
    return set()


def problems(db: Session, task: Match, path: Path) -> Iterator[Problem]:
    """What is wrong with the space that targets are to be matched in."""
    space = find(db, task.space)
    if space is None:
        yield missing(task.space, (*path, "space"))
        return
    definition = SpaceDefinition.model_validate(space.record.definition)
    if "adjectives" in task.interfaces and definition.adjectives is None:
        yield Problem(
            where=[*path, "interfaces"],
            message=f"Nobody has judged the clips of “{definition.title}”: it has no adjectives.",
            mend="Take adjectives out, or name another space.",
        )


def missing(reference: str, path: Path) -> Problem:
    """That there is no such space."""
    return Problem(
        where=list(path),
        message=f"There is no authoring space “{short(reference)}”.",
        mend="The studio lists the spaces; give a name or an id from there.",
    )


def edit_of(db: Session, made: Authored) -> Edit | None:
    """The recipe of a point in a space, as an edit; None where there is no such space.

    Raises:
        InvalidError: the space has no such slider.
    """
    from app.services import space_points

    space = find(db, made.space)
    if space is None:
        return None
    point = Point(interface=made.interface, values=dict(made.values))
    recipe = space_points.points_in(db, space.record.id).recipe(point)
    return Edit(source=recipe.source, operations=recipe.operations)


def fault_of(path: Path, error: MannerError) -> Problem:
    """What is wrong with a point."""
    return Problem(where=[*path, "made", "values"], message=error.message, mend=error.mend)
