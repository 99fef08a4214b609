"""Feet that an operation has moved stand again."""

from __future__ import annotations

from collections.abc import Iterable

from motion.clip import Clip
from motion.editing.foot_repair import repair_feet
from motion.editing.limbs import is_locomoting
from motion.quality.pair import matched
from motion.recipe.operation import Context, operation

LEGS = tuple(f"{side}_{part}" for side in ("left", "right") for part in ("thigh", "shin", "foot"))
_MOVING = ("hips", *LEGS, "left_toes", "right_toes")


def standing_again(before: Clip, edited: Clip) -> Clip:
    """The edited clip with feet that stand where they stood; as it is where no legs are known."""
    known = all(role in before.skeleton.roles for role in LEGS)
    moves = edited is not before and edited.frames > 1
    return repair_feet(before, edited) if known and moves else edited


def standing_in_place(before: Clip, edited: Clip) -> Clip:
    """As ``standing_again``, but only if the body stays in its place.

    Legs that walk are left out of timing, or walk to their own; only where they stand is known.
    """
    return edited if is_locomoting(before) else standing_again(before, edited)


def moves_feet(roles: Iterable[str]) -> bool:
    """Whether feet leave their place when the joints of these roles turn."""
    return any(role in _MOVING for role in roles)


def _repair_feet(clip: Clip, context: Context) -> Clip:
    if clip.frames < 2:
        return clip
    return repair_feet(matched(context.unedited(), clip).original, clip)


REPAIR_FEET = operation(
    "repair_feet@1",
    "Repair feet",
    "Feet stand again when they stood in the unedited motion, and hips follow them.",
    {},
    _repair_feet,
    needs=LEGS,
)
