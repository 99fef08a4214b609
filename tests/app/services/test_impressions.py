"""What people saw in clips, by pairs of adjectives: from stored answers to clusters."""

from __future__ import annotations

from itertools import chain, pairwise

import numpy as np
import pytest
from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.persistence.models import Researcher, Response, StudySession
from app.schemas.impressions import AnalysisChoices
from app.services import impressions, participants, rights
from app.services.impression_solution import solve
from app.services.impressions import Live
from app.statistics.agreement import adjusted_rand
from app.statistics.quantification import quantify
from app.studies import adjectives
from app.studies.published_clusters import CLUSTERS
from tests.support import rated_pairs
from tests.support.published import add_published, add_version
from tests.support.study_files import study as study_file
from tests.support.study_files import trials

GROUPS = [3, 2, 4]
SLUG = "adjectives"


def looked_at(db: Session, **more):
    return impressions.impressions(db, SLUG, "owner", **more)


def somebody(db: Session) -> int:
    """A researcher's number."""
    person = Researcher(email="rosa@example.org", name="Rosa", password_hash="-")
    db.add(person)
    db.commit()
    return person.id


@pytest.fixture
def ratings():
    return rated_pairs.latent(8, 10, GROUPS)


@pytest.fixture
def study(db, ratings):
    return rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS)), ratings)


def test_the_numbers_are_those_of_the_answers(db, study, ratings):
    found = looked_at(db)
    assert found.participants == 8
    np.testing.assert_allclose(found.means, ratings.mean(axis=0))
    np.testing.assert_allclose(found.spreads, ratings.std(axis=0, ddof=1))
    peaks = np.abs(ratings.mean(axis=0)).max(axis=0)
    assert [pair.peak for pair in found.pairs] == pytest.approx(list(peaks))
    spread = ratings.std(axis=0, ddof=1).mean(axis=0)
    assert [pair.spread for pair in found.pairs] == pytest.approx(list(spread))


def test_pairs_that_follow_one_factor_are_one_cluster(db, study):
    found = looked_at(db, live=Live(clusters=3))
    true = np.repeat(range(3), GROUPS)
    assert found.kept == [f"pair_{n}" for n in range(9)]
    assert adjusted_rand(true, np.array([pair.cluster for pair in found.pairs])) == 1.0
    assert found.sentence.startswith("8 participants rated 10 clips on 9 pairs of adjectives.")
    assert "3 clusters" in found.sentence
    assert found.problem is None


def test_a_clusters_values_are_the_mean_of_its_columns(db, study):
    found = looked_at(db)
    matrix = np.array(found.matrix)
    assert matrix.min() >= 0
    assert matrix.max() <= 1
    for cluster in found.clusters:
        columns = [found.leaves.index(pair) for pair in cluster.members]
        np.testing.assert_allclose(cluster.values, matrix[:, columns].mean(axis=1))
    assert sorted(chain(*(one.members for one in found.clusters))) == sorted(found.kept)


def test_the_matrix_is_the_means_between_the_poles(db, study, ratings):
    found = looked_at(db)
    order = [int(pair.removeprefix("pair_")) for pair in found.leaves]
    np.testing.assert_allclose(found.matrix, (ratings.mean(axis=0)[:, order] + 2) / 4)


def test_each_merge_tells_height_and_increase(db, study):
    found = looked_at(db)
    assert len(found.merges) == len(found.kept) - 1
    assert found.merges[-1].size == len(found.kept)
    for merge in found.merges:
        assert merge.height == pytest.approx(np.sqrt(2 * merge.increase))


def test_a_higher_threshold_for_the_peak_never_adds_a_pair(db, study):
    kept = [set(looked_at(db, live=Live(least_peak=peak)).kept) for peak in np.linspace(0, 2, 9)]
    assert all(fewer <= more for more, fewer in pairwise(kept))
    assert kept[0] > kept[-1]


def test_a_higher_threshold_for_the_spread_never_drops_a_pair(db, study):
    kept = [set(looked_at(db, live=Live(most_spread=most)).kept) for most in np.linspace(0, 1, 9)]
    assert all(fewer <= more for fewer, more in pairwise(kept))
    assert not kept[0]
    assert len(kept[-1]) == sum(GROUPS)


def test_a_dropped_pair_tells_why(db, study):
    found = looked_at(db, live=Live(least_peak=10, most_spread=0.1))
    assert {pair.dropped is None for pair in found.pairs} == {False}
    assert "less than 10.00" in found.pairs[0].dropped
    assert "more than 0.10" in found.pairs[0].dropped
    assert not found.clusters
    assert "no pair is kept" in found.problem
    assert found.means  # so that the thresholds can be set by them
    assert found.pairs[0].peak


@pytest.mark.parametrize(
    "changes",
    [
        {"state": "active"},
        {"state": "withdrawn"},
        {"state": "failed_attention"},
        {"excluded": {"reason": "twice", "by": 1}},
        {"practice": True},
        {"check": "catch"},
    ],
    ids=lambda changes: "-".join(map(str, changes)),
)
def test_what_does_not_count_changes_nothing(db, study, ratings, changes):
    before = looked_at(db)
    rated_pairs.add(db, study, -ratings[:3], **changes)
    assert looked_at(db) == before


def test_simulated_answers_are_kept_apart(db, study, ratings):
    before = looked_at(db)
    rated_pairs.add(db, study, -ratings[:3], kind="simulated")
    simulated = looked_at(db, kind="simulated")
    assert looked_at(db) == before.model_copy(update={"simulated": 3})
    assert (simulated.participants, simulated.kind) == (3, "simulated")
    np.testing.assert_allclose(simulated.means, -ratings[:3].mean(axis=0))
    assert simulated.sentence.startswith("3 simulated participants rated")


def test_numbers_follow_new_answers_exclusions_and_deletions_at_once(db, study, ratings):
    looked_at(db)
    (session,) = rated_pairs.add(db, study, -ratings[:1])
    assert looked_at(db).participants == 9
    access = rights.access(db, SLUG, somebody(db), "own")
    participants.exclude(db, access, session.id, "asleep")
    assert looked_at(db).participants == 8
    participants.include(db, access, session.id)
    assert looked_at(db).participants == 9
    participants.delete(db, access, session.id)
    found = looked_at(db)
    assert found.participants == 8
    np.testing.assert_allclose(found.means, ratings.mean(axis=0))


def test_only_the_newest_revision_counts(db, study, ratings):
    old = db.query(Response).join(StudySession).filter(Response.trial_index == 0).first()
    newer = {name: getattr(old, name) for name in (
        "session_id", "part", "trial_type", "trial_index", "clips", "rt_ms", "record",
        "fingerprint", "practice",
    )}  # fmt: skip
    db.add(Response(**newer, revision=2, answers=dict.fromkeys(old.answers, 0)))
    db.commit()
    changed = ratings.copy()
    person = db.query(StudySession).order_by(StudySession.completed_at, StudySession.id).all()
    assert {one.id for one in person} >= {old.session_id}
    first = next(n for n, one in enumerate(ratings) if list(one[0]) == list(old.answers.values()))
    changed[first, 0] = 0
    np.testing.assert_allclose(looked_at(db).means[0], changed.mean(axis=0)[0])


def test_an_unrated_clip_stays_out_of_the_tree_and_is_named(db, ratings):
    given = ratings.copy()
    given[:, 4] = np.nan
    rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS)), given)
    found = looked_at(db)
    assert found.clips[4].raters == 0
    assert found.means[4] == found.spreads[4] == [None] * sum(GROUPS)
    assert all(cluster.values[4] is None for cluster in found.clusters)
    assert "1 clip without an answer on every kept pair is left out" in " ".join(found.notes)
    others = np.delete(given, 4, axis=1)
    ids = [pair.id for pair in found.pairs]
    alone = solve(quantify(others), ids, AnalysisChoices(), 2)
    assert [one.members for one in found.clusters] == alone.clusters


def test_subsets_of_clips_are_enough(db, ratings):
    given = ratings.copy()
    given[:4, :5] = np.nan
    given[4:, 5:] = np.nan
    rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS)), given)
    found = looked_at(db)
    assert {clip.raters for clip in found.clips} == {4}
    assert found.problem is None
    np.testing.assert_allclose(found.means, np.nanmean(given, axis=0))


def test_versions_that_asked_alike_are_taken_together(db, study, ratings):
    again = rated_pairs.definition(10, sum(GROUPS)).model_copy(update={"title": "Again"})
    version = add_version(db, study, again, 2)
    rated_pairs.add(db, study, ratings[:2], version_id=version.id)
    found = looked_at(db)
    assert found.participants == 10
    assert found.notes[0] == "Versions 1 and 2 are taken together."


def test_without_enough_answers_a_sentence_says_what_is_missing(db, ratings):
    study = add_published(db, rated_pairs.definition(10, sum(GROUPS)))
    assert "so far there is none" in looked_at(db).problem
    rated_pairs.add(db, study, ratings[:1])
    found = looked_at(db)
    assert "so far there is one" in found.problem
    assert (found.clusters, found.merges, found.matrix) == ([], [], [])
    rated_pairs.add(db, study, ratings[1:2])
    assert looked_at(db).problem is None


def test_one_clip_alone_tells_no_pairs_apart(db, ratings):
    rated_pairs.rated(db, rated_pairs.definition(1, sum(GROUPS)), ratings[:, :1])
    assert "two clips or more" in looked_at(db).problem


def test_a_study_without_pairs_of_adjectives_says_so(db):
    add_published(db, study_file(trials("choose"), slug=SLUG))
    with pytest.raises(NotFoundError, match="asks for no pairs of adjectives"):
        looked_at(db)


def test_the_default_thresholds_grow_with_the_reach_of_the_steps(db, ratings):
    rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS), steps=9), 2 * ratings)
    found = looked_at(db)
    assert (found.reach, found.choices.least_peak, found.choices.most_spread) == (4, 2.0, 1.7)
    np.testing.assert_allclose(np.mean(found.matrix), (ratings.mean() + 2) / 4)


def test_fewer_kept_pairs_than_clusters_are_one_cluster_each(db, study):
    found = looked_at(db, live=Live(clusters=30))
    assert [one.members for one in found.clusters] == [[pair] for pair in found.leaves]
    assert "Only 9 pairs are kept" in found.notes[0]


@pytest.mark.parametrize("motion_set", CLUSTERS)
def test_the_papers_clusters_have_the_papers_titles(db, motion_set):
    table = CLUSTERS[motion_set]
    ids = [scale["id"] for scale in adjectives.SCALES]
    following = rated_pairs.latent(6, 12, [1] * 4, seed=3)
    columns = [
        next((n for n, pairs in enumerate(table.values()) if pair in pairs), None) for pair in ids
    ]
    given = np.stack(
        [following[:, :, n] if n is not None else 0 * following[:, :, 0] for n in columns], axis=2
    )
    asked = rated_pairs.definition(12, 2, scales=adjectives.SCALES)
    rated_pairs.rated(db, asked, given)
    found = looked_at(db)
    assert {one.title: set(one.members) for one in found.clusters} == {
        title: set(pairs) for title, pairs in table.items()
    }
    assert not any(one.named for one in found.clusters)


def test_words_of_any_length_make_titles_of_a_title_s_length(db, ratings):
    long = [
        {"id": scale["id"], "left": "l" * 300, "right": f"r{n}"}
        for n, scale in enumerate(rated_pairs.scales(sum(GROUPS)))
    ]
    rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS), scales=long), ratings)
    assert {len(one.title) for one in looked_at(db).clusters} == {200}


def test_a_pair_that_a_later_version_added_joins_the_others(db, study, ratings):
    version = add_version(db, study, rated_pairs.definition(10, sum(GROUPS) + 1), 2)
    added = np.concatenate([ratings[:3], ratings[:3, :, :1]], axis=2)
    rated_pairs.add(db, study, added, version_id=version.id)
    found = looked_at(db)
    assert found.participants == 11
    assert [pair.id for pair in found.pairs][-1] == "pair_9"
    assert found.pairs[-1].cluster == found.pairs[0].cluster
    np.testing.assert_allclose(np.array(found.means)[:, 9], ratings[:3, :, 0].mean(axis=0))
