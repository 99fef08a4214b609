"""Two studies' clusters side by side."""

from __future__ import annotations

import numpy as np
import pytest

from app.errors import NotFoundError
from app.persistence.models import Researcher
from app.schemas.impressions import AnalysisChoices
from app.services import impression_choices, impression_comparison, rights
from tests.support import rated_pairs, study_files
from tests.support.published import add_published

GROUPS = [3, 2, 4]
PART = rated_pairs.PART
PAIRS = sum(GROUPS)


@pytest.fixture
def rosa(db) -> int:
    person = Researcher(email="rosa@example.org", name="Rosa", password_hash="-")
    db.add(person)
    db.commit()
    return person.id


@pytest.fixture
def put(db, rosa):
    """Puts a study of hers with these ratings into the database, cut into three clusters."""

    def study(slug, ratings, **task):
        asked = rated_pairs.definition(ratings.shape[1], PAIRS, slug=slug, **task)
        rights.make_owner(db, rated_pairs.rated(db, asked, ratings), rosa)
        db.commit()
        access = rights.access(db, slug, rosa, "edit")
        impression_choices.save(db, access, PART, AnalysisChoices(clusters=3))
        return access

    return study


def test_a_study_agrees_with_itself(db, put):
    access = put("one", rated_pairs.latent(8, 10, GROUPS))
    found = impression_comparison.comparison(db, access, PART, "one")
    assert (found.shared, found.rand, found.moved) == (PAIRS, 1.0, [])
    assert [one.like for one in found.here_clusters] == [0, 1, 2]
    assert found.turned == 0


def test_pairs_that_went_elsewhere_and_those_that_one_study_drops_are_named(db, put):
    ratings = rated_pairs.latent(8, 10, GROUPS, noise=0.3)
    other = ratings.copy()
    other[:, :, 0] = ratings[:, :, 8]  # goes with the last cluster
    other[:, :, 4] = 0  # stands out nowhere
    access = put("one", ratings)
    put("two", other)
    found = impression_comparison.comparison(db, access, PART, "two")
    assert (found.here, found.there, found.shared) == ("One", "Two", PAIRS - 1)
    moved = {one.id: (one.here is None, one.there is None) for one in found.moved}
    assert moved == {"pair_0": (False, False), "pair_4": (False, True)}
    assert 0 < found.rand < 1
    assert "1 of them is in another cluster; 1 more is kept by one study only" in found.sentence


def test_pairs_of_other_ids_are_known_by_their_words(db, put):
    ratings = rated_pairs.latent(8, 10, GROUPS)
    access = put("one", ratings)
    named = [{**scale, "id": f"other_{n}"} for n, scale in enumerate(rated_pairs.scales(PAIRS))]
    put("two", ratings[:, :, ::-1], scales=named[::-1])
    found = impression_comparison.comparison(db, access, PART, "two")
    assert (found.shared, found.rand) == (PAIRS, 1.0)


def turned(scale):
    return {**scale, "left": scale["right"], "right": scale["left"]}


@pytest.mark.parametrize("ids", ["pair", "other"])
def test_pairs_asked_the_other_way_round_are_the_same_pairs(db, put, ids):
    ratings = rated_pairs.latent(8, 10, GROUPS)
    other, scales = ratings.copy(), rated_pairs.scales(PAIRS)
    for place in (1, 6):
        other[:, :, place] *= -1
        scales[place] = turned(scales[place])
    named = [{**scale, "id": f"{ids}_{n}"} for n, scale in enumerate(scales)]
    access = put("one", ratings)
    put("two", other, scales=named)
    found = impression_comparison.comparison(db, access, PART, "two")
    assert (found.shared, found.rand, found.moved, found.turned) == (PAIRS, 1.0, [], 2)
    assert "“left 1 – right 1” and “left 6 – right 6” are asked the other way round in “Two”" in (
        found.sentence
    )
    of_there = [pair for cluster in found.there_clusters for pair in cluster.members]
    assert {str(pair.left) for pair in of_there if pair.turned} == {"left 1", "left 6"}


def test_clusters_of_one_title_are_not_taken_for_each_other(db, put):
    scales = [{"id": f"pair_{n}", "left": "left", "right": "right"} for n in range(PAIRS)]
    access = put("one", rated_pairs.latent(8, 10, GROUPS), scales=scales)
    found = impression_comparison.comparison(db, access, PART, "one")
    assert {one.title for one in found.here_clusters} == {"left – right"}
    assert [one.like for one in found.here_clusters] == [0, 1, 2]
    assert [one.like for one in found.there_clusters] == [0, 1, 2]


def test_only_what_can_be_compared_is_offered(db, put, rosa):
    ratings = rated_pairs.latent(8, 10, GROUPS)
    access = put("one", ratings)
    scales = rated_pairs.scales(PAIRS)
    put("two", ratings, scales=[turned(scale) for scale in scales])
    put("empty", np.empty((0, 10, PAIRS)))
    others = [
        {"id": f"other_{n}", "left": f"one {n}", "right": f"another {n}"} for n in range(PAIRS)
    ]
    put("foreign", ratings, scales=others)
    add_published(db, study_files.study(study_files.trials("analogue"), slug="ratings"))
    strangers = rated_pairs.definition(10, PAIRS, slug="strangers")
    stranger = Researcher(email="sam@example.org", name="Sam", password_hash="-")
    db.add(stranger)
    db.commit()
    rights.make_owner(db, rated_pairs.rated(db, strangers, ratings), stranger.id)
    found = impression_comparison.comparable(db, access, PART, "participant")
    assert [(one.slug, one.part) for one in found.studies] == [("two", PART)]
    assert impression_comparison.comparable(db, access, PART, "simulated").studies == []


def test_a_study_without_answers_is_said_to_have_no_clusters_yet(db, put):
    access = put("one", rated_pairs.latent(8, 10, GROUPS))
    put("two", np.empty((0, 10, PAIRS)))
    found = impression_comparison.comparison(db, access, PART, "two")
    assert (found.shared, found.rand, found.there_clusters) == (0, None, [])
    assert found.sentence.startswith("“Two” has no clusters yet.")


def test_both_studies_must_be_ones_own(db, put, rosa):
    access = put("one", rated_pairs.latent(8, 10, GROUPS))
    put("two", rated_pairs.latent(8, 10, GROUPS))
    stranger = Researcher(email="sam@example.org", name="Sam", password_hash="-")
    db.add(stranger)
    db.commit()
    rights.put_member(db, rights.access(db, "one", rosa, "own"), "sam@example.org", "viewer")
    sees_one = rights.access(db, "one", stranger.id, "view")
    with pytest.raises(NotFoundError, match="no study “two”"):
        impression_comparison.comparison(db, sees_one, PART, "two")
    assert access.role == "owner"
