"""The steps of a matching experiment: what comes, how often, and in a balanced order."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise
from typing import Any

import pytest

from app.schemas.study import Trials
from app.services.matching_plan import matching_steps

INTERFACES = ("weights", "adjectives", "features")


def part(**task: Any) -> Trials:
    return Trials.model_validate(
        {
            "kind": "trials",
            "id": "matching",
            "task": {"kind": "match", "question": "Match it.", "space": "Walks", **task},
            "stimuli": [f"target {number}" for number in range(5)],
        }
    )


def steps_of(row: int, **task: Any) -> list[dict[str, Any]]:
    matching = part(**task)
    return matching_steps(matching, matching.task, [3, 1, 4, 0, 2], row)


def test_each_target_is_guessed_with_every_interface_and_then_matched_with_every_one() -> None:
    steps = steps_of(0)
    assert [step["clips"][0] for step in steps[::6]] == [f"target {n}" for n in (3, 1, 4, 0, 2)]
    for first in range(0, 30, 6):
        of_target = steps[first : first + 6]
        assert len({step["clips"][0] for step in of_target}) == 1
        assert [step["seen"] for step in of_target] == [False] * 3 + [True] * 3
        orders = [[step["interface"] for step in half] for half in (of_target[:3], of_target[3:])]
        assert orders[0] == orders[1]
        assert sorted(orders[0]) == sorted(INTERFACES)
    assert len(steps) == 30


def test_practice_comes_first_is_seen_and_is_marked() -> None:
    steps = steps_of(0, practice_targets=["one", "two", "three"])
    practice = [step for step in steps if step["practice"]]
    assert practice == steps[:9]
    assert all(step["seen"] for step in practice)
    assert [step["clips"] for step in practice[::3]] == [["one"], ["two"], ["three"]]


def test_without_guesses_there_are_none() -> None:
    assert all(step["seen"] for step in steps_of(0, guess_first=False))


@pytest.mark.parametrize("target", range(5))
def test_over_six_participants_each_interface_stands_and_follows_equally_often(target: int) -> None:
    orders = [
        [step["interface"] for step in steps_of(row)[6 * target + 3 : 6 * target + 6]]
        for row in range(6)
    ]
    for place in range(3):
        assert Counter(order[place] for order in orders) == dict.fromkeys(INTERFACES, 2)
    following = Counter(pair for order in orders for pair in pairwise(order))
    assert set(following.values()) == {2}
    assert len(following) == 6


def test_one_participant_does_not_meet_every_target_in_the_same_order() -> None:
    steps = steps_of(0)
    orders = {tuple(step["interface"] for step in steps[at : at + 3]) for at in range(0, 30, 6)}
    assert len(orders) >= 3


def test_practice_by_chance_and_checks_of_clips_do_not_go_with_matching() -> None:
    with pytest.raises(ValueError, match="practice targets of its own"):
        Trials.model_validate({**part().model_dump(mode="json"), "practice": 2})
    with pytest.raises(ValueError, match="one is there twice"):
        part(interfaces=["weights", "weights"])
