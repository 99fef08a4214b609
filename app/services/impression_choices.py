"""What a researcher decides in an analysis of adjective pairs: checked, kept, written down."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import impressions as store
from app.schemas.impressions import AnalysisChoices, Impressions
from app.schemas.results import SessionKind
from app.services import audit, impressions
from app.services.impression_answers import Answers, pair_words
from app.services.impressions import Analysed
from app.services.rights import Access
from app.services.studies import find


def save(
    db: Session,
    access: Access,
    part: str,
    choices: AnalysisChoices,
    kind: SessionKind = "participant",
    seen: datetime | None = None,
) -> Impressions:
    """Keep the choices for a part; each that differs from before is in the audit trail.

    Thresholds that are not given are the defaults for the part's reach. People's answers and
    simulated ones are analysed by the same choices.

    Args:
        db: where to write; commits.
        access: whoever decides.
        part: which part.
        choices: all of them; earlier ones are replaced.
        kind: whose answers the researcher is looking at.
        seen: when those were saved that these were made from; None: whatever is there is replaced.

    Raises:
        ConflictError: somebody else saved others since then.
        NotFoundError: no such part, or it asks for no pairs of adjectives.
        InvalidError: a pair that the part does not ask for, or two clusters of one name.
    """
    find(db, access.slug, lock=True)  # two who decide at once come one after the other
    before = impressions.analysed(db, access.slug, part, kind)
    if seen is not None and before.saved_at is not None and seen != before.saved_at:
        raise ConflictError(
            "This analysis was changed elsewhere in the meantime.",
            code="analysis_changed",
            where={"saved_at": before.saved_at.isoformat()},
            mend="Load the page again to see it. What you changed last is not saved.",
        )
    asked = before.answers
    given = choices.model_dump(exclude_unset=True)
    wanted = impressions.defaults(asked.reach).model_copy(update=given)
    _check(asked, wanted)
    wanted = wanted.model_copy(update={"moved": _settled(before, wanted.moved)})
    if wanted != before.saved or before.saved_at is None:
        store.save(db, asked.study_id, asked.part.id, wanted.model_dump())
    after = impressions.analysed(db, access.slug, part, kind)
    _write_down(db, access, before, after)
    db.commit()
    return impressions.shown(db, after, access.role)


def _check(asked: Answers, wanted: AnalysisChoices) -> None:
    known = set(asked.ids)
    mentioned = {"names": list(wanted.names), "moved": [*wanted.moved, *wanted.moved.values()]}
    for field, pairs in mentioned.items():
        for pair in pairs:
            if pair not in known:
                raise InvalidError(
                    f"The part “{asked.part.id}” asks for no pair “{pair}”.",
                    code="pair_not_found",
                    where={"field": field, "pair": pair},
                    mend="Name pairs by the ids of the part's scales.",
                )
    taken: set[str] = set()
    for pair, name in wanted.names.items():
        if name.casefold() in taken:
            raise InvalidError(
                f"Two clusters would be called “{name}”.",
                code="name_taken",
                where={"field": "names", "pair": pair},
                mend="Give each a name of its own.",
            )
        taken.add(name.casefold())


def _settled(before: Analysed, moved: Mapping[str, str]) -> dict[str, str]:
    """The moves as they are kept: to a pair that the tree itself has in the cluster that is meant.

    Whoever moves a pair to one that was moved already means the cluster where that is seen. A move
    to where the tree has the pair anyway is none.
    """
    seen = before.choices.moved
    found = {}
    for pair, to in moved.items():
        fresh = before.saved.moved.get(pair) != to
        found[pair] = seen[to] if fresh and to in seen and moved.get(to) == seen[to] else to
    solution = before.solution
    home = dict(zip(solution.kept, solution.by_tree.tolist(), strict=True)) if solution else {}
    return {
        pair: to
        for pair, to in found.items()
        if pair != to and (pair not in home or to not in home or home[pair] != home[to])
    }


def _write_down(db: Session, access: Access, before: Analysed, after: Analysed) -> None:
    """An entry in the audit trail for each thing that is decided anew."""
    words = {pair.id: pair_words(pair)[:120] for pair in after.answers.pairs}
    part = after.answers.part.id
    was, now = before.saved, after.saved

    def note(act: str, **detail: str) -> None:
        who = access.researcher_id
        audit.note(db, access.study_id, act, who, None, unless_within=None, part=part, **detail)

    if _numbers(was) != _numbers(now):
        least_peak, most_spread, clusters = (f"{one:g}" for one in _numbers(now))
        note("impressions_cut", least_peak=least_peak, most_spread=most_spread, clusters=clusters)
    for pair in dict.fromkeys([*was.names, *now.names]):
        old, new = was.names.get(pair), now.names.get(pair)
        if new and new != old:
            note("cluster_named", pair=words[pair], name=new)
        elif old and not new:
            note("cluster_unnamed", pair=words.get(pair, pair), name=old)
    for pair in dict.fromkeys([*was.moved, *now.moved]):
        to = now.moved.get(pair)
        if to and to != was.moved.get(pair):
            note("pair_moved", pair=words[pair], to=words[to])
        elif not to:
            note("pair_moved_back", pair=words.get(pair, pair))


def _numbers(choices: AnalysisChoices) -> tuple[float, float, int]:
    return choices.least_peak, choices.most_spread, choices.clusters
