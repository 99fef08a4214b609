"""Motions and other bodies: which skeletons the library has, and how well a motion would fit one.

The clip itself is made by an ordinary recipe (``cycle@1``, ``retarget@1``).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sqlalchemy.orm import Session

from app.persistence import clips
from app.persistence.engine import Database
from app.persistence.models import ClipRecord
from app.schemas.library import ClipView
from app.schemas.retargets import CycleCut, Retargeting, SkeletonList, SkeletonView
from app.services import edits, library
from app.workers import Workers

# A viewer hardly sees limbs turn by less, or feet slide or float by less than a centimetre.
MOST_TURNED = math.radians(10.0)
MOST_SLIP = MOST_HEIGHT = 0.01  # m
_NAMED = 3


def skeletons(db: Session) -> SkeletonList:
    """The skeletons that kept clips move and a figure can stand on, that with most clips first."""
    moved: dict[str, list[tuple[ClipRecord, str]]] = {}
    for clip, figure in clips.listed(db, imported=True):
        if figure is not None and clip.state == "kept":
            moved.setdefault(clip.skeleton_hash, []).append((clip, figure))
    found = [
        SkeletonView(id=skeleton, clips=len(all_of_it), example=_example(all_of_it))
        for skeleton, all_of_it in moved.items()
    ]
    return SkeletonList(skeletons=sorted(found, key=lambda one: (-one.clips, one.example.name)))


def retargeting(
    database: Database, workers: Workers, clip_id: str, onto: str, cycle: CycleCut
) -> Retargeting:
    """How well a clip's motion would fit the skeleton of another clip; nothing is stored.

    Raises:
        ConflictError: the clip that shows the skeleton waits to be confirmed.
        InvalidError: a body role is missing that a human body needs, or there is no cycle to cut.
        NotFoundError: there is no such clip.
    """
    from app.services import rendering

    with database.reading() as db:
        clip = library.find(db, clip_id, signed_in=True)
        body = edits.source_clip(db, onto)
        same = clip.skeleton_hash == body.skeleton_hash
        stored = library.content(db, clip), library.content(db, body)
    told = workers.run(clip_id, rendering.retarget_error, *stored, cycle)
    fits = (
        told["greatest_direction"] <= MOST_TURNED
        and told["slip"] <= MOST_SLIP
        and told["sole_height"] <= MOST_HEIGHT
    )
    sentence = _sentence(told, same, fits)
    return Retargeting.model_validate({**told, "same": same, "fits": fits, "sentence": sentence})


def _example(moving: Sequence[tuple[ClipRecord, str]]) -> ClipView:
    """The clip that shows a skeleton best: a plain walk if there is one."""
    clip, figure = min(
        moving, key=lambda one: (not one[0].cyclic, "neutral" not in one[0].tags.values())
    )
    return library.view(clip, figure)


def _sentence(told: dict[str, Any], same: bool, fits: bool) -> str:
    if same:
        return "Both clips move the same skeleton already: nothing has to be put onto it."
    judged = "The motion fits" if fits else "The motion fits loosely"
    turned = max(0.1, math.degrees(told["greatest_direction"]))  # nothing is exact to the last bit
    slip, height = (max(1.0, 1000.0 * told[name]) for name in ("slip", "sole_height"))
    words = (
        f"{judged}: limbs point where they pointed within {turned:.1f}°, standing feet slide by "
        f"{slip:.0f} mm at most and are {height:.0f} mm off the floor."
    )
    resting = told["resting"]
    if not resting:
        return words
    if len(resting) == 1:
        return f"{words} One joint of the new body rests: {resting[0]}."
    named = ", ".join(resting[:_NAMED]) + (" …" if len(resting) > _NAMED else "")
    return f"{words} {len(resting)} joints of the new body rest: {named}."
