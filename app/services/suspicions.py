"""What makes a session suspicious: numbers from its answers, and rules with their limits.

A suspicion is a hint to look, never a verdict: nobody is left out by the server itself.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from statistics import median
from typing import Any, NamedTuple

from app.persistence.live import Limits
from app.schemas.live import Suspicion

SAME_RUN = 10  # judged trials in a row
FEWEST = 5  # judged trials below which nothing is said about their pattern
FLAT_FROM = 3  # values in a trial
FASTER = 3  # times than usual
USUAL_NEEDS = 5  # complete participants
SHORTEST_MS = 1000
HIDDEN_MS = 300_000


@dataclass(frozen=True)
class Judged:
    """An answered trial about clips, the newest answer of it."""

    part: str
    answers: Mapping[str, Any]
    rt_ms: float
    hidden_ms: float
    practice: bool = False
    check: str | None = None
    passed: bool | None = None


class Numbers(NamedTuple):
    """What the rules look at; `app.persistence.models.SessionSummary` says what each one is."""

    judged: int
    median_ms: int | None
    same_run: int
    rated: int
    flat: int
    checks: int
    failed: int
    hidden_ms: int


def measure(trials: Sequence[Judged]) -> Numbers:
    """The numbers of one session, its trials in the order in which they were shown."""
    judged = [one for one in trials if not one.practice and one.check is None]
    rated = [values for values in map(_values, judged) if len(values) >= FLAT_FROM]
    checks = [one for one in trials if one.passed is not None]
    return Numbers(
        judged=len(judged),
        median_ms=100 * round(median(one.rt_ms for one in judged) / 100) if judged else None,
        same_run=_longest_run(judged),
        rated=len(rated),
        flat=sum(len(set(values)) == 1 for values in rated),
        checks=len(checks),
        failed=sum(one.passed is False for one in checks),
        hidden_ms=round(sum(one.hidden_ms for one in trials)),
    )


def limits(usual_ms: float | None, complete: int) -> Limits:
    """From where on a number is suspicious.

    Args:
        usual_ms: the median over complete participants of their median time for a trial.
        complete: how many they are; a few say nothing about what is usual.
    """
    fast = SHORTEST_MS
    if usual_ms is not None and complete >= USUAL_NEEDS:
        fast = max(fast, int(usual_ms / FASTER))
    return Limits(
        same_run=SAME_RUN, fewest=FEWEST, fast_ms=fast, hidden_ms=HIDDEN_MS, usual_ms=usual_ms
    )


def suspicions(numbers: Numbers, limits: Limits) -> list[Suspicion]:
    """The rules that a session's numbers break, each with its number and the rule in words."""
    found = (
        _same_run(numbers, limits),
        _flat(numbers, limits),
        _too_fast(numbers, limits),
        _failed(numbers),
        _hidden(numbers, limits),
    )
    return [one for one in found if one is not None]


def _same_run(numbers: Numbers, limits: Limits) -> Suspicion | None:
    if numbers.same_run < limits.same_run:
        return None
    return Suspicion(
        id="same_answers",
        title="Straight-lining",
        number=f"{numbers.same_run} trials in a row were answered exactly alike",
        rule=f"{limits.same_run} or more in a row",
    )


def _flat(numbers: Numbers, limits: Limits) -> Suspicion | None:
    if numbers.rated < limits.fewest or 2 * numbers.flat < numbers.rated:
        return None
    return Suspicion(
        id="flat_answers",
        title="Straight-lining",
        number=f"In {numbers.flat} of {numbers.rated} trials every scale has the same step",
        rule=f"half of the trials or more, of those with {FLAT_FROM} scales or more",
    )


def _too_fast(numbers: Numbers, limits: Limits) -> Suspicion | None:
    if numbers.judged < limits.fewest or numbers.median_ms is None:
        return None
    if numbers.median_ms >= limits.fast_ms:
        return None
    rule = f"less than {_seconds(limits.fast_ms)}"
    if limits.usual_ms is not None and limits.fast_ms > SHORTEST_MS:
        rule += f", a third of the usual {_seconds(limits.usual_ms)}"
    return Suspicion(
        id="too_fast",
        title="Too fast",
        number=f"Half of the trials took {_seconds(numbers.median_ms)} or less",
        rule=rule,
    )


def _failed(numbers: Numbers) -> Suspicion | None:
    if not numbers.failed:
        return None
    return Suspicion(
        id="failed_checks",
        title="Failed checks",
        number=f"{numbers.failed} of {numbers.checks} attention checks failed",
        rule="one or more",
    )


def _hidden(numbers: Numbers, limits: Limits) -> Suspicion | None:
    if numbers.hidden_ms <= limits.hidden_ms:
        return None
    return Suspicion(
        id="hidden",
        title="Long out of sight",
        number=f"The page was out of sight for {_minutes(numbers.hidden_ms)} during trials",
        rule=f"more than {_minutes(limits.hidden_ms)}",
    )


def _values(trial: Judged) -> list[float]:
    return [value for value in trial.answers.values() if isinstance(value, int | float)]


def _longest_run(judged: Sequence[Judged]) -> int:
    """Of neighbouring trials of one part with the same answers; texts are no pattern."""
    told = [(one.part, sorted(one.answers.items())) for one in judged if _values(one)]
    return max((len(list(run)) for _, run in groupby(told)), default=0)


def _seconds(ms: float) -> str:
    return f"{ms / 1000:.1f} s"


def _minutes(ms: float) -> str:
    return f"{ms / 60_000:.0f} min"
