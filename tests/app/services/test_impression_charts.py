"""The figures of an analysis for print."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

import pytest

from app.errors import NotFoundError
from app.services import impression_charts, impressions
from app.services.impressions import Live
from tests.support import rated_pairs

GROUPS = [3, 2, 4]
SLUG = "adjectives"
THREE = Live(clusters=3)


@pytest.fixture
def study(db):
    ratings = rated_pairs.latent(8, 10, GROUPS)
    return rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS)), ratings)


def texts(svg: str) -> list[str]:
    return [
        "".join(one.itertext()) for one in ET.fromstring(svg).iter() if one.tag.endswith("text")
    ]


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_the_matrix_has_a_cell_for_each_clip_and_kept_pair(db, study, mode):
    svg = impression_charts.printed(db, SLUG, "heat-map", mode, live=THREE)
    found = impressions.impressions(db, SLUG, "owner", live=THREE)
    assert svg.count('aria-roledescription="rect mark" d=') == 10 * len(found.kept)
    written = texts(svg)
    words = {pair.id: f"{pair.left} – {pair.right}" for pair in found.pairs}
    pairs = [one for one in written if one.startswith("left ") and "–" in one]
    assert pairs[-9:] == [words[pair] for pair in found.leaves]
    assert pairs[:-9] == [one.title for one in found.clusters]
    assert {f"clip {n}" for n in range(10)} <= set(written)


def test_the_tree_has_a_line_for_each_merge_and_the_cut_between_two(db, study):
    svg = impression_charts.printed(db, SLUG, "dendrogram", "light", live=THREE)
    found = impressions.impressions(db, SLUG, "owner", live=THREE)
    assert svg.count('aria-roledescription="line mark"') == len(found.merges)
    assert len(re.findall("stroke-dasharray", svg)) == 1
    whole = impression_charts.printed(db, SLUG, "dendrogram", "light", live=Live(clusters=1))
    assert "stroke-dasharray" not in whole


def test_without_clusters_the_sentence_says_why(db, study):
    with pytest.raises(NotFoundError, match="no pair is kept"):
        impression_charts.printed(db, SLUG, "dendrogram", "light", live=Live(most_spread=0.0))
    with pytest.raises(NotFoundError, match="no figure “pie”"):
        impression_charts.printed(db, SLUG, "pie", "light")
