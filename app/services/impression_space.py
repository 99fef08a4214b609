"""An analysis of adjective pairs frozen as an authoring space: from what was seen to sliders."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence

import numpy as np
from sqlalchemy.orm import Session

from app.errors import InvalidError
from app.persistence import spaces as store
from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.results import SessionKind
from app.schemas.spaces import (
    MOST_EXAMPLES,
    MOST_PARAMETERS,
    Origin,
    Parameter,
    Primary,
    Sliders,
    SpaceLine,
)
from app.schemas.study import Scale
from app.services import audit, impressions, matching, new_spaces
from app.services import impression_sentences as sentences
from app.services.impression_names import Called
from app.services.impression_solution import Solution
from app.services.impressions import Analysed
from app.services.rights import Access
from app.statistics.intervals import Samples
from app.workers import Workers


def freeze(
    database: Database,
    writer: Writer,
    workers: Workers,
    access: Access,
    part: str,
    name: str,
    kind: SessionKind = "participant",
) -> SpaceLine:
    """Make an authoring space of a part's analysis as it is saved.

    Its examples are the clips with an answer on every kept pair; its primary sliders are the
    clusters, by the means A′, and its single ones the kept pairs, by the matrix A.

    Args:
        database: read before anything is computed.
        writer: stores the space, and that it was made, in one transaction.
        workers: compute what the clips' motions add.
        access: whoever makes it.
        part: which part of the study.
        name: of the space, whose next version this is.
        kind: whether people's answers are behind it or simulated ones.

    Raises:
        NotFoundError: no such part, or a clip is gone.
        InvalidError: there are no clusters yet, there is too much for a space, or the clips cannot
            be blended with each other.
    """
    with database.reading() as db:
        found = impressions.analysed(db, access.slug, part, kind)
    solution = found.solution
    if solution is None:
        raise InvalidError(
            sentences.problem(found.answers, found.choices),
            code="no_clusters",
            mend="A space needs clusters of pairs that were kept.",
        )
    asked = zip(found.answers.clips, solution.complete, strict=True)
    clips = [one.clip or "" for one, complete in asked if complete]
    _check_size(clips, solution)
    defined = new_spaces.define(
        database,
        workers,
        name,
        clips,
        sliders(solution, found.answers.pairs, found.titles),
        origin(found, solution),
    )

    def write(db: Session) -> SpaceLine:
        fresh = store.by_id(db, defined.content_hash) is None
        line = new_spaces.keep(db, defined, study_id=access.study_id, made_by=access.researcher_id)
        if fresh:
            audit.note(
                db, access.study_id, "space_made", access.researcher_id,
                name=line.name, number=line.number, part=part, space=line.id,
            )  # fmt: skip
        return line

    return writer.write(write)


def sliders(solution: Solution, scales: Iterable[Scale], titles: Sequence[Called]) -> Sliders:
    """The clusters and the kept pairs with every example's place on them, in all languages.

    Args:
        solution: its complete clips are the examples.
        scales: all pairs that were asked about.
        titles: of the clusters.
    """
    pairs = {pair.id: pair for pair in scales}
    together = solution.values[solution.complete]
    single = solution.matrix[solution.complete]
    ids = _ids(titles, solution.kept)
    return Sliders(
        primary=tuple(
            Primary(id=known_as, title=called.title, members=tuple(members), values=_values(column))
            for known_as, called, members, column in zip(
                ids, titles, solution.clusters, together.T, strict=True
            )
        ),
        parameters=tuple(
            Parameter(
                id=pair, left=pairs[pair].left, right=pairs[pair].right, values=_values(column)
            )
            for pair, column in zip(solution.kept, single.T, strict=True)
        ),
    )


def origin(found: Analysed, solution: Solution) -> Origin:
    """Where the numbers come from."""
    asked = found.answers
    notes = sentences.notes(asked, found.saved, found.choices, solution)
    return Origin(
        study=asked.slug,
        part=asked.part.id,
        versions=asked.versions,
        kind=asked.kind,
        participants=len(asked.ratings),
        least_peak=found.choices.least_peak,
        most_spread=found.choices.most_spread,
        moved=tuple(sorted(solution.moved)),
        note=" ".join(notes),
    )


def _check_size(clips: list[str], solution: Solution) -> None:
    for count, most, what, mend in (
        (len(clips), MOST_EXAMPLES, "clips", "Ask about fewer clips in a part of its own."),
        (len(solution.kept), MOST_PARAMETERS, "pairs", "Set the thresholds to keep fewer pairs."),
    ):
        if count > most:
            raise InvalidError(
                f"These are {count} {what}; a space takes {most} at most.",
                code="space_too_large",
                mend=mend,
            )


def _ids(titles: Iterable[Called], taken: Iterable[str]) -> list[str]:
    """An id for each cluster, made of its title's letters and unlike every pair's.

    Nor is it what an answer to a match has beside its sliders, or one of both would be lost.
    """
    used = {*taken, *matching.BESIDE_SLIDERS}
    found = []
    for number, called in enumerate(titles, 1):
        plain = unicodedata.normalize("NFKD", str(called.title)).encode("ascii", "ignore").decode()
        letters = re.sub(r"[^a-z0-9]+", "_", plain.lower()).strip("_")[:40]
        wanted = letters if re.match(r"[a-z]", letters) else f"cluster_{number}"
        while wanted in used:
            wanted = f"{wanted}_{number}"
        used.add(wanted)
        found.append(wanted)
    return found


def _values(column: Samples) -> tuple[float, ...]:
    """A column (examples,); rounding may have put a mean a hair outside of 0 … 1."""
    return tuple(np.clip(column, 0.0, 1.0).tolist())
