import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from app.statistics.intervals import wilson

counts = st.integers(1, 500).flatmap(lambda n: st.tuples(st.integers(0, n), st.just(n)))


@given(counts, st.sampled_from([0.5, 0.9, 0.95, 0.99]))
def test_a_shares_interval_is_scipys(count, confidence):
    successes, n = count
    found = wilson(successes, n, confidence)
    expected = stats.binomtest(successes, n).proportion_ci(confidence, method="wilson")
    assert (found.low, found.high) == (
        pytest.approx(expected.low, abs=1e-12),
        pytest.approx(expected.high, abs=1e-12),
    )
    assert (found.share, found.n) == (successes / n, n)


@given(counts)
def test_it_stays_within_what_shares_can_be(count):
    found = wilson(*count)
    assert 0 <= found.low <= found.share <= found.high <= 1


def test_without_a_case_there_is_none():
    assert wilson(0, 0) is None
