"""What a participant sees, and in which order: shuffles, squares, subsets, groups, checks."""

from __future__ import annotations

from collections import Counter

import pytest
from scipy.stats import chisquare

from app.schemas.study import StudyDefinition
from app.services.plans import Step, draw_plan, planned_steps
from tests.support.study_files import TASKS, clip, study, trials

ALLOCATIONS = 10_000


def steps(definition: StudyDefinition, seed: int = 0, slot: int = 0) -> list[Step]:
    return planned_steps(draw_plan(definition, seed, slot, "a design"))


def shown(found: list[Step]) -> list[tuple[str, ...]]:
    return [tuple(step["clips"]) for step in found if "clips" in step and not step["practice"]]


def test_over_ten_thousand_allocations_each_clip_comes_in_each_place_equally_often() -> None:
    number = 8
    definition = study(trials(number=number, practice=2))
    places: dict[str, Counter[int]] = {clip(index): Counter() for index in range(number)}
    for seed in range(ALLOCATIONS):
        for place, (one,) in enumerate(shown(steps(definition, seed, seed))):
            places[one][place] += 1
    p_values = [
        chisquare([count[place] for place in range(number)]).pvalue for count in places.values()
    ]
    assert min(p_values) > 0.001 / number  # the seeds are fixed: no chance in it


def test_every_clip_comes_once_after_the_practice_clips_which_are_among_them() -> None:
    found = steps(study(trials(number=6, practice=2)), seed=5)
    assert [step["practice"] for step in found] == [True] * 2 + [False] * 6
    assert sorted(shown(found)) == [(clip(index),) for index in range(6)]
    assert {step["clips"][0] for step in found[:2]} <= {clip(index) for index in range(6)}


def test_the_same_seed_and_slot_give_the_same_plan_and_others_give_others() -> None:
    definition = study(trials(number=8, order="shuffle"))
    assert steps(definition, 7, 3) == steps(definition, 7, 3)
    assert len({str(steps(definition, seed)) for seed in range(20)}) == 20


def test_a_latin_square_part_is_balanced_over_its_slots_whatever_the_seeds() -> None:
    definition = study(trials(number=4, order="latin_square"))
    rows = [shown(steps(definition, seed=99 - slot, slot=slot)) for slot in range(4)]
    places = Counter((place, one) for row in rows for place, one in enumerate(row))
    assert len(places) == 16
    assert set(places.values()) == {1}


def test_a_subset_shows_all_clips_equally_often_and_within_each_group() -> None:
    groups = [{"id": "a", "label": "A"}, {"id": "b", "label": "B"}]
    definition = study(trials(number=10, subset=4), groups=groups)
    for group in range(2):
        rows = [shown(steps(definition, slot, 2 * slot + group)) for slot in range(5)]
        counts = Counter(one for row in rows for one in row)
        assert all(len(set(row)) == 4 for row in rows)
        assert set(counts.values()) == {2}
        assert len(counts) == 10


def test_groups_see_their_own_parts_and_those_for_all() -> None:
    definition = study(
        {"kind": "break", "id": "only_b", "heading": "B", "text": "b", "groups": ["b"]},
        trials(number=2),
        {"kind": "break", "id": "only_a", "heading": "A", "text": "a", "groups": ["a"]},
        groups=[{"id": "a", "label": "A"}, {"id": "b", "label": "B"}],
    )
    parts = [{step["part"] for step in steps(definition, 1, slot)} for slot in range(4)]
    assert parts == [{"semantic_differential", "only_a"}, {"semantic_differential", "only_b"}] * 2


def test_blocks_change_places_and_what_is_no_block_stays() -> None:
    definition = study(
        {"kind": "break", "id": "first", "heading": "1", "text": "1"},
        trials("likert", 2),
        {"kind": "break", "id": "between", "heading": "2", "text": "2"},
        trials("unipolar", 2),
        blocks=[["likert", "unipolar"]],
    )
    orders = Counter(
        tuple(dict.fromkeys(step["part"] for step in steps(definition, seed)))
        for seed in range(400)
    )
    assert set(orders) == {
        ("first", "likert", "between", "unipolar"),
        ("first", "unipolar", "between", "likert"),
    }
    assert chisquare(list(orders.values())).pvalue > 0.001


def test_clips_of_one_body_come_together_where_the_part_says_so() -> None:
    definition = study(trials(number=8, block_by="body"))
    for seed in range(20):
        bodies = [int(one[-1], 16) % 2 for (one,) in shown(steps(definition, seed))]
        assert bodies in ([0] * 4 + [1] * 4, [1] * 4 + [0] * 4)


@pytest.mark.parametrize(("kind", "expected"), [("choose", 1), ("parallel", 1), ("ab", 6)])
def test_kinds_with_several_figures_show_them_together_in_drawn_places(
    kind: str, expected: int
) -> None:
    definition = study(trials(kind, 4))
    found = shown(steps(definition, seed=1))
    assert len(found) == expected
    assert {one for unit in found for one in unit} == {clip(index) for index in range(4)}
    first_places = Counter(
        unit[0] for seed in range(600) for unit in shown(steps(definition, seed))
    )
    assert chisquare([first_places[clip(index)] for index in range(4)]).pvalue > 0.001


def test_sets_name_what_stands_together_and_a_fixed_order_leaves_it_there() -> None:
    sets = [["clip_2", "clip_0"], ["clip_1", "clip_3"]]
    found = shown(steps(study(trials("ab", 4, sets=sets, order="fixed"))))
    assert found == [(clip(2), clip(0)), (clip(1), clip(3))]


def test_x_is_one_of_the_two_as_often_as_the_other() -> None:
    definition = study(trials("abx", 2))
    drawn = Counter(steps(definition, seed)[0]["x"] for seed in range(1000))
    assert set(drawn) == {0, 1}
    assert chisquare(list(drawn.values())).pvalue > 0.001


def test_attention_checks_stand_among_the_trials_never_first_and_repeats_name_their_first() -> None:
    checks = [
        {"kind": "instructed", "id": "say", "text": "Choose happy.", "answers": {"sad_happy": 2}},
        {"kind": "repeated", "id": "again", "count": 2},
        {
            "kind": "catch", "id": "easy", "stimulus": {"clip": clip(77), "name": "lying"},
            "answers": {"sad_happy": [-2, 0]},
        },
    ]  # fmt: skip
    definition = study(trials(number=8, checks=checks, practice=1))
    for seed in range(50):
        found = steps(definition, seed)
        assert Counter(step.get("check") for step in found) == {
            None: 9, "say": 1, "again": 2, "easy": 1,
        }  # fmt: skip
        assert "check" not in found[1]
        for index, step in enumerate(found):
            if step.get("check") == "again":
                first = found[step["of"]]
                assert step["of"] < index
                assert first["clips"] == step["clips"]
                assert not first["practice"]
                assert "check" not in first


def test_a_pause_comes_after_so_many_trials_and_not_at_the_end() -> None:
    found = steps(study(trials(number=6, break_every=3)))
    assert [step["part"] == "pause" for step in found] == [False] * 3 + [True] + [False] * 3


@pytest.mark.parametrize("kind", TASKS)
def test_every_kind_can_be_planned(kind: str) -> None:
    found = steps(study(trials(kind, 3, practice=1)))
    assert found[0]["practice"]
    assert all(step["clips"] for step in found)


def test_scales_stand_in_one_drawn_order_per_participant_where_asked() -> None:
    definition = study(trials(task={"shuffle_scales": True}))
    orders = {
        tuple(draw_plan(definition, seed, 0, "")["scales"]["semantic_differential"])
        for seed in range(20)
    }
    assert orders == {("sad_happy", "weak_strong"), ("weak_strong", "sad_happy")}
