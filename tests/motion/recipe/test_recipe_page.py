"""docs/recipes.md tells what the code gives."""

import json

from motion.recipe import OPERATIONS, PRESETS, Recipe
from tests.support import recipe_page


def test_the_page_is_up_to_date():
    assert recipe_page.PAGE.read_text(encoding="utf-8") == recipe_page.page()


def test_the_page_names_every_operation_and_preset():
    text = recipe_page.PAGE.read_text(encoding="utf-8")
    for name in [*OPERATIONS, *PRESETS]:
        assert f"`{name}`" in text


def test_its_example_is_a_recipe():
    text = recipe_page.PAGE.read_text(encoding="utf-8")
    example = text.partition("```json")[2].partition("```")[0]
    assert len(Recipe.parse(json.loads(example)).steps) == 2
