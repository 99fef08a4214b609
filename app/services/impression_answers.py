"""The answers behind an analysis of adjective pairs: read once, and again when they change."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.persistence import impressions as store
from app.persistence import responses
from app.persistence.models import Study
from app.schemas.results import PartName, SessionKind
from app.schemas.study import Scale, SemanticDifferential, Stimulus
from app.services import result_axes
from app.services.studies import find
from app.services.versions import Version, pooled, published
from app.statistics.intervals import Samples
from app.statistics.quantification import Quantified, quantify

KEPT_READ = 32  # parts of studies; 300 people, 30 clips and 41 pairs are 3 MB


@dataclass(frozen=True)
class Answers:
    """All that people said of a part's clips, with what they were asked.

    Attributes:
        study: whose; slug, title.
        part: which; parts: all of the study that ask for pairs of adjectives.
        kind: people's answers or simulated ones.
        pairs: the scales of all versions that asked alike, the newest version's first.
        clips: likewise.
        reach: of the outermost step.
        versions: hashes of the versions that the answers belong to; numbers: as people count them.
        ratings: (participants, clips, pairs); NaN where not rated.
    """

    study_id: int
    slug: str
    title: str
    part: PartName
    parts: tuple[PartName, ...]
    kind: SessionKind
    pairs: tuple[Scale, ...]
    clips: tuple[Stimulus, ...]
    reach: int
    versions: tuple[str, ...]
    numbers: tuple[int, ...]
    ratings: Samples
    quantified: Quantified

    @property
    def ids(self) -> list[str]:
        """The pairs' ids, in their order."""
        return [pair.id for pair in self.pairs]


def answers(db: Session, slug: str, part: str | None, kind: SessionKind) -> Answers:
    """The counted answers to a part; without its name, to the first with pairs of adjectives.

    Raises:
        NotFoundError: no such study or part, nothing is published, or the part asks otherwise.
    """
    study = find(db, slug)
    versions = published(db, study)
    parts = _parts(versions)
    name = next((one for one in parts if part in (None, one.id)), None)
    if name is None:
        raise _asks_otherwise(part, parts)
    asked = store.counted(db, study.id, kind)
    key = (study.id, name.id, kind)
    state = (study.slug, study.title, tuple(one.hash for one in versions.values()), asked)
    known = _read.get(key, state)
    if known is None:
        known = _answers(db, study, versions, parts, name, kind)
        if store.counted(db, study.id, kind) == asked:  # or somebody came or left while we read
            _read.put(key, state, known)
    return known


def pair_words(pair: Scale) -> str:
    """How a sentence calls a pair."""
    return f"{pair.left} – {pair.right}"


def _answers(
    db: Session,
    study: Study,
    versions: dict[int, Version],
    parts: Sequence[PartName],
    name: PartName,
    kind: SessionKind,
) -> Answers:
    asked = pooled(versions, name.id)
    rows = responses.analysed(db, study, asked.part, kind)
    rows = [row for row in rows if row.version_id in asked.versions]
    scales: dict[str, Scale] = {}
    for version in (versions[key] for key in asked.versions):
        for trials in version.definition.trials:
            if trials.id == asked.part and isinstance(trials.task, SemanticDifferential):
                for scale in trials.task.scales:
                    scales.setdefault(scale.id, scale)
    answered = {row.version_id for row in rows}
    of_rows = [(versions[key].hash, number)
               for key, number in zip(asked.versions, asked.numbers, strict=True)
               if key in answered]  # fmt: skip
    assert isinstance(asked.task, SemanticDifferential)  # noqa: S101 -- `_parts` has only those
    ratings = result_axes.rating_array(asked, rows)
    ratings.setflags(write=False)  # several requests share it
    return Answers(
        study_id=study.id,
        slug=study.slug,
        title=study.title,
        part=name,
        parts=tuple(parts),
        kind=kind,
        pairs=tuple(scales[measure.id] for measure in asked.measures),
        clips=tuple(asked.stimuli),
        reach=asked.task.reach,
        versions=tuple(known_as for known_as, _ in of_rows),
        numbers=tuple(sorted(number for _, number in of_rows)),
        ratings=ratings,
        quantified=quantify(ratings),
    )


def _parts(versions: dict[int, Version]) -> list[PartName]:
    """The parts that ask for at least two pairs, as the newest version that has them asks."""
    found: dict[str, PartName | None] = {}
    for version in versions.values():
        for part in version.definition.trials:
            task = part.task
            asks = isinstance(task, SemanticDifferential) and len(task.scales) > 1
            named = PartName(id=part.id, kind=task.kind, question=str(task.question))
            found.setdefault(part.id, named if asks else None)
    return [name for name in found.values() if name]


def _asks_otherwise(part: str | None, parts: Sequence[PartName]) -> NotFoundError:
    if not parts:
        return NotFoundError(
            "This study asks for no pairs of adjectives.",
            code="no_adjectives",
            mend="Add a part whose questions stand between opposite words, at least two of them.",
        )
    return NotFoundError(
        f"The study has no part “{(part or '')[:60]}” with pairs of adjectives.",
        code="part_not_found",
        mend=f"It has: {', '.join(one.id for one in parts)}.",
    )


class _Read:
    """The answers read last, each with the state of the study that it was read in."""

    def __init__(self) -> None:
        self._kept: OrderedDict[object, tuple[object, Answers]] = OrderedDict()
        self._gate = threading.Lock()

    def get(self, key: object, state: object) -> Answers | None:
        with self._gate:
            was, found = self._kept.get(key, (None, None))
            return found if was == state else None

    def put(self, key: object, state: object, found: Answers) -> None:
        with self._gate:
            self._kept[key] = state, found
            self._kept.move_to_end(key)
            while len(self._kept) > KEPT_READ:
                self._kept.popitem(last=False)


_read = _Read()


def rated_clips(found: Answers) -> np.ndarray[tuple[int], np.dtype[np.intp]]:
    """How many people rated each clip on anything (clips,)."""
    return np.asarray((~np.isnan(found.ratings)).any(axis=2).sum(axis=0))
