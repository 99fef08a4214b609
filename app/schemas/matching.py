"""The results of a matching experiment, as figures 7 to 11 of Oshita et al. and their tests."""

from __future__ import annotations

from typing import Literal

from app.schemas.result import Result
from app.schemas.study import Interface

FigureName = Literal["guess", "guessed", "seconds", "saved", "failed"]


class MatchBar(Result):
    """One interface on one target. `target` is null for all of them together.

    Attributes:
        value: mean or share; low, high: one standard deviation around it, or the interval that the
            figure names; n: how many answers.
    """

    target: str | None
    interface: Interface
    value: float | None
    low: float | None
    high: float | None
    n: int


class MatchFigure(Result):
    """One figure.

    Attributes:
        unit: m, s, or a share of 1 where empty.
        reach: what low and high are.
    """

    name: FigureName
    title: str
    unit: str
    reach: str
    bars: list[MatchBar]
    sentence: str


class Ranked(Result):
    """Wilcoxon's signed-rank test, two-sided.

    Attributes:
        n: pairs that differ; zeros: pairs that do not, which are left out.
        exact: whether p is exact, and not by the normal distribution.
    """

    statistic: float
    p: float
    n: int
    zeros: int
    exact: bool


class MatchTest(Result):
    """Two interfaces compared on one target, or on all: null where no pair differs."""

    target: str | None
    one: Interface
    other: Interface
    guess: Ranked | None
    seconds: Ranked | None


class Matching(Result):
    """A matching experiment's numbers; `reference` is what saved times are compared with."""

    interfaces: list[Interface]
    targets: list[str]
    threshold: float
    limit: int
    reference: Interface | None
    figures: list[MatchFigure]
    tests: list[MatchTest]
    rule: str
