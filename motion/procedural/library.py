"""The sample library: sets of synthetic clips, the same on every machine."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from motion.clip import Clip
from motion.procedural.bodies import BODIES
from motion.procedural.bow import bow
from motion.procedural.knock import walk_and_knock
from motion.procedural.steering import graph_clips
from motion.procedural.styles import ACTED, AFFECTS, CHARACTERS, SPEEDS, at_speed
from motion.procedural.walk import walk_cycle


@dataclass(frozen=True)
class SampleClip:
    """A clip of the library with its name and what it is."""

    name: str
    clip: Clip
    tags: dict[str, str]


def sample_clips() -> Iterator[SampleClip]:
    """Sets A (10 walking styles), B (9 affects × 3 speeds), acted (2 bodies × 10), bow, graph."""
    yield from set_a()
    yield from set_b()
    yield from acted()
    yield SampleClip("bow", bow(BODIES["adult"]), _tags("gesture", "adult"))
    yield from steered()


def set_a() -> Iterator[SampleClip]:
    """Ten walking styles, one stride each, looping."""
    for name, style in CHARACTERS.items():
        clip = walk_cycle(style, BODIES["adult"])
        yield SampleClip(f"set_a_{name}", clip, _tags("A", "adult", style=name))


def set_b() -> Iterator[SampleClip]:
    """Nine affects at three speeds, one stride each, looping."""
    for emotion, style in AFFECTS.items():
        for speed in SPEEDS:
            clip = walk_cycle(at_speed(style, speed), BODIES["adult"])
            tags = _tags("B", "adult", emotion=emotion, speed=speed)
            yield SampleClip(f"set_b_{emotion}_{speed}", clip, tags)


def acted() -> Iterator[SampleClip]:
    """A woman and a man walk up to a door and knock, in ten emotions."""
    for body in ("female", "male"):
        for emotion in ACTED:
            clip = walk_and_knock(emotion, BODIES[body])
            yield SampleClip(f"acted_{body}_{emotion}", clip, _tags("acted", body, emotion=emotion))


def steered() -> Iterator[SampleClip]:
    """Standing, walking, turning left and right, for the sample motion graph."""
    for name, clip in graph_clips(BODIES["adult"]).items():
        yield SampleClip(name, clip, _tags("graph", "adult"))


def _tags(motion_set: str, body: str, **more: str) -> dict[str, str]:
    return {"set": motion_set, "body": body, **more, "synthetic": "yes"}
