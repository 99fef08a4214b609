"""Impressions predicted from features: against brute force, laws and chance."""

import numpy as np
import pytest

from app.statistics.prediction import LEAST_EXAMPLES, fit
from app.statistics.ridge import PENALTIES


def motions(generator, count, features=51, latent=5):
    """Features that hang together, as those of motions do: a few causes and some noise."""
    causes = generator.normal(size=(count, latent))
    mixed = causes @ np.random.default_rng(99).normal(size=(latent, features))
    units = np.geomspace(1e-2, 1e2, features)
    return causes, (mixed + 0.3 * generator.normal(size=(count, features))) * units + 3 * units


def felt(causes, noise, generator):
    """Impressions in 0 … 1 of three adjectives that follow from the causes."""
    weights = np.array(
        [[0.1, 0.0, 0.03], [0.0, -0.1, 0.03], [0.05, 0.0, 0.03], [0, 0, 0], [0, 0, 0]]
    )
    y = 0.5 + causes @ weights + noise * generator.normal(size=(len(causes), 3))
    return np.clip(y, 0.0, 1.0)


# --- brute force: every model by its own normal equations, every example left out by deleting it


def ridge(x, y, penalty):
    """Constant and slopes of one adjective."""
    scale = x.std(axis=0)
    z = (x - x.mean(axis=0)) / scale
    if np.isinf(penalty):
        return y.mean(), np.zeros(x.shape[1])
    strength = penalty * np.sum(z**2)
    slopes = np.linalg.solve(z.T @ z + strength * np.eye(z.shape[1]), z.T @ (y - y.mean())) / scale
    return y.mean() - x.mean(axis=0) @ slopes, slopes


def uncertainty(x, at, penalty):
    """(M,) from the whole inverse of the normal equations."""
    scale = x.std(axis=0)
    z, new = (x - x.mean(axis=0)) / scale, (at - x.mean(axis=0)) / scale
    spread = np.zeros(len(at))
    if np.isfinite(penalty):
        inverse = np.linalg.inv(z.T @ z + penalty * np.sum(z**2) * np.eye(z.shape[1]))
        spread = np.einsum("mf,fg,mg->m", new, inverse, new)
    return np.sqrt(1 + 1 / len(x) + spread)


def left_out_error(x, y, penalty):
    """Sum of squares, scales kept: only the regression is done anew."""
    scale = x.std(axis=0)
    z = (x - x.mean(axis=0)) / scale
    strength = penalty * np.sum(z**2)
    total = 0.0
    for i in range(len(x)):
        a, b = np.delete(z, i, axis=0), np.delete(y, i)
        middle = a.mean(axis=0)
        value = b.mean()
        if np.isfinite(penalty):
            normal = (a - middle).T @ (a - middle) + strength * np.eye(a.shape[1])
            value += (z[i] - middle) @ np.linalg.solve(normal, (a - middle).T @ (b - b.mean()))
        total += (y[i] - value) ** 2
    return total


def best(x, y):
    errors = [left_out_error(x, y, penalty) for penalty in PENALTIES]
    return PENALTIES[int(np.argmin(errors))]


@pytest.mark.parametrize(("count", "features"), [(12, 6), (9, 14)])
def test_models_penalties_errors_and_intervals_are_those_of_refitting_by_brute_force(
    count, features
):
    generator = np.random.default_rng(5)
    causes, x = motions(generator, count, features)
    y = felt(causes, 0.02, generator)
    new = motions(generator, 4, features)[1]
    found = fit(x, y, level=0.8)
    values, low, high = found.predict(new)
    for k in range(3):
        assert found.model.penalties[k] == best(x, y[:, k])
        constant, slopes = ridge(x, y[:, k], found.model.penalties[k])
        value = constant + new @ slopes
        np.testing.assert_allclose(found.model.of(new)[:, k], value, rtol=1e-9, atol=1e-9)
        own, lows, highs = [], [], []
        for i in range(count):
            a, b = np.delete(x, i, axis=0), np.delete(y[:, k], i)
            penalty = best(a, b)
            c, s = ridge(a, b, penalty)
            own.append(y[i, k] - (c + x[i] @ s))
            score = abs(own[-1]) / uncertainty(a, x[i : i + 1], penalty)
            lows.append(c + new @ s - score * uncertainty(a, new, penalty))
            highs.append(c + new @ s + score * uncertainty(a, new, penalty))
        assert found.error[k] == pytest.approx(np.sqrt(np.mean(np.square(own))), abs=1e-9)
        if found.refused[k]:
            continue
        rank = int(np.ceil(0.8 * (count + 1)))
        lowest = np.minimum(np.sort(lows, axis=0)[count - rank], value)
        highest = np.maximum(np.sort(highs, axis=0)[rank - 1], value)
        for ours, theirs in ((values, value), (low, lowest), (high, highest)):
            np.testing.assert_allclose(ours[:, k], np.clip(theirs, 0, 1), rtol=1e-9, atol=1e-9)
    assert not found.refused.all()


def test_the_means_error_is_that_of_the_others_mean():
    generator = np.random.default_rng(2)
    _, x = motions(generator, 11, 4)
    y = generator.uniform(size=(11, 2))
    others = np.array([np.delete(y, i, axis=0).mean(axis=0) for i in range(11)])
    found = fit(x, y)
    expected = np.sqrt(np.mean((y - others) ** 2, axis=0))
    np.testing.assert_allclose(found.mean_error, expected, rtol=1e-12)
    np.testing.assert_allclose(found.explained, 1 - (found.error / expected) ** 2, atol=1e-12)


# --- what it is for


@pytest.mark.parametrize("count", [15, 27, 60])
def test_a_linear_law_is_recovered_from_more_features_than_examples(count):
    generator = np.random.default_rng(7)
    causes, x = motions(generator, count)
    found = fit(x, felt(causes, 0.0, generator))
    assert not found.refused.any()
    assert (found.explained > 0.85).all()
    unseen, new = motions(generator, 200)
    values, _, _ = found.predict(new)
    missed = np.sqrt(np.mean((values - felt(unseen, 0.0, generator)) ** 2, axis=0))
    assert (missed < 0.05).all()


def test_the_error_that_is_told_is_that_of_new_clips():
    generator = np.random.default_rng(11)
    told, made = [], []
    for _ in range(12):
        causes, x = motions(generator, 30)
        found = fit(x, felt(causes, 0.06, generator))
        unseen, new = motions(generator, 300)
        off = found.model.of(new) - felt(unseen, 0.06, generator)
        told.append(np.mean(found.error**2))
        made.append(np.mean(off**2))
    assert np.sqrt(np.mean(told)) == pytest.approx(np.sqrt(np.mean(made)), rel=0.1)


@pytest.mark.parametrize(("count", "most"), [(10, 0.05), (27, 0.05), (60, 0.05)])
def test_impressions_drawn_by_lot_are_nearly_all_refused(count, most):
    """Three in a hundred are not: a margin that refused all would refuse true ones as well."""
    generator = np.random.default_rng(13)
    accepted, without_margin = [], []
    for _ in range(4):
        causes, x = motions(generator, count)
        lot = np.stack(
            [felt(causes[generator.permutation(count)], 0.05, generator)[:, k % 3]
             for k in range(150)], axis=1
        )  # fmt: skip
        found = fit(x, lot)
        accepted.append(np.mean(~found.refused))
        without_margin.append(np.mean(found.error < found.mean_error))
    assert np.mean(accepted) < most
    assert np.mean(without_margin) > np.mean(accepted)


def test_intervals_hold_new_clips_as_often_as_they_say():
    generator = np.random.default_rng(17)
    held = []
    for _ in range(15):
        causes, x = motions(generator, 30)
        found = fit(x, felt(causes, 0.05, generator))
        unseen, new = motions(generator, 200)
        _, low, high = found.predict(new)
        truth = felt(unseen, 0.05, generator)
        inside = (low <= truth) & (truth <= high)
        held.append(np.mean(inside[:, ~found.refused]))
    assert 0.92 < np.mean(held) <= 1.0
    assert found.level == pytest.approx(30 / 31)  # the first above 0.95 that 30 examples can tell


def test_few_examples_promise_less():
    generator = np.random.default_rng(19)
    causes, x = motions(generator, 10, 5)
    found = fit(x, felt(causes, 0.01, generator))
    assert found.level == pytest.approx(10 / 11)


# --- laws


def test_values_lie_within_their_intervals_and_all_within_0_and_1():
    generator = np.random.default_rng(23)
    causes, x = motions(generator, 20)
    found = fit(x, felt(causes, 0.05, generator))
    _, new = motions(generator, 100)
    values, low, high = found.predict(10 * new)
    ours = ~found.refused
    assert ours.any()
    assert (low <= values)[:, ours].all()
    assert (values <= high)[:, ours].all()
    assert (low >= 0)[:, ours].all()
    assert (high <= 1)[:, ours].all()


def test_units_order_and_features_that_do_not_vary_make_no_difference():
    generator = np.random.default_rng(29)
    causes, x = motions(generator, 20)
    y = felt(causes, 0.05, generator)
    new = motions(generator, 5)[1]
    units = generator.uniform(0.1, 10, 51)
    order = generator.permutation(20)
    still = np.full((20, 2), 0.3)
    expected = fit(x, y).predict(new)
    others = [
        fit(x * units - 4, y).predict(new * units - 4),
        fit(x[order], y[order]).predict(new),
        fit(np.hstack([x, still]), y).predict(np.hstack([new, [[0.3, 7.0]] * 5])),
    ]
    for other in others:
        np.testing.assert_allclose(other, expected, atol=1e-9)


def test_a_clip_unlike_all_examples_gets_an_interval_that_says_so():
    generator = np.random.default_rng(31)
    causes, x = motions(generator, 30)
    found = fit(x, felt(causes, 0.05, generator))
    assert not found.refused.any()
    middle = x.mean(axis=0)
    way = generator.normal(size=51) * x.std(axis=0)
    widths = []
    for far in (0.0, 1.0, 3.0, 30.0):
        _, low, high = found.predict((middle + far * way)[None])
        widths.append((high - low)[0])
    assert (np.diff(widths, axis=0) >= 0).all()
    assert (widths[0] < 0.4).all()
    np.testing.assert_array_equal(widths[-1], 1.0)


def test_features_that_hardly_vary_do_not_decide_where_the_least_is_said():
    generator = np.random.default_rng(53)
    causes, x = motions(generator, 30)
    x[:, 7] = 2.0 + 1e-4 * generator.normal(size=30)
    y = felt(causes, 0.02, generator)
    least = np.zeros(51)
    least[7] = 0.5
    other = x[:1].copy()
    other[0, 7] += 0.5
    changes = []
    for found in (fit(x, y), fit(x, y, least=least)):
        changes.append(np.abs(found.model.of(other) - found.model.of(x[:1])).max())
    assert changes[0] > 1.0
    assert changes[1] < 0.01


# --- refusals


def test_each_adjective_says_whether_and_why_it_is_predicted_or_not():
    generator = np.random.default_rng(37)
    causes, x = motions(generator, 20)
    clear = felt(causes, 0.02, generator)[:, 0]
    lot = generator.uniform(size=20)
    found = fit(x, np.stack([clear, lot, np.full(20, 0.4)], axis=1))
    assert found.refused.tolist() == [False, True, True]
    assert found.notes[0] == (
        f"Predicted: a clip left out is missed by {found.error[0]:.2f}, by the mean by "
        f"{found.mean_error[0]:.2f}; {found.explained[0]:.0%} explained."
    )
    assert found.notes[1].startswith("Not predicted: a clip left out is missed by ")
    assert found.notes[2] == "Not predicted: all rated clips make the same impression."
    for ends in found.predict(x[:2]):
        assert np.isfinite(ends[:, 0]).all()
        assert np.isnan(ends[:, 1:]).all()


def test_too_few_examples_are_refused_with_their_number():
    generator = np.random.default_rng(41)
    causes, x = motions(generator, LEAST_EXAMPLES - 1, 3)
    found = fit(x, felt(causes, 0.0, generator))
    assert found.refused.all()
    assert found.notes[0] == "Not predicted: 7 rated clips are too few, 8 are needed."


def test_an_adjective_is_refused_exactly_where_less_is_explained_than_needed():
    generator = np.random.default_rng(43)
    causes, x = motions(generator, 25)
    noisy = [felt(causes, noise, generator) for noise in (0.02, 0.1, 0.2, 0.4, 0.8)]
    found = fit(x, np.hstack(noisy))
    assert found.needed == pytest.approx(5 / 25)
    assert 0 < found.refused.sum() < 15
    np.testing.assert_array_equal(found.refused, found.explained < found.needed)


def test_missing_numbers_and_unequal_counts_are_errors():
    generator = np.random.default_rng(47)
    causes, x = motions(generator, 10, 3)
    y = felt(causes, 0.0, generator)
    with pytest.raises(ValueError, match="must be a number"):
        fit(np.where(x == x[3, 1], np.nan, x), y)
    with pytest.raises(ValueError, match="rated clips"):
        fit(x, y[:-1])
    with pytest.raises(ValueError, match="3 or more"):
        fit(x[:2], y[:2])
