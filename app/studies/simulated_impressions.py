"""What people might say about the walks of sets A and B: assumed, not measured.

Nobody has rated the sample library. These values stand in for people where the way from ratings
to sliders is shown or tested, and nowhere else. They were declared from what the styles are made to
be, never computed from the clips or their features:

- quickness: the speed, and a little the character's haste;
- clearness: on set B valence, less for what is tense or unsteady (a stable and natural walk is
  clear); on set A bearing and control;
- activeness: arousal, brightened by valence (the paper's cluster holds sad–happy as well as
  dormant–brisk);
- largeness: stride, swing and spread of the arms, uprightness (`motion.procedural.styles`).

No two of the four go together closely (r ≤ 0.6 over a set's clips), and each is about 0 on average.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from app.statistics.intervals import Samples
from app.statistics.latent_raters import PAPER_NOISE, draw_pairs, simulate
from app.studies.adjectives import SET_A, SET_B
from app.studies.published_clusters import published

Values = tuple[float, float, float, float]

# Quickness, clearness, activeness, largeness, each −1 … 1; the reference walk is 0 on all four.
_STYLES: Mapping[str, Values] = {
    "neutral": (0.0, 0.0, 0.0, 0.0),
    "energetic": (0.5, 0.6, 0.8, 0.4),
    "proud": (-0.5, 1.0, 0.3, 0.5),
    "sad": (-0.7, -0.1, -1.0, -0.5),
    "angry": (1.0, -0.5, 0.0, 0.3),
    "old": (-0.5, -1.0, 0.0, -0.6),
    "timid": (-0.1, 0.3, -0.4, -1.0),
    "tired": (-0.3, -0.6, -0.7, 0.0),
    "childlike": (0.6, 0.2, 1.0, 0.0),
    "swaggering": (-0.4, -0.1, 0.2, 1.0),
}
_EMOTIONS: Mapping[str, Values] = {
    "excitement": (0.2, 0.1, 0.9, 0.9),
    "pleasure": (0.1, 0.7, 0.9, 0.1),
    "contentment": (-0.1, 1.0, 0.3, -0.1),
    "sleepiness": (-0.2, -0.5, -1.0, 0.0),
    "depression": (-0.2, 0.1, -0.8, -0.8),
    "misery": (-0.1, -0.6, -0.4, -0.8),
    "distress": (0.2, -1.0, 0.1, -0.3),  # roused, but steps are short and the arms drawn in
    "arousal": (0.2, -0.4, 0.1, 0.9),
    "neutral": (0.0, 0.5, 0.0, 0.0),
}
# What a speed adds: a fast walk is quicker, and its steps are longer.
_SPEEDS: Mapping[str, Values] = {
    "fast": (0.8, 0.0, 0.0, 0.1),
    "normal": (0.0, 0.0, 0.0, 0.0),
    "slow": (-0.8, 0.0, 0.0, -0.1),
}

CLIPS: Mapping[str, tuple[str, ...]] = {"set_a": SET_A, "set_b": SET_B}


def latent(motion_set: str) -> Samples:
    """The assumed values (clips, 4) of a set's clips, in the order of `CLIPS`, within −1 … 1."""
    return np.array([_values(name) for name in CLIPS[motion_set]])


def simulated_ratings(
    motion_set: str,
    generator: np.random.Generator,
    participants: int = 14,
    noise: float = PAPER_NOISE,
    values: Samples | None = None,
) -> Samples:
    """Answers −2 … 2 (participants, clips, 41) in the order of `CLIPS` and of the questionnaire.

    Pairs measure the factor that the paper's table for this set says; those it does not list say
    little, or people disagree about them (`app.statistics.latent_raters`).

    Args:
        motion_set: set_a or set_b.
        generator: of all draws.
        participants: how many answer; fourteen in the paper.
        noise: standard deviation of an answer about the common opinion, in steps.
        values: of the clips (clips, 4), where they are not those of `latent`.
    """
    pairs = draw_pairs(published(motion_set), generator)
    of_clips = latent(motion_set) if values is None else values
    return simulate(of_clips, pairs, participants, generator, noise)


def _values(clip: str) -> Samples:
    style = clip.split("_")[2]
    if clip in SET_A:
        return np.array(_STYLES[style])
    return np.add(_EMOTIONS[style], _SPEEDS[clip.split("_")[3]])
