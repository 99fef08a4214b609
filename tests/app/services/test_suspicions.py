from dataclasses import replace

import pytest

from app.services.suspicions import Judged, limits, measure, suspicions

GOOD = [
    Judged("walks", {"a": n % 5 - 2, "b": (n * 3) % 5 - 2, "c": (n // 2) % 5 - 2}, 5000 + 10 * n, 0)
    for n in range(30)
]


def broken(trials, usual_ms=6000, complete=20):
    return {one.id: one for one in suspicions(measure(trials), limits(usual_ms, complete))}


def test_who_answers_this_way_and_that_at_the_usual_pace_breaks_no_rule():
    assert broken(GOOD) == {}


def test_ten_alike_in_a_row_are_told_with_their_number_and_nine_are_not():
    alike = [replace(GOOD[5], rt_ms=one.rt_ms) for one in GOOD]
    ten = broken(GOOD[:9] + alike[:10] + GOOD[19:])["same_answers"]
    assert ten.number == "10 trials in a row were answered exactly alike"
    assert ten.rule == "10 or more in a row"
    assert "same_answers" not in broken(GOOD[:9] + alike[:9] + GOOD[18:])


def test_a_row_ends_where_another_part_begins():
    alike = [replace(GOOD[0], part="one")] * 6 + [replace(GOOD[0], part="two")] * 6
    assert measure(alike).same_run == 6


def test_the_same_step_on_every_scale_is_straight_from_half_of_the_trials_on():
    flat = [replace(one, answers=dict.fromkeys("abc", n % 3)) for n, one in enumerate(GOOD)]
    told = broken(flat[:15] + GOOD[15:])["flat_answers"]
    assert told.number.startswith("In 1")
    assert "flat_answers" not in broken(flat[:10] + GOOD[10:])


def test_two_scales_cannot_be_told_from_straight_answers():
    two = [replace(one, answers={"a": n % 3, "b": n % 3}) for n, one in enumerate(GOOD)]
    assert measure(two).rated == 0


def test_too_fast_is_a_third_of_the_usual_and_a_second_while_that_is_unknown():
    fast = [replace(one, rt_ms=1900) for one in GOOD]
    told = broken(fast)["too_fast"]
    assert told.number == "Half of the trials took 1.9 s or less"
    assert told.rule == "less than 2.0 s, a third of the usual 6.0 s"
    assert broken(fast, complete=4) == {}
    hasty = [replace(one, rt_ms=700) for one in GOOD]
    assert broken(hasty, None, 0)["too_fast"].rule == "less than 1.0 s"


def test_practice_and_checks_are_no_judged_trials_but_a_failed_check_counts():
    practice = [replace(one, practice=True, rt_ms=1) for one in GOOD]
    checks = [replace(GOOD[0], check="seen", passed=held) for held in (True, False)]
    numbers = measure(practice + checks + GOOD)
    assert (numbers.judged, numbers.checks, numbers.failed) == (30, 2, 1)
    told = broken(practice + checks + GOOD)
    assert told["failed_checks"].number == "1 of 2 attention checks failed"
    assert set(told) == {"failed_checks"}


@pytest.mark.parametrize(("ms", "expected"), [(300_000, set()), (300_600, {"hidden"})])
def test_five_minutes_out_of_sight_are_still_a_phone_call(ms, expected):
    assert set(broken([*GOOD[:-1], replace(GOOD[-1], hidden_ms=ms)])) == expected


def test_an_empty_session_has_numbers_and_no_suspicion():
    assert measure([]).median_ms is None
    assert broken([]) == {}
