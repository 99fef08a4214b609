"""Bodies that clips share, and how well a motion would fit another one."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict

from app.schemas.library import ClipView

# What becomes of a motion first: nothing, its best stride is cut out, or all of it is one cycle.
CycleCut = Literal["none", "found", "whole"]


class SkeletonView(BaseModel):
    """A skeleton of the library that a figure can stand on.

    Attributes:
        id: what its clips tell as their ``skeleton_hash``.
        clips: how many kept clips move it.
        example: one of them, by which people know the body; a recipe names it to put a motion
            onto this skeleton.
    """

    id: str
    clips: int
    example: ClipView


class SkeletonList(BaseModel):
    """The skeletons of the library, that with most clips first."""

    skeletons: list[SkeletonView]


class Retargeting(BaseModel):
    """How well a motion would fit the skeleton of another clip.

    Attributes:
        same: both clips move the same skeleton already.
        fits: whether what changes stays within what a viewer would hardly see.
        sentence: all of this in words.
        mean_direction, greatest_direction: radians between the directions of the limbs' segments
            before and after, over all frames.
        slip: metres, the farthest that a point of a sole slides while it stands.
        sole_height: metres that a standing sole is above or below the floor, in the mean.
        unmapped: body roles that only one of the two skeletons has.
        resting: joints of the new skeleton that rest as in standing: their role is in it alone, or
            they have none.
    """

    model_config = ConfigDict(
        json_schema_extra={
            "example": {
                "same": False,
                "fits": True,
                "sentence": "The motion fits: limbs point where they pointed within 1.2°, "
                "standing feet slide by 4 mm at most and are 1 mm off the floor. "
                "One joint of the new body rests: LeftToe.",
                "mean_direction": 0.004,
                "greatest_direction": 0.021,
                "slip": 0.004,
                "sole_height": 0.001,
                "unmapped": [],
                "resting": ["LeftToe"],
            }
        }
    )

    same: bool
    fits: bool
    sentence: str
    mean_direction: float
    greatest_direction: float
    slip: float
    sole_height: float
    unmapped: list[str]
    resting: list[str]
