import pytest

from app.services import sentences

ROW = {
    "label": "sad, female", "more": "sadder", "t": 8.1314, "df": 42.68, "d": 1.156,
    "low": 0.7502, "high": 1.5611,
}  # fmt: skip


def test_a_clear_difference_reads_as_the_association_wants_it():
    assert sentences.best_clip(**ROW, against="others", p_holm=0.00001) == (
        "The clip “sad, female” was seen as sadder than the same body’s other clips, Welch’s "
        "t(42.7) = 8.13, p < .001 after Holm’s correction, d = 1.16, 95 % CI [0.75, 1.56]."
    )


def test_what_is_not_significant_is_not_claimed():
    told = sentences.best_clip(**ROW, against="all", p_holm=0.0712)
    assert told.startswith(
        "No clip was reliably seen as sadder than all clips of the same body; the nearest was "
    )
    assert "p = .071 after" in told


def test_an_axis_is_told_by_its_two_ends():
    assert sentences.extremes(("sad", "sad, female", -1.464), ("happy", "happy, male", 1.5)) == (
        "On average “sad, female” was nearest to sad (M = −1.46) and “happy, male” to happy "
        "(M = 1.50)."
    )


@pytest.mark.parametrize(
    ("p", "told"),
    [(0.0009, "< .001"), (0.001, "= .001"), (0.0449, "= .045"), (0.9994, "= .999"), (1, "= 1.000")],
)
def test_p_has_three_digits_and_no_leading_zero(p, told):
    assert sentences.p_value(p) == told


@pytest.mark.parametrize(
    ("value", "told"), [(-1.36, "−1.36"), (-0.001, "0.00"), (2, "2.00"), (0.005, "0.01")]
)
def test_numbers_have_a_true_minus_and_no_minus_zero(value, told):
    assert sentences.number(value) == told
