"""The operation that makes a new motion between examples."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from motion.blending import Blender
from motion.clip import Clip
from motion.errors import MotionError
from motion.keytimes import EVENTS, find_keytimes
from motion.recipe.operation import Context, bounded, operation
from motion.recipe.parameters import LATEST, Group, ListOf, Number, Reference

_MOST = 64


def _blend(source: Clip, context: Context, *, examples: list[dict[str, Any]]) -> Clip:
    clips = [context.materials.clips[example["clip"]] for example in examples]
    if any(clip.skeleton.content_hash != source.skeleton.content_hash for clip in clips):
        raise MotionError(
            "A blend needs one skeleton, and the source and its examples have different ones: "
            "retarget the examples onto the source's first."
        )
    moments = [_keytimes(e["keytimes"], clip) for e, clip in zip(examples, clips, strict=True)]
    blender = Blender(clips, moments)
    weights = [example["weight"] for example in examples]
    bounded(blender.frames(weights))
    return blender.blend(weights)


def _keytimes(given: Mapping[str, float | None] | None, clip: Clip) -> dict[str, float]:
    if given is None:
        return find_keytimes(clip)
    return {event: moment for event, moment in given.items() if moment is not None}


def _some_weight(values: Mapping[str, Any]) -> tuple[str, str] | None:
    if any(example["weight"] > 0.0 for example in values["examples"]):
        return None
    return "All weights are 0.", "Give at least one example a weight above 0."


BLEND = operation(
    "blend@1",
    "Blend of examples",
    "A motion between examples, each with its weight; it takes the place of the motion so far.",
    {
        "examples": ListOf(
            title="Examples",
            description="Of the same skeleton; all loop, or none. Only the weights' ratios count.",
            shortest=1,
            longest=_MOST,
            item=Group(
                title="Example",
                members={
                    "clip": Reference(title="Clip", description="Its id.", kind="clip"),
                    "weight": Number(
                        title="Weight",
                        description="0 none; its share is this by the sum of all weights.",
                        minimum=0.0,
                        maximum=1.0,
                    ),
                    "keytimes": Group(
                        title="Keytimes",
                        description="When its feet strike and leave the floor; found if left out.",
                        optional=True,
                        members={
                            event: Number(
                                title=event.replace("_", " ").capitalize(),
                                unit="s",
                                minimum=0.0,
                                maximum=LATEST,
                                optional=True,
                            )
                            for event in EVENTS
                        },
                    ),
                },
            ),
        )
    },
    _blend,
    # Judged against itself: a source that walks otherwise stands at other times.
    follow=_blend,
    rule=_some_weight,
)
