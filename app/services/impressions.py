"""What people saw in a study's clips: the analysis of a part with pairs of adjectives.

Source: M. Oshita et al., sections 3.4 to 3.6. What is computed, and from what: docs/impressions.md.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from datetime import datetime
from typing import Any, NamedTuple

import numpy as np
from sqlalchemy.orm import Session

from app.persistence import impressions as store
from app.schemas.impressions import (
    LEAST_PEAK,
    MOST_SPREAD,
    AnalysisChoices,
    Cluster,
    Impressions,
    Merge,
    Pair,
    Rated,
)
from app.schemas.live import Role
from app.schemas.results import SessionKind
from app.services import impression_names as naming
from app.services import impression_sentences as sentences
from app.services.impression_answers import Answers, answers, rated_clips
from app.services.impression_pairs import other_way
from app.services.impression_solution import LEAST, Solution, solve
from app.services.rights import NEEDED
from app.statistics.intervals import Samples
from app.statistics.quantification import quantify


class Live(NamedTuple):
    """What a researcher tries out, in place of what is saved."""

    least_peak: float | None = None
    most_spread: float | None = None
    clusters: int | None = None


class Analysed(NamedTuple):
    """A part's answers with the choices in force and what they give.

    Attributes:
        choices: names by the pair that stands first in each cluster, and the moves that hold.
        saved: the choices as they are stored, or the defaults; saved_at: None for these.
    """

    answers: Answers
    saved: AnalysisChoices
    saved_at: datetime | None
    choices: AnalysisChoices
    solution: Solution | None

    @property
    def titles(self) -> list[naming.Called]:
        """What each cluster is called."""
        pairs = {pair.id: pair for pair in self.answers.pairs}
        clusters = self.solution.clusters if self.solution else []
        return naming.titles(clusters, pairs, self.choices.names)


def analysed(
    db: Session, slug: str, part: str | None, kind: SessionKind, live: Live | None = None
) -> Analysed:
    """The analysis of a part by the saved choices, or by what is tried out in their place.

    Raises:
        NotFoundError: no such study or part, nothing is published, or it asks otherwise.
    """
    found = answers(db, slug, part, kind)
    row = store.saved(db, found.study_id, found.part.id)
    saved = AnalysisChoices.model_validate(row.choices) if row else defaults(found.reach)
    return _by_choices(found, saved, row.saved_at if row else None, live or Live())


def turned(found: Analysed, pairs: Collection[str]) -> Analysed:
    """The saved analysis as it were, had these pairs been asked the other way round.

    What is kept stays the same, but a turned pair goes together with others. Names go along to the
    clusters that overlap theirs most.
    """
    asked = found.answers
    signs = np.array([-1.0 if pair in pairs else 1.0 for pair in asked.ids])
    ratings = asked.ratings * signs
    there = replace(
        asked,
        pairs=tuple(other_way(pair) if pair.id in pairs else pair for pair in asked.pairs),
        ratings=ratings,
        quantified=quantify(ratings),
    )
    solution = _solved(there, found.saved)
    names: dict[str, str] = {}
    if found.solution and solution:
        names = naming.carried(found.solution, found.saved.names, solution)
    moved = solution.moved if solution else {}
    in_force = found.saved.model_copy(update={"names": names, "moved": moved})
    return found._replace(answers=there, choices=in_force, solution=solution)


def defaults(reach: int) -> AnalysisChoices:
    """The paper's thresholds, which are for answers from −2 to 2, on a scale of this reach."""
    return AnalysisChoices(least_peak=LEAST_PEAK * reach / 2, most_spread=MOST_SPREAD * reach / 2)


def impressions(
    db: Session,
    slug: str,
    role: Role,
    part: str | None = None,
    kind: SessionKind = "participant",
    live: Live | None = None,
) -> Impressions:
    """The whole analysis as the page shows it.

    Args:
        db: where to read.
        slug: which study.
        role: of whoever asks.
        part: which part; None for the first that asks for pairs of adjectives.
        kind: whether people's answers are analysed or simulated ones.
        live: thresholds and cut in place of the saved ones.

    Raises:
        NotFoundError: as in `analysed`.
    """
    return shown(db, analysed(db, slug, part, kind, live), role)


def shown(db: Session, found: Analysed, role: Role) -> Impressions:
    """An analysis as the page shows it."""
    asked, solution = found.answers, found.solution
    numbers = asked.quantified
    return Impressions(
        slug=asked.slug,
        title=asked.title,
        kind=asked.kind,
        part=asked.part,
        parts=list(asked.parts),
        reach=asked.reach,
        participants=len(asked.ratings),
        simulated=len(store.counted(db, asked.study_id, "simulated")),
        choices=found.choices,
        saved_at=found.saved_at,
        clips=_clips(asked),
        pairs=_pairs(found),
        kept=list(solution.kept) if solution else [],
        leaves=solution.leaves if solution else [],
        merges=_merges(solution) if solution else [],
        matrix=listed(solution.matrix[:, solution.tree.order]) if solution else [],
        means=listed(numbers.mean),
        spreads=listed(numbers.spread),
        clusters=clusters(found),
        sentence=sentences.outcome(asked, solution, found.titles),
        notes=sentences.notes(asked, found.saved, found.choices, solution),
        problem=None if solution else sentences.problem(asked, found.choices),
        may_edit=role in NEEDED["edit"],
    )


def clusters(found: Analysed) -> list[Cluster]:
    """The clusters with their titles and values."""
    solution = found.solution
    if solution is None:
        return []
    values = listed(solution.values.T)
    return [
        Cluster(
            key=members[0],
            title=called.text,
            named=called.named,
            members=list(members),
            values=of_clips,
        )
        for members, called, of_clips in zip(solution.clusters, found.titles, values, strict=True)
    ]


def _by_choices(
    found: Answers, saved: AnalysisChoices, saved_at: datetime | None, live: Live
) -> Analysed:
    tried = {name: value for name, value in live._asdict().items() if value is not None}
    choices = saved.model_copy(update=tried)
    solution = _solved(found, choices)
    names: dict[str, str] = {}
    if solution and choices == saved:
        names = naming.in_force(solution.clusters, saved.names)
    elif solution and saved.names:
        before = _solved(found, saved)
        names = naming.carried(before, saved.names, solution) if before else {}
    moved = solution.moved if solution else {}
    in_force = choices.model_copy(update={"names": names, "moved": moved})
    return Analysed(found, saved, saved_at, in_force, solution)


def _solved(found: Answers, choices: AnalysisChoices) -> Solution | None:
    """The solution, if at least two people answered: nobody can agree alone."""
    if len(found.ratings) < LEAST:
        return None
    return solve(found.quantified, found.ids, choices, found.reach)


def _clips(asked: Answers) -> list[Rated]:
    return [
        Rated(
            clip=one.clip or "",
            name=one.name or one.clip or "",
            label=str(one.label or one.name or one.clip),
            raters=int(raters),
        )
        for one, raters in zip(asked.clips, rated_clips(asked), strict=True)
    ]


def _pairs(found: Analysed) -> list[Pair]:
    numbers, solution = found.answers.quantified, found.solution
    peaks, spreads = listed(numbers.peak), listed(numbers.mean_spread)
    return [
        Pair(
            id=pair.id,
            left=pair.left,
            right=pair.right,
            peak=peak,
            spread=spread,
            dropped=sentences.dropped(peak, spread, found.choices),
            cluster=solution.cluster_of(pair.id) if solution else None,
            moved=pair.id in found.choices.moved,
        )
        for pair, peak, spread in zip(found.answers.pairs, peaks, spreads, strict=True)
    ]


def _merges(solution: Solution) -> list[Merge]:
    return [
        Merge(
            left=int(one), right=int(other), height=height, increase=height**2 / 2, size=int(size)
        )
        for one, other, height, size in solution.tree.merges.tolist()
    ]


def listed(numbers: Samples) -> Any:  # noqa: ANN401 -- lists as deep as the array
    """Numbers as JSON has them: None where one is unknown."""
    return np.where(np.isnan(numbers), np.array(None), numbers).tolist()
