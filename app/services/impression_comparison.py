"""Two analyses of adjective pairs side by side: how far they agree, and which pairs moved."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sqlalchemy.orm import Session

from app.persistence import impressions as store
from app.persistence import studies
from app.schemas.impressions import (
    Comparable,
    ComparableList,
    ComparedCluster,
    ComparedPair,
    Comparison,
    MovedPair,
)
from app.schemas.results import SessionKind
from app.schemas.study import Scale, SemanticDifferential
from app.services import impression_sentences as sentences
from app.services import impressions, rights
from app.services.impression_answers import answers, pair_words
from app.services.impression_pairs import Same, same_pairs
from app.services.impression_solution import LEAST, shared_labels
from app.services.impressions import Analysed
from app.services.rights import Access
from app.services.sentences import number
from app.services.studies import definition_of
from app.statistics.agreement import adjusted_rand, contingency, matching


def comparison(
    db: Session,
    access: Access,
    part: str,
    other: str,
    other_part: str | None = None,
    kind: SessionKind = "participant",
) -> Comparison:
    """A part's saved analysis beside that of another study, or of another part.

    Pairs are the same if their ids are, or else their words; where the other study has the poles
    the other way round, its answers are turned before they are grouped. The index is over the pairs
    that both keep.

    Args:
        db: where to read.
        access: whoever asks, and the study here.
        part: which of its parts.
        other: address of the other study, which the researcher may see as well.
        other_part: which of its parts; None for the first that asks for pairs of adjectives.
        kind: whether people's answers are compared or simulated ones.

    Raises:
        NotFoundError: no such study or part, or not the researcher's.
    """
    elsewhere = rights.access(db, other, access.researcher_id, "view")
    here = impressions.analysed(db, access.slug, part, kind)
    there = impressions.analysed(db, elsewhere.slug, other_part, kind)
    same = same_pairs(here.answers.pairs, there.answers.pairs)
    turned = {pair for pair, known in same.items() if known.turned}
    if turned:
        there = impressions.turned(there, turned)
    return _told(_Side.of(here), _Side.of(there, same), same)


def comparable(db: Session, access: Access, part: str, kind: SessionKind) -> ComparableList:
    """What a part can be set beside: parts of the researcher's studies that ask for the same pairs.

    Raises:
        NotFoundError: no such part.
    """
    asked = answers(db, access.slug, part, kind)
    visible = rights.visible(db, access.researcher_id)
    found: list[Comparable] = []
    for study in studies.all_studies(db):
        version = studies.newest_version(db, study) if study.id in visible else None
        if version is None or len(store.counted(db, study.id, kind)) < LEAST:
            continue
        for one in definition_of(version).trials:
            itself = (study.id, one.id) == (asked.study_id, part)
            if itself or not isinstance(one.task, SemanticDifferential):
                continue
            if len(same_pairs(asked.pairs, one.task.scales)) >= LEAST:
                found.append(Comparable(slug=study.slug, title=study.title, part=one.id))
    return ComparableList(studies=found)


class _Side(NamedTuple):
    """A study's analysis with the pairs as the study here calls them."""

    found: Analysed
    same: Mapping[str, Same] | None
    clusters: list[list[str]]
    titles: list[str]

    @staticmethod
    def of(found: Analysed, same: Mapping[str, Same] | None = None) -> _Side:
        side = _Side(found, same, [], [each.text for each in found.titles])
        members = found.solution.clusters if found.solution else []
        return side._replace(clusters=[[side.called(pair) for pair in each] for each in members])

    def called(self, pair: str) -> str:
        """A pair's id here; of one that is not asked here an id that no pair has."""
        if self.same is None:
            return pair
        return self.same[pair].id if pair in self.same else f"{pair} there"

    @property
    def titled(self) -> dict[str, str]:
        """Each kept pair's cluster by its title."""
        both = zip(self.clusters, self.titles, strict=True)
        return {pair: title for members, title in both for pair in members}

    def listed(self, differ: set[str], like: Mapping[int, int]) -> list[ComparedCluster]:
        """The clusters as the page shows them."""
        scales = {pair.id: pair for pair in self.found.answers.pairs}
        own = self.found.solution.clusters if self.found.solution else []
        return [
            ComparedCluster(
                key=members[0],
                title=title,
                like=like.get(place),
                members=[self._pair(scales[pair], differ) for pair in members],
            )
            for place, (members, title) in enumerate(zip(own, self.titles, strict=True))
        ]

    def _pair(self, scale: Scale, differ: set[str]) -> ComparedPair:
        known = self.same.get(scale.id) if self.same else None
        return ComparedPair(
            id=scale.id,
            left=scale.left,
            right=scale.right,
            differs=self.called(scale.id) in differ,
            turned=known is not None and known.turned,
        )


def _told(here: _Side, there: _Side, same: Mapping[str, Same]) -> Comparison:
    both, one, another = shared_labels(here.clusters, there.clusters)
    matched, overlap = matching(one, another), contingency(one, another)
    alike = {row: column for row, column in matched.pairs if overlap[row, column]}
    rand = adjusted_rand(one, another) if len(both) > 1 else None
    gone = {pair for pair, moved in zip(both, matched.moved, strict=True) if moved}
    asked_there = {known.id for known in same.values()}
    asked = [pair for pair in here.found.answers.pairs if pair.id in asked_there]
    moved = _moved(asked, gone, here.titled, there.titled)
    differ = {pair.id for pair in moved}
    turned = [
        pair for pair in there.found.answers.pairs if pair.id in same and same[pair.id].turned
    ]
    return Comparison(
        here=here.found.answers.title,
        there=there.found.answers.title,
        shared=len(both),
        rand=rand,
        turned=len(turned),
        here_clusters=here.listed(differ, alike),
        there_clusters=there.listed(differ, {column: row for row, column in alike.items()}),
        moved=moved,
        sentence=_sentence(here.found, there.found, len(asked), len(both), rand, moved, turned),
    )


def _moved(
    asked: Sequence[Scale], gone: set[str], here: dict[str, str], there: dict[str, str]
) -> list[MovedPair]:
    """The pairs in clusters that do not correspond, and those that only one of both keeps."""
    return [
        MovedPair(
            id=pair.id, left=pair.left, right=pair.right,
            here=here.get(pair.id), there=there.get(pair.id),
        )
        for pair in asked
        if pair.id in gone or (pair.id in here) != (pair.id in there)
    ]  # fmt: skip


def _sentence(
    here: Analysed,
    there: Analysed,
    asked: int,
    shared: int,
    rand: float | None,
    moved: Sequence[MovedPair],
    turned: Sequence[Scale],
) -> str:
    for found in (here, there):
        if found.solution is None:
            problem = sentences.problem(found.answers, found.choices)
            return f"“{found.answers.title}” has no clusters yet. {problem}"
    begun = f"Both studies ask for {asked} pairs alike and both keep {shared} of them"
    if rand is None:
        return f"{begun}, which is too few to compare clusters."
    elsewhere = sum(one.here is not None and one.there is not None for one in moved)
    dropped = len(moved) - elsewhere
    return (
        f"{begun}. Over these the clusters agree by an adjusted Rand index of {number(rand)} "
        f"(1 is the same clusters, 0 what chance gives). {elsewhere} of them "
        f"{'is' if elsewhere == 1 else 'are'} in another cluster; {dropped} more "
        f"{'is' if dropped == 1 else 'are'} kept by one study only."
        f"{_turned(there.answers.title, turned)}"
    )


def _turned(title: str, turned: Sequence[Scale]) -> str:
    if not turned:
        return ""
    words = sentences.listed([f"“{pair_words(pair)}”" for pair in turned])
    asks = "is asked" if len(turned) == 1 else "are asked"
    return (
        f" {words} {asks} the other way round in “{title}”. The answers were turned before they "
        "were grouped, so its clusters may differ from those on its own page."
    )
