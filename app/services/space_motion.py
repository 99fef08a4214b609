"""A space asked for motion, within a slider's drag.

A space asked for is kept prepared in the server's own process: its examples are parsed, turned so
that their cycles begin together, and the maps from sliders to weights are computed. Done in the
thread pool, because sending a motion from another process would take longer than blending it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from sqlalchemy.orm import Session

from app.errors import InvalidError
from app.persistence import clips
from app.persistence.engine import Database
from app.schemas.spaces import SpaceDefinition
from app.services import spaces
from app.services.space_clips import Source, read, told
from app.services.space_points import Points, Recent
from motion import Clip
from motion.blending.blender import Blender
from motion.glb import write_clip_glb

SPACES_KEPT = 4


@dataclass(frozen=True, eq=False)
class Prepared(Points):
    """A space ready to be asked for motion."""

    _blender: Blender

    @classmethod
    def of(cls, definition: SpaceDefinition, contents: Mapping[str, bytes]) -> Prepared:
        """A space from its definition and its clips' bytes by their ids.

        Raises:
            InvalidError: a clip is missing.
        """
        examples = definition.examples
        missing = [example.name for example in examples if example.clip not in contents]
        if missing:
            raise InvalidError(
                f"The clip “{missing[0]}” of this space is missing.",
                code="clip_missing",
                where={"field": "clips", "name": missing[0]},
                mend="Restore it from a backup of the server, or make the space without it.",
            )
        sources = [Source(one.clip, one.name, contents[one.clip]) for one in examples]
        with told():
            return cls(definition, Blender(read(sources), [one.keytimes for one in examples]))

    def clip(self, weights: Sequence[float]) -> Clip:
        """The blend of the examples by their weights.

        Raises:
            InvalidError: they cannot be blended.
        """
        with told():
            return self._blender.blend(np.array(weights))

    def glb(self, weights: Sequence[float]) -> bytes:
        """The blend as GLB without a figure."""
        return write_clip_glb(self.clip(weights))


# By the id alone: it is the hash of all that a space is made of, in whichever database.
_prepared: Recent[str, Prepared] = Recent(SPACES_KEPT)


def prepared(database: Database, space_id: str) -> Prepared:
    """The space, ready; the last ones are kept. No connection is held while one is made ready.

    Raises:
        NotFoundError: there is no such space, or none any more.
    """
    with database.reading() as db:
        spaces.check(db, space_id)

    def read_anew() -> Prepared:
        with database.reading() as db:
            found = _read(db, space_id)
        return Prepared.of(*found)

    return _prepared.get(space_id, read_anew)


def prepared_in(db: Session, space_id: str) -> Prepared:
    """The same for whoever is reading or writing already, for a study: so the space stays."""
    return _prepared.get(space_id, lambda: Prepared.of(*_read(db, space_id)))


def _read(db: Session, space_id: str) -> tuple[SpaceDefinition, dict[str, bytes]]:
    definition = spaces.definition(db, space_id)
    return definition, clips.contents(db, [example.clip for example in definition.examples])
