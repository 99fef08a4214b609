"""The next version of a space: other keytimes, or clips that nobody judged."""

from __future__ import annotations

from app.errors import InvalidError
from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.spaces import (
    MOST_EXAMPLES,
    NewVersion,
    Prediction,
    SpaceDefinition,
    SpaceDetail,
)
from app.services import new_spaces, spaces
from app.workers import Workers

# ``space_joining`` is imported where it is used: it brings SciPy, for which the server's start
# shall not wait.


def create(
    database: Database,
    writer: Writer,
    workers: Workers,
    space_id: str,
    request: NewVersion,
    made_by: int,
) -> SpaceDetail:
    """Make the next version of a space; the one before stays as it is.

    Raises:
        ConflictError: a joining clip waits to be confirmed.
        InvalidError: nothing changes, or the clips cannot be blended or predicted.
        NotFoundError: there is no such space or clip.
    """
    from app.services import space_joining

    with database.reading() as db:
        before = spaces.definition(db, space_id)
        clip_ids = _members(before, request)
        keytimes = {example.clip: example.keytimes for example in before.examples}
        keytimes |= request.keytimes
        gathered = new_spaces.sources(db, clip_ids, keytimes)
        study_id = spaces.study_of(db, space_id)
    defined = workers.run(space_id, space_joining.renew, before, gathered, keytimes)
    made = writer.write(lambda db: new_spaces.keep(db, defined, study_id=study_id, made_by=made_by))
    return spaces.detail(database, made.id)


def predict(database: Database, workers: Workers, space_id: str, clip_id: str) -> Prediction:
    """The impressions that a clip would have.

    Raises:
        ConflictError: the clip waits to be confirmed.
        NotFoundError: there is no such space or clip.
    """
    from app.services import space_joining

    with database.reading() as db:
        known = spaces.definition(db, space_id)
        gathered = new_spaces.sources(db, [known.examples[0].clip, clip_id])
    return workers.run(space_id, space_joining.predict, known, *gathered)


def _members(before: SpaceDefinition, request: NewVersion) -> list[str]:
    """The next version's clips.

    Raises:
        InvalidError: nothing changes, there are too many clips, or one is there already.
    """
    now = {example.clip: example for example in before.examples}
    for clip_id in request.join:
        if clip_id in now:
            raise InvalidError(
                f"“{now[clip_id].name}” is an example of this space already.",
                code="clip_twice",
                where={"field": "join", "clip": clip_id},
                mend="Join other clips only.",
            )
    clip_ids = [*now, *request.join]
    if len(clip_ids) > MOST_EXAMPLES:
        raise InvalidError(
            f"With these the space has {len(clip_ids)} clips; it takes {MOST_EXAMPLES} at most.",
            code="space_too_large",
            where={"field": "join"},
            mend=f"Join {MOST_EXAMPLES - len(now)} clips at most.",
        )
    new_spaces.check_once(clip_ids)
    new_spaces.check_keytimes(request.keytimes, clip_ids)
    edited = [
        c for c, moments in request.keytimes.items() if c in now and moments != now[c].keytimes
    ]
    if not edited and not request.join:
        raise InvalidError(
            "This version would be the same as the one before.",
            code="nothing_changes",
            mend="Change a keytime, or join a clip.",
        )
    return clip_ids
