import numpy as np
import pytest

from app.statistics.agreement import adjusted_rand
from app.statistics.quantification import quantify
from app.statistics.stability import Bootstrap, best_jaccard, sizes
from app.statistics.ward import cut, ward

LOADS = np.repeat([0, 1, 2, 3], [3, 4, 2, 3])


def rated(participants=14, noise=0.6, clips=10, missing=0.0):
    """Answers of four groups of pairs, and three pairs that say nothing."""
    generator = np.random.default_rng(11)
    latent = 1.8 * np.sin(np.arange(clips)[:, None] * [0.7, 1.3, 1.9, 2.6])[:, LOADS]
    latent = np.hstack([latent, np.zeros((clips, 3))])
    noisy = latent + generator.normal(0, noise, (participants, *latent.shape))
    ratings = np.clip(np.rint(noisy), -2, 2)
    ratings[generator.random(ratings.shape) < missing] = np.nan
    return ratings


def found_in(ratings, seed=1, samples=100, **more):
    return Bootstrap.of(ratings, **more).drawn(samples, np.random.default_rng(seed))


def tried(ratings, participants, samples=100, seed=1, **more):
    bootstrap, generator = Bootstrap.of(ratings, **more), np.random.default_rng(seed)
    return [bootstrap.by_size(people, samples, generator) for people in participants]


@pytest.mark.parametrize("missing", [0.0, 0.25])
def test_the_fast_way_is_the_slow_one_with_every_participant_taken_so_often(missing):
    ratings = rated(noise=1.0, missing=missing)
    people, samples, pairs = len(ratings), 60, ratings.shape[2]
    found = found_in(ratings, samples=samples, most_spread=0.95)
    draws = np.random.default_rng(1).multinomial(people, np.full(people, 1 / people), samples)
    rated_by = (~np.isnan(ratings)).sum(axis=0)
    kept_count, shared, whole = np.zeros(pairs), [], []
    full = Bootstrap.of(ratings, most_spread=0.95).labels
    for draw in draws:
        of_sample = quantify(np.repeat(ratings, draw, axis=0))
        spread = np.nanmean(of_sample.spread * np.sqrt(rated_by / (rated_by - 1)), axis=0)
        keeps = ~((of_sample.peak < 1.0) | (spread > 0.95))
        kept_count += keeps
        labels = np.full(pairs, -1)
        columns = of_sample.mean[:, keeps]
        labels[keeps] = cut(ward(columns[~np.isnan(columns).any(axis=1)].T), 4)
        both = keeps & (full >= 0)
        shared.append(adjusted_rand(full[both], labels[both]))
        whole.append(adjusted_rand(np.where(full < 0, 9, full), np.where(keeps, labels, 9)))
    np.testing.assert_allclose(found.kept_share, kept_count / samples)
    np.testing.assert_allclose(found.shared, shared)
    np.testing.assert_allclose(found.whole, whole)


def test_people_who_agree_give_the_same_solution_whoever_is_asked():
    ratings = rated(noise=0.0)
    found, full = found_in(ratings), Bootstrap.of(ratings).labels
    assert set(found.kept_share) == {0.0, 1.0}
    assert (found.whole == 1).all()
    assert (found.shared == 1).all()
    assert (found.cluster_stability == 1).all()
    assert {size.whole for size in tried(ratings, sizes(14))} == {(1.0, 1.0, 1.0)}
    kept = full >= 0
    assert adjusted_rand(full[kept], LOADS) == 1
    assert not kept[len(LOADS) :].any()


def test_a_pair_that_comes_and_goes_is_seen_by_the_index_of_the_whole_alone():
    ratings = rated(noise=0.0, participants=6)
    ratings[:3, :, 0] = 0  # half of the people see nothing in it, so that it is at the threshold
    found = found_in(ratings, samples=200, most_spread=9.0)
    assert 0.2 < found.kept_share[0] < 0.8
    np.testing.assert_allclose(found.shared, 1)
    full = Bootstrap.of(ratings, most_spread=9.0).labels
    as_in_full = found.kept_share[0] if full[0] >= 0 else 1 - found.kept_share[0]
    assert (found.whole == 1).mean() == pytest.approx(as_in_full)


def test_answers_without_meaning_give_another_solution_every_time():
    ratings = np.random.default_rng(3).integers(-2, 3, (14, 10, 41)).astype(float)
    found = found_in(ratings, least_peak=0.0, most_spread=9.0)
    meaningful = found_in(rated())
    assert found.shared.mean() < 0.5 < 0.9 < meaningful.shared.mean()
    assert found.whole.mean() < 0.5 < 0.9 < meaningful.whole.mean()
    assert found.cluster_stability.max() < meaningful.cluster_stability.min()


def test_more_participants_agree_more_with_all_of_them():
    found = tried(rated(noise=1.2), [3, 14, 56], samples=500, most_spread=9.0)
    for numbers in (
        [size.whole.mean for size in found],
        [size.shared.mean for size in found],
        [size.kept_alike for size in found],
    ):
        assert numbers == sorted(numbers)
    assert [size.participants for size in found] == [3, 14, 56]
    few = found[0].whole
    assert few.low < few.mean < few.high


def test_numbers_of_participants_go_to_twice_as_many_as_there_are():
    assert sizes(14) == [4, 6, 8, 11, 14, 21, 28]


def test_the_same_seed_gives_the_same():
    ratings = rated(noise=1.0)
    one, same, other = (found_in(ratings, seed, samples=50) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.kept_share, same.kept_share)
    np.testing.assert_array_equal(one.whole, same.whole)
    assert (one.whole != other.whole).any()


def test_a_sample_that_keeps_too_few_pairs_has_no_stable_cluster():
    ratings = np.zeros((2, 4, 4))
    ratings[0] = 2 * np.eye(4)  # one person sees four differences, the other none
    found = found_in(ratings, least_peak=1.0, most_spread=9.0, samples=200)
    nobody_saw = np.isnan(found.shared)
    assert 0.15 < nobody_saw.mean() < 0.35  # a quarter of the samples is the other one twice
    assert found.kept_share == pytest.approx(1 - nobody_saw.mean())
    assert found.cluster_stability == pytest.approx(1 - nobody_saw.mean())
    assert found.whole.tolist() == np.where(nobody_saw, 0.0, 1.0).tolist()
    alone = tried(ratings, [1], least_peak=1.0, most_spread=9.0)[0]
    assert alone.shared.mean == 1
    assert alone.whole.mean == pytest.approx(alone.kept_alike)


def test_one_pair_that_both_keep_says_nothing_of_groups():
    ratings = np.zeros((2, 3, 2))
    ratings[[0, 1], 0, [0, 1]] = 2  # each of two people sees another difference
    found = found_in(ratings, most_spread=9.0, clusters=1, samples=200)
    one_person = found.whole < 1  # who was drawn twice
    assert 0.35 < one_person.mean() < 0.65
    np.testing.assert_array_equal(np.isnan(found.shared), one_person)


def test_jaccard_compares_a_cluster_with_the_most_similar_one():
    full = np.array([0, 0, 0, 1, 1, -1])
    other = np.array([1, 1, 0, 0, -1, 0])
    assert best_jaccard(full, other).tolist() == pytest.approx([2 / 3, 1 / 4])


def test_a_bootstrap_of_one_participant_is_refused():
    with pytest.raises(ValueError, match="two participants"):
        found_in(rated(participants=1))


def test_fewer_kept_pairs_than_clusters_are_refused():
    with pytest.raises(ValueError, match="4 clusters"):
        found_in(np.zeros((5, 3, 8)))


def test_drawing_people_twice_does_not_make_them_agree():
    # At a threshold of just its own spread a pair stays in about half of the samples. Without the
    # correction of the samples' variances it would stay in nine of ten.
    shares = []
    for seed in range(20):
        ratings = np.random.default_rng(seed).normal(1.5, 1.0, (6, 10, 1))
        limit = quantify(ratings).mean_spread[0]
        found = found_in(ratings, most_spread=limit, clusters=1)
        shares.append(found.kept_share[0])
    assert 0.4 < np.mean(shares) < 0.65
