"""What a researcher decides about clusters: it holds, it is kept, it is written down."""

from __future__ import annotations

import pytest
from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence.models import Researcher
from app.schemas.impressions import AnalysisChoices, Impressions
from app.services import audit, impression_choices, impressions, rights
from app.services.impressions import Live
from tests.support import rated_pairs

GROUPS = [3, 2, 4]
SLUG, PART = "adjectives", rated_pairs.PART
THREE = {"clusters": 3}


@pytest.fixture
def access(db: Session) -> rights.Access:
    ratings = rated_pairs.latent(8, 10, GROUPS)
    study = rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS)), ratings)
    person = Researcher(email="rosa@example.org", name="Rosa", password_hash="-")
    db.add(person)
    db.flush()
    rights.make_owner(db, study, person.id)
    db.commit()
    return rights.access(db, SLUG, person.id, "edit")


@pytest.fixture
def choose(db, access):
    def save(**choices) -> Impressions:
        return impression_choices.save(db, access, PART, AnalysisChoices(**THREE | choices))

    return save


def looked_at(db: Session, live: Live | None = None) -> Impressions:
    return impressions.impressions(db, SLUG, "owner", live=live)


def told(db: Session, access: rights.Access) -> list[str]:
    """The sentences of the audit trail, the oldest first."""
    return [entry.sentence for entry in audit.trail(db, access.study_id).entries][::-1]


def places(found: Impressions) -> dict[str, int | None]:
    return {pair.id: pair.cluster for pair in found.pairs}


def cluster_with(found: Impressions, pair: str):
    return found.clusters[places(found)[pair]]


def test_what_is_saved_is_what_everybody_sees_from_then_on(db, choose):
    before = looked_at(db)
    saved = choose(least_peak=0.5, most_spread=0.7)
    assert looked_at(db) == saved
    assert before.saved_at is None
    assert saved.saved_at is not None
    assert len(saved.clusters) == 3


def test_a_pair_moved_by_hand_moves_and_no_other(db, access, choose):
    before = choose()
    moved = choose(moved={"pair_0": "pair_4"})
    changed = {
        pair for pair in places(before)
        if cluster_with(before, pair).title != cluster_with(moved, pair).title
    }  # fmt: skip
    own = next(one for one in before.clusters if "pair_0" in one.members)
    assert cluster_with(moved, "pair_0").members[-1] == "pair_0"
    assert {pair.id for pair in moved.pairs if pair.moved} == {"pair_0"}
    assert [set(one.members) - {"pair_0"} for one in moved.clusters] == [
        set(one.members) - {"pair_0"} for one in before.clusters
    ]
    assert changed <= set(own.members)  # those that stayed may stand under another first pair
    assert moved.merges == before.merges
    assert (
        "moved left 0 – right 0 of “semantic_differential” into the cluster of "
        in (told(db, access)[-1])
    )


def test_moves_do_not_pull_others_along(choose):
    choose(moved={"pair_0": "pair_4"})
    found = choose(moved={"pair_0": "pair_4", "pair_4": "pair_8"})
    assert places(found)["pair_0"] == places(found)["pair_3"]
    assert places(found)["pair_4"] == places(found)["pair_8"] != places(found)["pair_3"]


def test_a_pair_moved_to_one_that_was_moved_comes_to_where_that_is_seen(choose):
    choose(moved={"pair_0": "pair_4"})
    found = choose(moved={"pair_0": "pair_4", "pair_8": "pair_0"})
    assert places(found)["pair_8"] == places(found)["pair_0"] == places(found)["pair_4"]


def test_a_pair_moved_to_where_the_tree_has_it_is_not_moved(db, access, choose):
    choose(moved={"pair_0": "pair_4"})
    found = choose(moved={"pair_0": "pair_1"})
    assert found.choices.moved == {}
    assert found.clusters == looked_at(db, Live(clusters=3)).clusters
    assert told(db, access)[-1].startswith("put left 0 – right 0 of")


def test_a_cluster_that_all_have_left_is_gone(choose):
    found = choose(moved={"pair_3": "pair_0", "pair_4": "pair_0"})
    assert len(found.clusters) == 2
    assert set(cluster_with(found, "pair_0").members) == {f"pair_{n}" for n in range(5)}


def test_a_name_stays_with_its_cluster_when_the_cut_moves(db, choose):
    key = cluster_with(choose(), "pair_8").key
    saved = choose(names={key: "Size"})
    assert cluster_with(saved, "pair_8").title == "Size"
    assert cluster_with(saved, "pair_8").named
    two = looked_at(db, Live(clusters=2))
    assert [one.title for one in two.clusters if one.named] == ["Size"]
    assert set(cluster_with(saved, "pair_8").members) <= set(
        next(one for one in two.clusters if one.named).members
    )
    assert two.choices.names == {next(one.key for one in two.clusters if one.named): "Size"}


def test_a_name_whose_pairs_are_dropped_is_not_lost_and_said_to_be_unused(db, choose):
    key = cluster_with(choose(), "pair_8").key
    choose(names={key: "Size"})
    strict = looked_at(db, Live(most_spread=0.01))
    assert strict.clusters == []
    assert looked_at(db).choices.names == {key: "Size"}


def test_a_move_that_makes_no_sense_is_left_out_of_the_view_and_the_view_says_so(db, choose):
    pairs = choose().pairs
    boldest = max(pairs, key=lambda pair: pair.spread)
    to = next(pair.id for pair in pairs if pair.cluster != boldest.cluster)
    choose(moved={boldest.id: to})
    found = looked_at(db, Live(most_spread=boldest.spread - 1e-9))
    assert boldest.id not in found.kept
    assert found.choices.moved == {}
    assert "was moved by hand is left out of this view" in found.notes[-1]
    assert looked_at(db).choices.moved == {boldest.id: to}


def test_each_decision_is_written_down_once(db, access, choose):
    first = choose()
    key = first.clusters[0].key
    choose(least_peak=1.2)
    choose(least_peak=1.2, names={key: "Speed"})
    choose(least_peak=1.2, names={key: "Speed"})
    choose(least_peak=1.2)
    told_now = told(db, access)
    assert [line.split()[0] for line in told_now] == ["set", "set", "called", "took"]
    assert "μ* from 1.2 and σ̄ up to 0.85, in 3 clusters" in told_now[1]
    assert told_now[2].endswith("“Speed”")


def test_a_pair_that_nobody_was_asked_is_refused_with_its_name(db, choose):
    for choices in ({"moved": {"pair_0": "love"}}, {"names": {"love": "Love"}}):
        with pytest.raises(InvalidError, match="no pair “love”") as refused:
            choose(**choices)
        assert refused.value.where["pair"] == "love"
    assert looked_at(db).saved_at is None


def test_two_clusters_cannot_have_one_name(choose):
    with pytest.raises(InvalidError, match="Two clusters would be called “speed”"):
        choose(names={"pair_0": "Speed", "pair_8": "speed"})


def test_a_part_that_is_not_there_is_said_to_be_missing(db, access):
    with pytest.raises(NotFoundError, match="no part “nowhere”"):
        impression_choices.save(db, access, "nowhere", AnalysisChoices())


def test_what_somebody_else_saved_meanwhile_is_not_written_over(db, access, choose):
    seen = choose().saved_at
    theirs = AnalysisChoices(**THREE, names={looked_at(db).clusters[0].key: "theirs"})
    impression_choices.save(db, access, PART, theirs, seen=seen)
    mine = AnalysisChoices(**THREE)
    with pytest.raises(ConflictError, match="changed elsewhere"):
        impression_choices.save(db, access, PART, mine, seen=seen)
    assert looked_at(db).clusters[0].title == "theirs"
    impression_choices.save(db, access, PART, mine, seen=looked_at(db).saved_at)
    assert looked_at(db).choices.names == {}
