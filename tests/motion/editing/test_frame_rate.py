"""The same edit at 30, 60 and 120 frames a second gives the same motion."""

import numpy as np
import pytest

from motion.editing.contacts import accelerate_contacts
from motion.editing.foot_repair import repair_feet
from motion.editing.grid import nine_motions
from motion.editing.path_length import PathLength, change_path_length
from motion.editing.posture import PostureOffset, add_posture
from motion.editing.tempo import change_tempo, cut, resample_rate
from motion.editing.timing import ADDED, EVEN, Timing, change_timing
from motion.editing.variation import vary
from motion.procedural.stances import stance
from motion.rotations import angle_between
from tests.motion.editing.conftest import read

FASTEST = 120
RATES = (30, 60)
CLOSER = PostureOffset.between(stance("neutral"), stance("hands_and_feet_closer"))


def repaired(gain):
    return lambda clip: repair_feet(clip, change_path_length(clip, PathLength(gain)))


def equaliser(hertz):
    """Gains that go up and down over the frequencies of a walk."""
    octaves = np.log2(np.maximum(hertz, 1e-9))
    return np.interp(octaves, np.log2([0.5, 1, 2, 4, 8]), [1, 1.5, 0.6, 1.8, 1])


EDITS = {
    "a shorter path": repaired(0.5),
    "a longer path": repaired(1.5),
    "bands": lambda clip: change_path_length(clip, equaliser),
    "even speed": lambda clip: change_timing(clip, Timing(EVEN)),
    "added acceleration": lambda clip: change_timing(clip, Timing(ADDED)),
    "a grid point": lambda clip: nine_motions(clip).at(0.4, 1.6),
    "another grid point": lambda clip: nine_motions(clip).at(1.7, 0.3),
    "posture": lambda clip: add_posture(clip, [(CLOSER, 1.0)]),
    "contacts": accelerate_contacts,
    "variation": lambda clip: vary(clip, 0.8, 0.8, np.random.default_rng(5)),
    "tempo": lambda clip: change_tempo(clip, 1.3),
}
RECORDED = [
    "bandai-namco/walk_normal_001",
    "bandai-namco/walk_angry_001",
    "bandai-namco/run_happy_001",
    "bandai-namco/dance-short_normal_001",
    "cmu/12_01_walk",
]


def off(edit, clip):
    """Root of the mean squared angle, degrees, from 120 to 60 and 30 frames a second."""
    # A whole number of the slowest frames, so that nothing falls away at any rate.
    whole = cut(clip, 0.0, int(clip.duration * RATES[0]) / RATES[0])
    fine = edit(resample_rate(whole, FASTEST))
    for rate in RATES:
        coarse = edit(resample_rate(whole, rate))
        frames = np.arange(min(coarse.frames, (fine.frames - 1) * rate // FASTEST + 1))
        shown = fine.rotations[frames * (FASTEST // rate)]
        angles = np.degrees(angle_between(coarse.rotations[frames], shown))
        yield float(np.sqrt(np.mean(angles**2)))


@pytest.mark.parametrize("name", EDITS)
def test_an_acted_clip_is_edited_alike_at_any_frame_rate(samples, name):
    assert max(off(EDITS[name], samples["acted_female_angry"])) < 2.0


@pytest.mark.motions
@pytest.mark.parametrize("path", RECORDED)
@pytest.mark.parametrize("name", EDITS)
def test_a_recording_is_edited_alike_at_any_frame_rate(motions_dir, name, path):
    clip = read(motions_dir / f"{path}.bvh")
    if path.startswith("cmu/"):
        # Its first frame is a T-pose, from which the body jumps into a step.
        clip = cut(clip, 0.5, clip.duration)
    assert max(off(EDITS[name], clip)) < 2.0
