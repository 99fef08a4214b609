"""A matching experiment's results: every answer in its place, and the figures drawn from them."""

from __future__ import annotations

import uuid
from typing import Any

import numpy as np
import pytest
from scipy import stats

from app.figures import render
from app.figures.matching import ALL, Bar, targets
from app.persistence.responses import Counted
from app.schemas.results import Clip
from app.schemas.study import Trials
from app.services.matching_results import answers_of, matching
from app.services.measures import measures
from app.services.versions import Pooled

INTERFACES = ("weights", "adjectives", "features")


def part(**task: Any) -> Trials:
    return Trials.model_validate(
        {
            "kind": "trials",
            "id": "matching",
            "task": {"kind": "match", "question": "Match it.", "space": "Walks", **task},
            "stimuli": ["one", "two"],
        }
    )


def pooled(asked: Trials) -> Pooled:
    return Pooled("matching", asked.task, list(asked.stimuli), measures(asked), [1], [1], [])


CLIPS = [Clip(id=name, name=name, label=name.title(), body="", style="") for name in ("one", "two")]


def answered(people: int = 13, seed: int = 1) -> tuple[list[Counted], dict[str, np.ndarray]]:
    """Answers in any order, and the same as arrays (people, targets, interfaces)."""
    rng = np.random.default_rng(seed)
    shape = (people, 2, 3)
    given = {
        "distance": np.round(0.03 + 0.1 * rng.random(shape), 6),
        "seconds": np.round(20 + 300 * rng.random(shape), 1),
    }
    given["solved"] = (given["seconds"] <= 300).astype(int)
    rows = []
    for person in range(people):
        session = uuid.UUID(int=person)
        for target, clip in enumerate(("one", "two")):
            for index, interface in enumerate(INTERFACES):
                place = person, target, index
                common = {"interface": interface, "e0": 0.5}
                guess = {**common, "seen": 0, "distance": given["distance"][place], "seconds": 9.0,
                         "solved": 0}  # fmt: skip
                match = {**common, "seen": 1, "distance": 0.05, "seconds": given["seconds"][place],
                         "solved": int(given["solved"][place])}  # fmt: skip
                rows += [Counted(session, 1, [clip], one) for one in (guess, match)]
    order = rng.permutation(len(rows))
    # Who comes first is nobody's business: people are told apart by their session alone.
    return [rows[i] for i in order], given


def test_every_answer_stands_in_its_place() -> None:
    rows, given = answered()
    found = answers_of(part().task, CLIPS, rows)
    people = list(dict.fromkeys(row.session_id.int for row in rows))
    assert np.array_equal(found.guess, given["distance"][people])
    assert np.array_equal(found.seconds, given["seconds"][people])
    assert np.array_equal(found.solved, given["solved"][people])


def test_the_table_is_scipys_test_on_each_target_and_on_all() -> None:
    rows, given = answered()
    found = matching(pooled(part()), CLIPS, rows)
    assert found is not None
    assert [(test.target, test.one, test.other) for test in found.tests][:4] == [
        ("One", "weights", "adjectives"), ("One", "weights", "features"),
        ("One", "adjectives", "features"), ("Two", "weights", "adjectives"),
    ]  # fmt: skip
    distance = given["distance"]
    one = stats.wilcoxon(distance[:, 0, 0], distance[:, 0, 1])
    assert found.tests[0].guess.p == pytest.approx(one.pvalue, abs=1e-12)
    every = stats.wilcoxon(distance[..., 1].ravel(), distance[..., 2].ravel())
    assert found.tests[-1].target is None
    assert found.tests[-1].guess.p == pytest.approx(every.pvalue, abs=1e-12)
    assert found.tests[-1].guess.n == 26


def test_the_figures_are_the_papers_five() -> None:
    rows, given = answered()
    found = matching(pooled(part()), CLIPS, rows)
    figures = {figure.name: figure for figure in found.figures}
    assert list(figures) == ["guess", "guessed", "seconds", "saved", "failed"]
    overall = [bar for bar in figures["failed"].bars if bar.target is None]
    assert [bar.value for bar in overall] == pytest.approx(1 - given["solved"].mean(axis=(0, 1)))
    time = np.where(given["solved"] == 1, given["seconds"], 300.0)
    saved = [bar for bar in figures["saved"].bars if bar.target is None]
    assert [bar.interface for bar in saved] == ["adjectives", "features"]
    assert saved[0].value == pytest.approx((time[..., 0] - time[..., 1]).mean())
    assert saved[0].low < saved[0].value < saved[0].high


def test_without_guesses_and_without_weights_their_figures_are_left_out() -> None:
    asked = part(guess_first=False, interfaces=["adjectives", "features"])
    found = matching(pooled(asked), CLIPS, answered()[0])
    assert [figure.name for figure in found.figures] == ["seconds", "failed"]
    assert found.reference is None


def test_a_target_that_somebody_never_reached_is_left_out_of_its_tests_alone() -> None:
    rows, _ = answered()
    missing = [
        row
        for row in rows
        if not (row.session_id.int == 3 and row.clips == ["two"] and row.answers["seen"])
    ]
    found = matching(pooled(part()), CLIPS, missing)
    by_place = {(test.target, test.one, test.other): test for test in found.tests}
    assert by_place["Two", "weights", "adjectives"].seconds.n <= 12
    assert by_place["One", "weights", "adjectives"].seconds.n <= 13
    assert by_place["Two", "weights", "adjectives"].guess.n == 13


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_a_chart_is_drawn_with_every_target_and_interface_named(mode: Any) -> None:
    bars = [
        Bar(target, interface, 0.1, 0.05, None if target == ALL else 0.15)
        for target in ("One", ALL)
        for interface in INTERFACES
    ]
    drawn = render.svg(targets(bars, INTERFACES, "Distance", "m", mode, 600))
    for word in ("One", ALL, *INTERFACES):
        assert word in drawn
