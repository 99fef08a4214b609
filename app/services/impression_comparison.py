"""Two analyses of adjective pairs side by side: how far they agree, and which pairs moved."""

from __future__ import annotations

from collections.abc import Sequence

from sqlalchemy.orm import Session

from app.schemas.impressions import Comparison, MovedPair
from app.schemas.results import SessionKind
from app.schemas.study import Scale
from app.services import impression_sentences as sentences
from app.services import impressions, rights
from app.services.impression_solution import shared_labels
from app.services.impressions import Analysed
from app.services.rights import Access
from app.services.sentences import number
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

    Pairs are the same if their ids are, or else their words. The index is over the pairs that both
    keep.

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
    called = _as_here(here.answers.pairs, there.answers.pairs)
    ours = here.solution.clusters if here.solution else []
    theirs = [
        [called.get(pair, f"{pair} there") for pair in members]
        for members in (there.solution.clusters if there.solution else [])
    ]
    both, one, another = shared_labels(ours, theirs)
    matched = matching(one, another)
    titles = [[each.text for each in found.titles] for found in (here, there)]
    overlap = contingency(one, another)
    rand = adjusted_rand(one, another) if len(both) > 1 else None
    gone = {pair for pair, moved in zip(both, matched.moved, strict=True) if moved}
    asked = [pair for pair in here.answers.pairs if pair.id in called.values()]
    moved = _moved(asked, gone, _titled(ours, titles[0]), _titled(theirs, titles[1]))
    return Comparison(
        here=here.answers.title,
        there=there.answers.title,
        shared=len(both),
        rand=rand,
        together={
            titles[0][row]: titles[1][column]
            for row, column in matched.pairs
            if overlap[row, column]
        },
        here_clusters=impressions.clusters(here),
        there_clusters=impressions.clusters(there),
        moved=moved,
        sentence=_sentence(here, there, len(asked), len(both), rand, moved),
    )


def _as_here(here: Sequence[Scale], there: Sequence[Scale]) -> dict[str, str]:
    """The id that each pair of the other study has here, if it is asked here."""
    ids = {pair.id for pair in here}
    by_words = {_words(pair): pair.id for pair in here}
    found: dict[str, str] = {}
    for pair in sorted(there, key=lambda pair: pair.id not in ids):  # ids before words
        known = pair.id if pair.id in ids else by_words.get(_words(pair))
        if known is not None and known not in found.values():
            found[pair.id] = known
    return found


def _words(pair: Scale) -> tuple[str, str]:
    return str(pair.left).casefold(), str(pair.right).casefold()


def _titled(clusters: Sequence[Sequence[str]], titles: Sequence[str]) -> dict[str, str]:
    """Each kept pair's cluster by its title."""
    return {
        pair: title for members, title in zip(clusters, titles, strict=True) for pair in members
    }


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
    )
