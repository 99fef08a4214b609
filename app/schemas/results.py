"""A study's results. A number that too few answers stand behind is null."""

from typing import Literal

from pydantic import BaseModel, ConfigDict


class Result(BaseModel):
    """A part of the results."""

    model_config = ConfigDict(frozen=True)


class Counts(Result):
    """How far the participants are.

    Attributes:
        under_way: not complete, with a sign of life (consent or answer) in the last half hour.
        left_early: not complete, without one; left_at: the clip each stopped at, counted from 1.
        answers: rows of the raw answers, practice and earlier revisions included.
        median_seconds: from consent to completion, over the complete.
    """

    complete: int
    under_way: int
    left_early: int
    left_at: list[int]
    withdrawn: int
    answers: int
    median_seconds: float | None


class Clip(Result):
    """A clip of the study."""

    id: str
    name: str
    label: str
    body: str
    style: str


class Cell(Result):
    """One clip on one axis.

    Attributes:
        mean: toward the right pole is positive; low, high: t-based 95 % interval.
        shares: part of the answers at each step from left to right, in 0 ... 1.
    """

    clip: str
    n: int
    mean: float | None
    sd: float | None
    low: float | None
    high: float | None
    shares: list[float] | None


class Axis(Result):
    """All clips on one axis, in the study's order."""

    id: str
    left: str
    right: str
    cells: list[Cell]
    sentence: str


class PoleRow(Result):
    """One row of "Is every emotion seen?": a pole's best clip against its body's clips.

    Attributes:
        mean, others: means toward the pole, of the best clip and of its comparison group.
        p_holm: Welch's p adjusted over all the poles.
        p_permuted: of a permutation test that repeats the choice of the best clip; p_permuted_holm:
            adjusted over all the poles.
        paired_t: over participants' means, the best clip less the mean of the group.
    """

    scale: str
    pole: str
    clip: Clip | None
    mean: float | None
    others: float | None
    difference: float | None
    t: float | None
    df: float | None
    p: float | None
    p_holm: float | None
    p_permuted: float | None
    p_permuted_holm: float | None
    d: float | None
    d_low: float | None
    d_high: float | None
    paired_t: float | None
    paired_df: float | None
    paired_p: float | None
    sentence: str | None


class StudyResults(Result):
    """All of the results page's numbers.

    Attributes:
        needed: complete participants below which nothing is computed.
        participants: complete ones, whose answers are analysed.
        rule: which answers are analysed, in words.
        against: "others" compares a best clip with the other clips of its body, "all" with all.
    """

    slug: str
    title: str
    study_hash: str
    needed: int
    participants: int
    rule: str
    against: Literal["others", "all"]
    counts: Counts
    steps: list[str]
    clips: list[Clip]
    axes: list[Axis]
    poles: list[PoleRow]
