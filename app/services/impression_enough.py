"""How many participants would do, and what else a bootstrap comes to, in words."""

from __future__ import annotations

from collections.abc import Sequence

from app.schemas.impressions import Agreement, ByParticipants, Enough, PairStability
from app.services.impression_solution import Solution
from app.services.sentences import number

GOOD = 0.9  # the adjusted Rand index from which on a number of participants is said to do
SURE = 0.9  # the share of samples from which on a pair is said to stay


def enough(tried: Sequence[ByParticipants]) -> Enough:
    """From how many participants on the index is good, for groups alone and for the whole."""
    whole = _least(tried, [one.whole for one in tried])
    shared = _least(tried, [one.shared for one in tried])
    return Enough(
        index=GOOD,
        most=tried[-1].participants,
        whole=whole.participants if whole else None,
        shared=shared.participants if shared else None,
        sentence=" ".join([_answer(tried[-1], whole), _groups(shared)]),
    )


def sentence(
    solution: Solution,
    pairs: Sequence[PairStability],
    whole: Agreement,
    shared: Agreement | None,
    samples: int,
) -> str:
    """What stays with as many participants."""
    sure = sum(one.kept >= SURE for one in pairs if one.id in solution.kept)
    told = [
        f"With other participants of the same kind, {sure} of the {len(solution.kept)} kept pairs "
        f"would stay in at least {SURE * 100:.0f} % of {samples:,} draws.",
        f"The whole solution, pairs left out being a group of their own, is found again by an "
        f"adjusted Rand index of {_spoken(whole)}.",
    ]
    if shared:
        told.append(f"Over the pairs that both keep it is {_spoken(shared)}.")
    if solution.moved:
        told.append("Moves by hand are not repeated in the draws.")
    return " ".join(told)


def _least(
    tried: Sequence[ByParticipants], found: Sequence[Agreement | None]
) -> ByParticipants | None:
    """The least number of participants from which on every tried one does."""
    poor = [place for place, one in enumerate(found) if one is None or one.mean < GOOD]
    rest = tried[poor[-1] + 1 if poor else 0 :]
    return rest[0] if rest else None


def _answer(last: ByParticipants, whole: ByParticipants | None) -> str:
    if whole:
        return (
            f"The same pairs, grouped the same: from about {whole.participants} participants "
            f"on the index is {GOOD} or more on average; with {whole.participants} it is "
            f"{_spoken(whole.whole)}."
        )
    return (
        f"The same pairs, grouped the same: with {last.participants} participants the index "
        f"is {_spoken(last.whole)}, and {GOOD} is wanted on average."
    )


def _groups(shared: ByParticipants | None) -> str:
    if shared is None or shared.shared is None:
        return "The groups alone, over the pairs that both keep, are no surer."
    return (
        f"The groups alone, over the pairs that both keep: {_spoken(shared.shared)} "
        f"with {shared.participants}."
    )


def _spoken(one: Agreement) -> str:
    return f"{number(one.mean)} (95 % of draws: {number(one.low)} to {number(one.high)})"
