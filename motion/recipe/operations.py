"""Every operation that a recipe can name."""

from __future__ import annotations

from collections.abc import Mapping

from motion.recipe.blends import BLEND
from motion.recipe.cycles import CYCLE, RETARGET
from motion.recipe.examples import EMOTION, FOURIER
from motion.recipe.feet import REPAIR_FEET
from motion.recipe.operation import Operation
from motion.recipe.paths import BANDS, GRID, PATH_LENGTH, VARY
from motion.recipe.postures import POSTURE, WARP, WAVESHAPE
from motion.recipe.times import CONTACTS, CUT, RESAMPLE, TEMPO, TIMING, WARP_TIME

OPERATIONS: Mapping[str, Operation] = {
    operation.key: operation
    for operation in (
        GRID, POSTURE, PATH_LENGTH, BANDS, TIMING, CONTACTS, VARY, TEMPO, RESAMPLE, CUT,
        REPAIR_FEET, WARP, WARP_TIME, WAVESHAPE, FOURIER, EMOTION, BLEND, CYCLE,
        RETARGET,
    )
}  # fmt: skip
