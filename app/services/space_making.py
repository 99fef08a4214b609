"""Authoring spaces computed from clips: their keytimes, features and sliders. No database.

Done in a process of ``app.workers``: 27 clips take about half a second.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from app.schemas.spaces import Example, Origin, Sliders, SpaceDefinition
from app.services.space_clips import Moments, Source, moments_of, read, told
from app.services.space_sliders import feature_sliders, rounded
from motion.blending.blender import Blender
from motion.features import features


def define(
    title: str,
    sources: Sequence[Source],
    keytimes: Mapping[str, Moments],
    adjectives: Sliders | None = None,
    origin: Origin | None = None,
    predicted: Sequence[str] = (),
) -> SpaceDefinition:
    """A space of these clips.

    Args:
        title: its name.
        sources: the examples in their order.
        keytimes: clip id to its events in seconds; those of the other clips are found.
        adjectives: the clips' places by what people said, in the same order; None if nobody did.
        origin: where the adjectives come from.
        predicted: ids of the clips that nobody judged, whose adjectives are predicted.

    Raises:
        InvalidError: the clips cannot be blended with each other.
    """
    with told():
        clips = read(sources)
        moments = moments_of(sources, clips, keytimes)
        Blender(clips, moments)  # it knows what belongs together
        values = np.stack([features(clip) for clip in clips])
    return SpaceDefinition(
        title=title,
        examples=tuple(
            Example(
                clip=source.id,
                name=source.name,
                keytimes=times,
                predicted=source.id in predicted,
            )
            for source, times in zip(sources, moments, strict=True)
        ),
        adjectives=adjectives and rounded(adjectives),
        features=feature_sliders(values),
        origin=origin or Origin(),
    )
