"""What clusters of pairs are called."""

from __future__ import annotations

import pytest

from app.schemas.study import Scale
from app.services.impression_names import between, in_force, titles
from app.studies import adjectives
from app.studies.published_clusters import CLUSTERS

PAIRS = {scale["id"]: Scale.model_validate(scale) for scale in adjectives.SCALES}


def called(clusters, names=None, pairs=PAIRS):
    return [(one.text, one.named) for one in titles(clusters, pairs, names or {})]


@pytest.mark.parametrize("motion_set", CLUSTERS)
def test_a_published_cluster_is_known_though_pairs_are_missing_and_others_have_come(motion_set):
    table = list(CLUSTERS[motion_set].values())
    changed = [
        (*members[: -(-len(members) // 2)], stranger)
        for members, stranger in zip(
            table, ("thin_thick", "hard_soft", "coarse_fine", "strained_relaxed"), strict=True
        )
    ]
    assert called(changed[::-1]) == [(name, False) for name in reversed(CLUSTERS[motion_set])]


def test_a_fifth_cluster_is_called_by_its_first_pair():
    clusters = [*CLUSTERS["set_a"].values(), ["thin_thick"]]
    assert called(clusters)[4] == ("thin – thick", False)


def test_no_title_goes_to_two_clusters():
    first, second = (["slow_fast", "dull_quick"], ["blunt_sharp"])
    assert called([first, second, ["sad_happy"]])[0] == ("quickness", False)
    found = [title for title, _ in called([first, second, ["sad_happy"]])]
    assert len(set(found)) == 3


def test_a_given_name_goes_before_and_takes_a_default_away_from_others():
    clusters = list(CLUSTERS["set_a"].values())
    key = clusters[0][0]
    found = called(clusters, {key: "Largeness"})
    assert found[0] == ("Largeness", True)
    assert found[3] == ("small – large", False)


def test_pairs_of_another_questionnaire_are_called_by_their_words():
    sad = Scale.model_validate({"id": "sad_happy", "left": "sad", "right": "happy"})
    mine = Scale.model_validate({"id": "mine", "left": "yours", "right": "mine"})
    pairs = {one.id: one for one in (sad, mine)}
    assert called([["sad_happy"], ["mine"]], pairs=pairs) == [
        ("sad – happy", False), ("yours – mine", False),
    ]  # fmt: skip


def test_a_name_goes_with_its_pair_and_the_first_of_several_counts():
    names = {"b": "Second", "d": "Other", "x": "Gone"}
    assert in_force([["a", "b"], ["c"], ["d", "e"]], names) == {"a": "Second", "d": "Other"}
    assert in_force([["d", "b"]], names) == {"d": "Other"}


def test_words_stand_in_every_language_that_either_has():
    pair = Scale.model_validate(
        {
            "id": "pair",
            "left": {"en": "sad", "ja": "悲しい"},
            "right": {"en": "happy", "fi": "iloinen"},
        }
    )
    assert between(pair).root == {
        "en": "sad – happy", "ja": "悲しい – happy", "fi": "sad – iloinen",
    }  # fmt: skip
    assert between(Scale.model_validate({"id": "p", "left": "l", "right": "r"})).root == "l – r"


def test_without_clusters_there_are_no_titles():
    assert titles([], PAIRS, {}) == []
