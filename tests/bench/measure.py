"""Medians of several runs, taken in turn so that a noisy machine treats everybody alike."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass

RUNS = 7


@dataclass(frozen=True)
class Row:
    """One line of the table: what was measured, of whom, how much, and the aim if there is one."""

    what: str
    who: str
    value: float
    unit: str
    aim: str = ""
    spread: tuple[float, float] | None = None


def in_turn(
    contenders: Mapping[str, Callable[[], object]], runs: int = RUNS
) -> dict[str, list[float]]:
    """Seconds of each run of each contender: A B C A B C …, after one warm-up each."""
    for run in contenders.values():
        run()
    seconds: dict[str, list[float]] = {name: [] for name in contenders}
    for _ in range(runs):
        for name, run in contenders.items():
            start = time.perf_counter()
            run()
            seconds[name].append(time.perf_counter() - start)
    return seconds


def rates(
    what: str, contenders: Mapping[str, Callable[[], object]], work: float, unit: str, aim: str = ""
) -> list[Row]:
    """Work per second of each contender; the aim belongs to the first, which is ours."""
    rows = []
    for position, (name, seconds) in enumerate(in_turn(contenders).items()):
        speeds = [work / s for s in seconds]
        spread = (min(speeds), max(speeds))
        rows.append(
            Row(what, name, statistics.median(speeds), unit, aim if position == 0 else "", spread)
        )
    return rows


def durations(
    what: str, contenders: Mapping[str, Callable[[], object]], unit: str = "ms", aim: str = ""
) -> list[Row]:
    """Milliseconds of each contender; the aim belongs to the first, which is ours."""
    rows = []
    for position, (name, seconds) in enumerate(in_turn(contenders).items()):
        times = [1000 * s for s in seconds]
        spread = (min(times), max(times))
        rows.append(
            Row(what, name, statistics.median(times), unit, aim if position == 0 else "", spread)
        )
    return rows
