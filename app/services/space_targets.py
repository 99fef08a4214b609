"""Motions to be matched: drawn at random in a space, far from each other. No database.

Done in a process of ``app.workers``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from app.errors import InvalidError
from app.schemas.spaces import (
    START,
    Point,
    SpaceDefinition,
    Target,
    TargetList,
    TargetRequest,
)
from app.schemas.study import Interface
from app.services.space_motion import Prepared
from motion import Clip
from motion.blending.distance import matching_distance

SPARE = 40  # so many more points are drawn than are wanted
_DIGITS = 3  # of a drawn point


def draw(
    definition: SpaceDefinition, contents: Mapping[str, bytes], request: TargetRequest
) -> TargetList:
    """Targets at random points of the primary adjectives, in the order in which they were drawn.

    Of more points than are wanted those are taken whose motions lie far apart: always the one that
    is farthest from all taken (Gonzalez 1985), and from where the sliders stand at first, so that
    no target is matched before anybody moves one.

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
    starts = [ready.clip(ready.weights(point).weights) for point in _starts(definition)]
    clips = [ready.clip(ready.weights(point).weights) for point in points]
    taken = sorted(_far_apart(starts, clips, request.count))
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


def _starts(definition: SpaceDefinition) -> list[Point]:
    """Where the sliders of every interface stand at first."""
    names: dict[Interface, list[str]] = {"weights": [one.clip for one in definition.examples]}
    for interface in ("adjectives", "features"):
        if sliders := definition.sliders(interface):
            names[interface] = [one.id for one in sliders.primary]
    return [
        Point(interface=interface, values=dict.fromkeys(ids, START))
        for interface, ids in names.items()
        if ids
    ]


def _far_apart(starts: Sequence[Clip], clips: Sequence[Clip], count: int) -> list[int]:
    """The numbers of clips that lie far from each other and from where one begins."""
    taken: list[int] = []
    nearest = np.min([[matching_distance(one, clip) for clip in clips] for one in starts], axis=0)
    while len(taken) < count:
        taken.append(int(np.argmax(nearest)))
        apart = [matching_distance(clips[taken[-1]], clip) for clip in clips]
        nearest = np.minimum(nearest, apart)
        nearest[taken] = -1.0
    return taken
