"""Spaces that a fresh server has: the sample walks of sets A and B, judged by simulated raters."""

from __future__ import annotations

import numpy as np

from app.persistence.engine import Database
from app.persistence.studies import sample_clips
from app.schemas.impressions import LEAST_PEAK, MOST_SPREAD, AnalysisChoices
from app.schemas.spaces import Origin, Sliders
from app.schemas.study import Scale
from app.services import impression_names, impression_space, new_spaces, spaces
from app.services.impression_solution import solve
from app.services.space_making import define
from app.statistics.quantification import quantify
from app.studies.adjectives import SCALES
from app.studies.simulated_impressions import CLIPS, simulated_ratings

RATERS, SEED, REACH = 14, 1, 2
NOTE = (
    "Nobody has judged these walks: simulated raters answered by what each walk was made to be. "
    "They show how a space works and say nothing about people."
)


def make(database: Database) -> None:
    """Make both of the samples that are in the library; the same ones are kept once only."""
    for motion_set in spaces.SAMPLES:
        _make(database, motion_set)


def _make(database: Database, motion_set: str) -> None:
    with database.reading() as db:
        known = {clip.name: clip.id for clip in sample_clips(db, motion_set[-1].upper())}
        if not set(CLIPS[motion_set]) <= set(known):
            return  # a library of other samples
        sources = new_spaces.sources(db, [known[name] for name in CLIPS[motion_set]])
    origin = Origin(
        kind="simulated",
        participants=RATERS,
        least_peak=LEAST_PEAK,
        most_spread=MOST_SPREAD,
        note=NOTE,
    )
    defined = define(spaces.SAMPLES[motion_set], sources, {}, sliders(motion_set), origin)
    with database.writing() as db:
        new_spaces.keep(db, defined, study_id=None, made_by=None)
        db.commit()


def sliders(motion_set: str) -> Sliders:
    """The sliders that the analysis gives with its usual thresholds and four clusters."""
    ratings = simulated_ratings(motion_set, np.random.default_rng(SEED), RATERS)
    scales = {scale["id"]: Scale.model_validate(scale) for scale in SCALES}
    solution = solve(quantify(ratings), list(scales), AnalysisChoices(), REACH)
    if solution is None:
        raise RuntimeError("the simulated raters agree on no pair")  # their seed is fixed
    titles = impression_names.titles(solution.clusters, scales, {})
    return impression_space.sliders(solution, scales.values(), titles)
