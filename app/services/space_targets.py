"""Motions to be matched: drawn at random in a space, far from each other. No database.

Done in a process of ``app.workers``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from app.errors import InvalidError
from app.schemas.spaces import Point, SpaceDefinition, Target, TargetList, TargetRequest
from app.services.space_motion import Prepared
from motion import Clip
from motion.blending.distance import matching_distance

SPARE = 40  # so many more points are drawn than are wanted
_DIGITS = 3  # of a drawn point


def draw(
    definition: SpaceDefinition, contents: Mapping[str, bytes], request: TargetRequest
) -> TargetList:
    """Targets at random points of the primary adjectives, in the order in which they were drawn.

    Of more points than are wanted those are taken whose motions lie far apart: the first drawn,
    then always the one that is farthest from all taken (Gonzalez 1985).

    Raises:
        InvalidError: the space has no adjectives.
    """
    if definition.adjectives is None:
        raise InvalidError(
            "Targets are drawn from a space's adjectives, and nobody has judged its clips.",
            code="no_adjectives",
            mend="Take a space that was made of a study's answers.",
        )
    ready = Prepared.of(definition, contents)
    names = [one.id for one in definition.adjectives.primary]
    drawn = np.random.default_rng(request.seed).random((request.count + SPARE, len(names)))
    points = [_point(names, row) for row in drawn]
    clips = [ready.clip(ready.weights(point).weights) for point in points]
    taken = sorted(_far_apart(clips, request.count))
    return TargetList(
        targets=[
            Target(
                **ready.recipe(points[place]).model_dump(),
                name=f"Target {number}",
                values=points[place].values,
            )
            for number, place in enumerate(taken, start=1)
        ]
    )


def _point(names: Sequence[str], row: np.ndarray) -> Point:
    values = {name: round(float(v), _DIGITS) for name, v in zip(names, row, strict=True)}
    return Point(interface="adjectives", values=values)


def _far_apart(clips: Sequence[Clip], count: int) -> list[int]:
    taken = [0]
    nearest = np.full(len(clips), np.inf)
    while len(taken) < count:
        last = clips[taken[-1]]
        apart = [matching_distance(last, clip) for clip in clips]
        nearest = np.minimum(nearest, apart)
        nearest[taken] = -1.0
        taken.append(int(np.argmax(nearest)))
    return taken
