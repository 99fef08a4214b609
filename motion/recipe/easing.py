"""What a recipe breaks, and the recipe taken back until it breaks nothing."""

from __future__ import annotations

from motion.clip import Clip
from motion.quality import QualityReport, check
from motion.quality.check import greatest_clean
from motion.recipe.operation import Materials
from motion.recipe.recipe import Recipe

_NO_MATERIALS = Materials()


def check_recipe(
    source: Clip, recipe: Recipe, materials: Materials = _NO_MATERIALS, edited: Clip | None = None
) -> QualityReport:
    """What the edited clip does that it should not; times are those of the edited clip.

    It is compared with the source in the recipe's own time, so that a clip made faster or cut is
    judged moment by moment.

    Args:
        source: the clip before the recipe.
        recipe: what is done to it.
        materials: what the recipe refers to.
        edited: the recipe's result, if it is at hand.

    Raises:
        MotionError: if the source does not lend itself to the recipe or to being judged.
    """
    if edited is None:
        edited = recipe.apply(source, materials)
    return check(recipe.unedited(source, materials), edited)


def ease_off_recipe(
    source: Clip, recipe: Recipe, materials: Materials = _NO_MATERIALS
) -> tuple[Recipe, float, QualityReport]:
    """The recipe at the greatest share that is clean, as near as halving finds it.

    Returns:
        The eased recipe, its share in [0, 1] and its report, which is not clean only if the
        recipe breaks something without any amount, or the source cannot be repaired.

    Raises:
        MotionError: as ``check_recipe``.
    """

    def attempt(share: float) -> tuple[Recipe, QualityReport]:
        eased = recipe if share == 1.0 else recipe.eased(share)
        return eased, check_recipe(source, eased, materials)

    share, eased, report = greatest_clean(attempt)
    return eased, share, report
