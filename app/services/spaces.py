"""Authoring spaces: which there are, what is in one, and what its sliders mean.

They are made in ``new_spaces``, followed by others in ``space_versions`` and deleted in
``space_deletion``. Points of a space become motion in ``space_motion``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.persistence import clips, graphs, spaces
from app.persistence.engine import Database
from app.persistence.models import ClipRecord
from app.schemas.live import Role
from app.schemas.spaces import (
    ExampleClip,
    KeytimesView,
    ListedSpace,
    Point,
    SpaceDefinition,
    SpaceDetail,
    SpaceLine,
    SpaceList,
    SpaceRecipe,
    TargetList,
    TargetRequest,
    Weighed,
)
from app.schemas.study import Interface
from app.services import library, rights
from app.services.studies import media_url
from app.workers import Workers

if TYPE_CHECKING:  # it brings SciPy, for which the server's start shall not wait
    from app.services.space_motion import Prepared

Roles = dict[int, Role]
# Of the sample walks by set, as `space_samples` makes them.
SAMPLES = {
    "set_a": "Walks of set A (simulated raters)",
    "set_b": "Walks of set B (simulated raters)",
}


def has_samples(db: Session) -> bool:
    """Whether the sample spaces were made."""
    return all(spaces.is_named(db, name) for name in SAMPLES.values())


def listed(db: Session, researcher_id: int) -> SpaceList:
    """All spaces, newest first, as a researcher may know them."""
    roles = rights.visible(db, researcher_id)
    return SpaceList(
        spaces=[
            ListedSpace(
                **_line(space).model_dump(),
                study_title=space.study_title if space.record.study_id in roles else None,
                may_delete=may_delete(space, roles, researcher_id),
            )
            for space in spaces.listed(db)
        ]
    )


def may_delete(space: spaces.Space, roles: Roles, researcher_id: int) -> bool:
    """Whether a researcher may: who made it, who may change its study, of clips alone everybody.

    Args:
        space: which one.
        roles: what the researcher is in which studies.
        researcher_id: who.
    """
    made_by, study_id = space.record.made_by, space.record.study_id
    if made_by is None:  # it comes with the server
        return False
    if study_id is None or made_by == researcher_id:
        return True
    return roles.get(study_id) in rights.NEEDED["edit"]


def check(db: Session, space_id: str) -> None:
    """Refuses an id that no space has.

    Raises:
        NotFoundError: there is no such space.
    """
    if not spaces.exists(db, space_id):
        raise _not_found()


def find(db: Session, space_id: str) -> spaces.Space:
    """A space with what its row refers to.

    Raises:
        NotFoundError: there is no such space.
    """
    found = spaces.by_id(db, space_id)
    if found is None:
        raise _not_found()
    return found


def line(db: Session, space_id: str) -> SpaceLine:
    """One space as the list shows it."""
    return _line(find(db, space_id))


def definition(db: Session, space_id: str) -> SpaceDefinition:
    """A space as it was frozen.

    Raises:
        NotFoundError: there is no such space.
    """
    return SpaceDefinition.model_validate(find(db, space_id).record.definition)


def study_of(db: Session, space_id: str) -> int | None:
    """The study that a space was made of."""
    return find(db, space_id).record.study_id


def detail(database: Database, space_id: str) -> SpaceDetail:
    """A space with its numbers and its clips' files."""
    ready = _prepared(database, space_id)
    with database.reading() as db:
        known = line(db, space_id)
        members = graphs.members(db, [example.clip for example in ready.definition.examples])
    return SpaceDetail(
        **known.model_dump(),
        definition=ready.definition,
        clips=[_example_clip(*members[example.clip]) for example in ready.definition.examples],
        notes={interface: ready.notes(interface) for interface in known.interfaces},
    )


def weights(database: Database, space_id: str, point: Point) -> Weighed:
    """What a point means."""
    return _prepared(database, space_id).weights(point)


def motion(database: Database, space_id: str, point: Point) -> tuple[Weighed, bytes]:
    """What a point means, and its motion as GLB without a figure. Nothing is stored."""
    ready = _prepared(database, space_id)
    weighed = ready.weights(point)
    return weighed, ready.glb(weighed.weights)


def recipe(database: Database, space_id: str, point: Point) -> SpaceRecipe:
    """A point as an ordinary recipe."""
    return _prepared(database, space_id).recipe(point)


def targets(
    database: Database, workers: Workers, space_id: str, request: TargetRequest
) -> TargetList:
    """Motions to be matched, drawn by seed.

    Raises:
        InvalidError: the space has no adjectives.
    """
    from app.services import space_targets

    with database.reading() as db:
        known = definition(db, space_id)
        contents = clips.contents(db, [example.clip for example in known.examples])
    return workers.run(space_id, space_targets.draw, known, contents, request)


def keytimes(database: Database, workers: Workers, clip_id: str) -> KeytimesView:
    """The events found in a clip."""
    from app.services import space_clips

    with database.reading() as db:
        stored = library.content(db, library.find(db, clip_id, signed_in=True))
    return KeytimesView(keytimes=workers.run(clip_id, space_clips.found_keytimes, stored))


def _prepared(database: Database, space_id: str) -> Prepared:
    from app.services import space_motion

    return space_motion.prepared(database, space_id)


def _not_found() -> NotFoundError:
    return NotFoundError(
        "There is no such space.", code="space_not_found", mend="Look for it under Spaces."
    )


def _line(space: spaces.Space) -> SpaceLine:
    record = space.record
    interfaces: list[Interface] = ["features", "weights"]
    if record.definition["adjectives"]:
        interfaces.insert(0, "adjectives")
    return SpaceLine(
        id=record.id,
        name=record.name,
        number=record.number,
        newest=record.number == space.newest,
        examples=len(record.definition["examples"]),
        interfaces=interfaces,
        simulated=record.definition["origin"]["kind"] == "simulated",
        study=space.study,
        made_by=space.made_by,
        created_at=record.created_at,
    )


def _example_clip(clip: ClipRecord, figure: str | None) -> ExampleClip:
    return ExampleClip(
        clip=clip.id,
        name=clip.name,
        glb_url=media_url(clip.glb_blob),
        figure_url=figure and media_url(figure),
        duration=clip.duration,
    )
