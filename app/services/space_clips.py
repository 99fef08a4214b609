"""Clips that become the examples of a space: whether they can be blended with each other."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

from app.errors import InvalidError
from motion import Clip, MotionError
from motion.keytimes import EVENTS, find_keytimes
from motion.storage import clip_from_bytes

Moments = Mapping[str, float]

DIGITS = 6  # of stored places and times: finer ones would be noise, and change the space's id
MOST_FRAMES = 40_000  # of all examples: about 150 MB while a space is being blended


@dataclass(frozen=True)
class Source:
    """A clip that becomes an example: id, name, bytes."""

    id: str
    name: str
    content: bytes


def moments_of(
    sources: Sequence[Source], clips: Sequence[Clip], given: Mapping[str, Moments]
) -> list[dict[str, float]]:
    """Every clip's events in seconds: those that are given by its id, or else found.

    Raises:
        InvalidError: one has none while others have some, or an event has a name of its own.
    """
    moments = [
        _rounded(_known(given[source.id], source) if source.id in given else find_keytimes(clip))
        for source, clip in zip(sources, clips, strict=True)
    ]
    _check_steps(sources, moments)
    return moments


def found_keytimes(content: bytes) -> dict[str, float]:
    """The events of a stored clip, in seconds; none where it does not step."""
    return _rounded(find_keytimes(clip_from_bytes(content)))


@contextmanager
def told() -> Iterator[None]:
    """What clips make impossible is the request's fault, not ours."""
    try:
        yield
    except MotionError as error:
        raise InvalidError(str(error), code="motion_unusable") from error


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


def _check_steps(sources: Sequence[Source], moments: Sequence[Moments]) -> None:
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
