"""An analysis of adjective pairs in words: what came out, what could not be taken in, and why."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from app.schemas.impressions import AnalysisChoices
from app.services.impression_answers import Answers, pair_words, rated_clips
from app.services.impression_names import Called
from app.services.impression_solution import LEAST, Solution
from app.services.sentences import number
from app.statistics.quantification import kept


def dropped(peak: float | None, spread: float | None, choices: AnalysisChoices) -> str | None:
    """Why a pair is left out (equation 3); None for a kept one."""
    if peak is None:
        return "Nobody rated it."
    reasons = []
    if peak < choices.least_peak:
        reasons.append(
            f"No clip stands out on it: the greatest mean is {number(peak)}, "
            f"less than {number(choices.least_peak)}."
        )
    if spread is not None and spread > choices.most_spread:
        reasons.append(
            f"People disagree on it: their spread is {number(spread)}, "
            f"more than {number(choices.most_spread)}."
        )
    return " ".join(reasons) or None


def outcome(asked: Answers, solution: Solution | None, titles: Sequence[Called]) -> str:
    """What came out."""
    rated = int(np.count_nonzero(rated_clips(asked)))
    begun = (
        f"{_people(asked)} rated {_count(rated, 'clip')} on {len(asked.pairs)} pairs of adjectives"
    )
    if solution is None:
        return f"{begun}."
    parts = [
        f"{called.text} ({_count(len(members), 'pair')})"
        for called, members in zip(titles, solution.members, strict=True)
    ]
    gone = len(asked.pairs) - len(solution.kept)
    left = f"; {gone} {'is' if gone == 1 else 'are'} dropped" if gone else ""
    made = "one cluster" if len(parts) == 1 else f"{len(parts)} clusters"
    return f"{begun}. {len(solution.kept)} are kept{left}. They make {made}: {listed(parts)}."


def problem(asked: Answers, choices: AnalysisChoices) -> str:
    """Why there are no clusters."""
    people, rated = len(asked.ratings), int(np.count_nonzero(rated_clips(asked)))
    if people < LEAST:
        have = "one" if people else "none"
        return f"This needs the answers of two complete participants; so far there is {have}."
    if rated < LEAST:
        return "Pairs can only be told apart by two clips or more; so far one is rated."
    stay = int(kept(asked.quantified, choices.least_peak, choices.most_spread).sum())
    if stay < LEAST:
        have = "one pair is" if stay else "no pair is"
        return (
            f"By these thresholds {have} kept, and clusters need two. Let clips stand out less "
            "(a lower μ*), or let people disagree more (a higher σ̄)."
        )
    return "No two clips have an answer on every kept pair, so the pairs cannot be compared."


def notes(
    asked: Answers, saved: AnalysisChoices, choices: AnalysisChoices, solution: Solution | None
) -> list[str]:
    """What of the answers or the choices could not be taken in, a sentence each."""
    found = []
    if len(asked.numbers) > 1:
        found.append(f"Versions {listed(list(map(str, asked.numbers)))} are taken together.")
    if len(asked.ratings) >= LEAST and np.isnan(asked.quantified.mean_spread).all():
        found.append(
            "No two people rated the same clip, so how far they agree is unknown; "
            "only the greatest means decide which pairs are kept."
        )
    if solution is None:
        return found
    words = {pair.id: pair_words(pair) for pair in asked.pairs}
    if missing := _missing(asked, solution):
        found.append(
            f"{_count(len(missing), 'clip')} without an answer on every kept pair "
            f"{'is' if len(missing) == 1 else 'are'} left out of the tree: {listed(missing)}."
        )
    if len(solution.kept) < choices.clusters:
        found.append(f"Only {len(solution.kept)} pairs are kept, so each is a cluster of its own.")
    for pair in solution.left_out:
        found.append(
            f"That “{words.get(pair, pair)}” was moved by hand is left out of this view: "
            "the pair, or the one that it was moved to, is dropped."
        )
    return found + _nameless(saved, choices)


def _nameless(saved: AnalysisChoices, choices: AnalysisChoices) -> list[str]:
    borne = set(choices.names.values())
    return [
        f"No cluster is called “{name}” in this view: the pairs that it was given to are elsewhere."
        for name in dict.fromkeys(saved.names.values())
        if name not in borne
    ]


def _missing(asked: Answers, solution: Solution) -> list[str]:
    return [
        f"“{one.label or one.name}”"
        for one, complete in zip(asked.clips, solution.complete, strict=True)
        if not complete
    ]


def _people(asked: Answers) -> str:
    kind = "simulated participant" if asked.kind == "simulated" else "participant"
    return _count(len(asked.ratings), kind)


def _count(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def listed(parts: Sequence[str]) -> str:
    """Up to twelve, with commas and an “and”."""
    shown = list(parts[:12])
    if more := len(parts) - len(shown):
        shown.append(f"{more} more")
    return shown[0] if len(shown) == 1 else f"{', '.join(shown[:-1])} and {shown[-1]}"
