"""A study's results, one part at a time. A number that too few answers stand behind is null."""

from typing import Literal

from app.schemas.matching import Matching
from app.schemas.result import Result

# Whose answers are looked at; previews are never stored.
SessionKind = Literal["participant", "simulated"]


class Counts(Result):
    """How far the participants are.

    Attributes:
        under_way: not complete, with a sign of life (consent or answer) within the study's lease.
        left_early: not complete, without one; left_after: how many steps each had answered.
        ended: screened out, or ended by failed attention checks.
        excluded: left out of the results by a researcher, whatever their state.
        answers: rows of the raw answers, practice and earlier revisions included.
        median_seconds: from consent to completion, over the complete.
    """

    complete: int
    under_way: int
    left_early: int
    left_after: list[int]
    ended: int
    excluded: int
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


class PartName(Result):
    """A part that asks about clips: its kind of trial, and what it asks."""

    id: str
    kind: str
    question: str


class Cell(Result):
    """One clip on one axis.

    Attributes:
        n: participants.
        mean: on a bipolar axis, the right pole is positive; low, high: t-based 95 % interval.
        shares: part of the answers at each step from left to right, in 0 ... 1; null where the
            answers have no steps.
    """

    clip: str
    n: int
    mean: float | None
    sd: float | None
    low: float | None
    high: float | None
    shares: list[float] | None


class Axis(Result):
    """All clips on one axis, in the study's order.

    Attributes:
        title: what was asked, in few words.
        left, right: the words at its ends.
        bipolar: whether its middle is neither the one nor the other.
        lowest, highest: the ends as numbers; steps: the words over the steps, none on a slider.
    """

    id: str
    title: str
    left: str
    right: str
    bipolar: bool
    lowest: float
    highest: float
    steps: list[str]
    cells: list[Cell]
    sentence: str


class Share(Result):
    """How often something was chosen of the times that it could be.

    Attributes:
        name: a clip's label, “none of them”, “no difference”, or the two clips of a pair.
        clip: null where it is no clip.
        share, low, high: in 0 ... 1, with Wilson's 95 % interval.
    """

    name: str
    clip: str | None
    chosen: int
    shown: int
    share: float | None
    low: float | None
    high: float | None


class Choices(Result):
    """What was chosen; of `correct`, how often the choice was right. `chance`: by guessing."""

    id: Literal["choice", "correct"]
    title: str
    chance: float | None
    rows: list[Share]
    sentence: str


class PoleRow(Result):
    """One row of "Is every quality seen?": a pole's best clip against its body's clips.

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
    """All of the results page's numbers, of one part.

    Attributes:
        state: of the study: open, paused or closed.
        study_hash: of the newest version.
        needed: complete participants below which nothing is computed.
        participants: complete ones that saw the part, whose answers are analysed.
        rule: which answers are analysed, in words.
        kind: whose: people's, or simulated participants'; simulated: how many of those there are.
        against: "others" compares a best clip with the other clips of its body, "all" with all.
        parts: all parts that ask about clips; part: the one that the numbers are of.
        axes: what was answered by numbers; choices: by choosing; poles: of bipolar scales alone.
        matching: what came of matching targets; null for parts of other kinds, and while too few
            are complete.
        texts: how many answers in words there are; they are read in the exports.
    """

    slug: str
    title: str
    state: str
    study_hash: str
    needed: int
    participants: int
    rule: str
    kind: SessionKind
    simulated: int
    against: Literal["others", "all"]
    counts: Counts
    parts: list[PartName]
    part: PartName
    clips: list[Clip]
    axes: list[Axis]
    choices: list[Choices]
    poles: list[PoleRow]
    matching: Matching | None
    texts: int
