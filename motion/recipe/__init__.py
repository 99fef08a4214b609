"""Recipes: edits of a motion as data, checked, hashed, and done again to the same bits."""

from motion.recipe.easing import check_recipe, ease_off_recipe
from motion.recipe.operation import MAX_FRAMES, Materials, Operation
from motion.recipe.operations import OPERATIONS
from motion.recipe.presets import PRESETS, Preset
from motion.recipe.recipe import MAX_STEPS, Recipe, Step

__all__ = [
    "MAX_FRAMES", "MAX_STEPS", "OPERATIONS", "PRESETS",
    "Materials", "Operation", "Preset", "Recipe", "Step",
    "check_recipe", "ease_off_recipe",
]  # fmt: skip
