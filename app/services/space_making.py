"""Authoring spaces computed from clips: their keytimes, features and sliders. No database.

Done in a process of ``app.workers``: 27 clips take about half a second.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from app.errors import InvalidError
from app.schemas.spaces import (
    Example,
    Origin,
    Parameter,
    Primary,
    Sliders,
    SpaceDefinition,
)
from app.schemas.study import Words
from app.statistics.ward import Labels, cluster_means, cut, ward
from motion import Clip, MotionError
from motion.blending.blender import Blender
from motion.features import FEATURE_GROUPS, FEATURES, features
from motion.keytimes import EVENTS, find_keytimes
from motion.storage import clip_from_bytes

Array = NDArray[np.float64]
Moments = Mapping[str, float]

CLUSTERS = 4
DIGITS = 6  # of stored places and times: finer ones would be noise, and change the space's id
MOST_FRAMES = 40_000  # of all examples: about 150 MB while a space is being blended
_SAME = 1e-9


@dataclass(frozen=True)
class Source:
    """A clip that becomes an example: id, name, bytes."""

    id: str
    name: str
    content: bytes


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
        moments = [
            _rounded(
                _known(keytimes[source.id], source)
                if source.id in keytimes
                else find_keytimes(clip)
            )
            for source, clip in zip(sources, clips, strict=True)
        ]
        _check_moments(sources, moments)
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
        adjectives=adjectives and _with_rounded_values(adjectives),
        features=feature_sliders(values),
        origin=origin or Origin(),
    )


def found_keytimes(content: bytes) -> dict[str, float]:
    """The events of a stored clip, in seconds; none where it does not step."""
    return _rounded(find_keytimes(clip_from_bytes(content)))


def read(sources: Sequence[Source]) -> list[Clip]:
    """The clips of a space.

    Raises:
        InvalidError: they have different skeletons, only some are cycles, or they are too long.
    """
    clips = [clip_from_bytes(source.content) for source in sources]
    _check_skeletons(sources, clips)
    _check_cycles(sources, clips)
    frames = sum(clip.frames for clip in clips)
    if frames > MOST_FRAMES:
        raise InvalidError(
            f"These clips have {frames:,} frames together; a space takes up to {MOST_FRAMES:,}.",
            code="space_too_long",
            where={"field": "clips"},
            mend="Cut one cycle out of each first, by a recipe with cycle@1, or leave some out.",
        )
    return clips


def feature_sliders(values: Array) -> Sliders:
    """Sliders of the 51 features (examples, 51): each from 0 to 1, and clusters of them.

    A single slider goes from the least to the greatest value of any example; where all are equal
    they stand in the middle. The clusters are Ward's on standardised columns; the slider of one is
    the mean of its members' standardised columns, again from its least to its greatest.
    """
    low, high = values.min(axis=0), values.max(axis=0)
    single = scaled(values)
    columns = standardised(values)
    labels = cut(ward(columns.T), CLUSTERS)
    together = scaled(cluster_means(columns, labels))
    return Sliders(
        primary=tuple(
            Primary(
                id=f"{group}_group",
                title=Words(FEATURE_GROUPS[group]),
                members=tuple(
                    f.id for f, label in zip(FEATURES, labels, strict=True) if label == n
                ),
                values=as_values(together[:, n]),
            )
            for n, group in enumerate(_titles(labels))
        ),
        parameters=tuple(
            Parameter(
                id=feature.id,
                title=Words(feature.title),
                about=feature.description,
                left=Words("less"),
                right=Words("more"),
                unit=feature.unit,
                lowest=round(float(low[n]), DIGITS),
                highest=round(float(high[n]), DIGITS),
                values=as_values(single[:, n]),
            )
            for n, feature in enumerate(FEATURES)
        ),
    )


def scaled(values: Array) -> Array:
    """Columns (examples, n) from 0, the least, to 1, the greatest; equal ones become 0.5."""
    low, span = values.min(axis=0), np.ptp(values, axis=0)
    varies = _varies(values)
    return np.where(varies, (values - low) / np.where(varies, span, 1.0), 0.5)


def standardised(values: Array) -> Array:
    """Columns (examples, n) with mean 0 and standard deviation 1; equal ones become 0."""
    varies = _varies(values)
    spread = np.where(varies, values.std(axis=0), 1.0)
    return np.where(varies, (values - values.mean(axis=0)) / spread, 0.0)


def as_values(column: Array) -> tuple[float, ...]:
    """A column (examples,) as it is stored."""
    return tuple(round(float(value), DIGITS) + 0.0 for value in np.clip(column, 0.0, 1.0))


@contextmanager
def told() -> Iterator[None]:
    """What clips make impossible is the request's fault, not ours."""
    try:
        yield
    except MotionError as error:
        raise InvalidError(str(error), code="motion_unusable") from error


def _varies(values: Array) -> NDArray[np.bool_]:
    return np.asarray(np.ptp(values, axis=0) > _SAME * np.maximum(1.0, np.abs(values).max(axis=0)))


def _titles(labels: Labels) -> list[str]:
    """The paper's group that each cluster overlaps most, no group twice."""
    groups = list(FEATURE_GROUPS)
    ours = np.arange(CLUSTERS)[:, None] == labels
    theirs = np.array([[feature.group == group for feature in FEATURES] for group in groups])
    shared = ours.astype(float) @ theirs.T
    either = ours.sum(axis=1)[:, None] + theirs.sum(axis=1) - shared
    _, chosen = linear_sum_assignment(shared / either, maximize=True)
    return [groups[group] for group in chosen]


def _check_skeletons(sources: Sequence[Source], clips: Sequence[Clip]) -> None:
    first = clips[0].skeleton.content_hash
    others = _where(sources, clips, lambda clip: clip.skeleton.content_hash != first)
    if others:
        raise InvalidError(
            f"{_named(others)} a skeleton other than that of “{sources[0].name}”.",
            code="skeletons_differ",
            where={
                "field": "clips",
                "clips": [source.id for source in others],
                "onto": sources[0].id,
            },
            mend=f"Put them onto it first, by a recipe with retarget@1 and the clip "
            f"“{sources[0].name}”.",
        )


def _check_cycles(sources: Sequence[Source], clips: Sequence[Clip]) -> None:
    others = _where(sources, clips, lambda clip: not clip.cyclic)
    if others and len(others) < len(sources):
        raise InvalidError(
            f"{_named(others)} no cycle, while other clips of the space are.",
            code="cycles_differ",
            where={"field": "clips", "clips": [source.id for source in others]},
            mend="Cut one cycle out of them first, by a recipe with cycle@1.",
        )


def _check_moments(sources: Sequence[Source], moments: Sequence[Moments]) -> None:
    others = [one for one, known in zip(sources, moments, strict=True) if not known]
    if others and len(others) < len(sources):
        raise InvalidError(
            f"{_named(others)} no keytimes: no step was found, while other clips step.",
            code="keytimes_missing",
            where={"field": "keytimes", "clips": [source.id for source in others]},
            mend="Give their heel strikes and toe-offs, or leave these clips out.",
        )


def _where(
    sources: Sequence[Source], clips: Sequence[Clip], is_so: Callable[[Clip], bool]
) -> list[Source]:
    return [source for source, clip in zip(sources, clips, strict=True) if is_so(clip)]


def _named(sources: Sequence[Source]) -> str:
    """The subject of a sentence, with its verb."""
    names = [f"“{source.name}”" for source in sources]
    if len(names) == 1:
        return f"{names[0]} has"
    listed = names if len(names) < 4 else [*names[:2], f"{len(names) - 2} more"]
    return f"{', '.join(listed[:-1])} and {listed[-1]} have"


def _known(moments: Moments, source: Source) -> Moments:
    """Refuses events that no recipe could name."""
    for event in moments:
        if event not in EVENTS:
            raise InvalidError(
                f"“{source.name}” has a keytime “{event}”, which is no event of a walk.",
                code="keytime_unknown",
                where={"field": "keytimes", "clip": source.id, "event": event},
                mend=f"Give {', '.join(EVENTS)}.",
            )
    return moments


def _rounded(moments: Moments) -> dict[str, float]:
    return {event: round(float(time), DIGITS) for event, time in moments.items()}


def _with_rounded_values(sliders: Sliders) -> Sliders:
    def of(one: Primary | Parameter) -> dict[str, object]:
        return {"values": as_values(np.array(one.values))}

    return Sliders(
        primary=tuple(one.model_copy(update=of(one)) for one in sliders.primary),
        parameters=tuple(one.model_copy(update=of(one)) for one in sliders.parameters),
    )
