"""The steps of a clip: where each foot is set down, seen from the other one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.editing.foot_plants import Foot, find_feet
from motion.features.view import View

Array = NDArray[np.float64]

_FLICKER = 0.12  # s: a foot that leaves the floor for less has not been lifted
_BRIEF = 0.05  # s: a foot that touches the floor for less does not carry


@dataclass(frozen=True)
class Step:
    """A foot set down while or after the other one stood.

    Attributes:
        side: left or right, of the foot that is set down.
        time: s from the clip's first frame.
        forward: m along the heading from where the other foot stood.
        outward: m across it, towards the side of the foot that is set down.
    """

    side: str
    time: float
    forward: float
    outward: float


@dataclass(frozen=True)
class _Plant:
    """A foot on the floor: frames of the longer clip, and where (3,) left, up, forward."""

    side: str
    start: int
    stop: int
    place: Array


def find_steps(view: View) -> list[Step]:
    """The steps whose foot is set down within a clip, in time; of a cyclic one each once.

    Raises:
        MotionError: if a leg's roles are missing.
    """
    plants = sorted(_plants(view), key=lambda plant: plant.start)
    steps = []
    last: dict[str, _Plant] = {}
    for plant in plants:
        other = last.get("right" if plant.side == "left" else "left")
        last[plant.side] = plant
        if other is None or not _within(view, plant.start):
            continue
        way = plant.place - other.place
        outward = way[0] if plant.side == "left" else -way[0]
        time = (plant.start - view.part.start) * view.clip.frame_time
        steps.append(Step(plant.side, time, float(way[2]), float(outward)))
    return steps


def _within(view: View, frame: int) -> bool:
    """Whether a foot that stands from a frame on was set down in the clip."""
    if view.clip.cyclic:
        return view.once.start <= frame < view.once.stop
    return frame > 0  # one that stands already in the first frame came down before


def _plants(view: View) -> Iterator[_Plant]:
    for foot in find_feet(view.longer, view.pose):
        # The ball is set down by every gait, the heel not by all; without toes it is the only one.
        places = view.turned(foot.points[-1].positions(view.pose))
        for plant in _stretches(foot, view.clip.frame_time):
            on_it = foot.planted[-1, plant]
            still = places[plant][on_it] if on_it.any() else places[plant]
            yield _Plant(foot.side, plant.start, plant.stop, np.median(still, axis=0))


def _stretches(foot: Foot, frame_time: float) -> Iterator[slice]:
    """The foot's plants, flickering ones joined and brief ones left out."""
    joined: list[slice] = []
    for plant in foot.plants():
        if joined and (plant.start - joined[-1].stop) * frame_time < _FLICKER:
            joined[-1] = slice(joined[-1].start, plant.stop)
        else:
            joined.append(plant)
    for plant in joined:
        if (plant.stop - plant.start) * frame_time >= _BRIEF:
            yield plant
