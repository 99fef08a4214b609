"""docs/features.md tells what the code gives."""

from motion.features import FEATURES
from tests.support import feature_page


def test_the_page_is_up_to_date():
    assert feature_page.PAGE.read_text(encoding="utf-8") == feature_page.page()


def test_the_page_names_every_feature_once():
    text = feature_page.PAGE.read_text(encoding="utf-8")
    assert [text.count(f"`{feature.id}`") for feature in FEATURES] == [1] * 51
