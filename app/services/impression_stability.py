"""How stable an analysis of adjective pairs is: the bootstrap over its participants."""

from __future__ import annotations

from typing import NamedTuple
from uuid import UUID

import numpy as np
from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence import jobs
from app.persistence.engine import Database
from app.persistence.models import Job
from app.schemas.impressions import (
    Agreement,
    ByParticipants,
    ClusterStability,
    PairStability,
    Stability,
)
from app.schemas.jobs import JobDetail
from app.schemas.results import SessionKind
from app.services import batches, impressions
from app.services import impression_sentences as sentences
from app.services.impression_bootstrap import Combined, Order, whole
from app.services.impression_enough import enough, sentence
from app.services.impression_names import Called, between
from app.services.impression_solution import Solution
from app.services.impressions import Analysed, Live
from app.services.rights import Access
from app.statistics import stability as statistics
from app.workers import Workers

# Samples × clips × pairs: 1000 samples for 27 clips and 41 pairs take a process about 3 s.
AT_ONCE = 1_500_000
KIND = "stability"  # of the job


class Asked(NamedTuple):
    """A bootstrap that somebody asked for; as JSON, what its job is asked."""

    study_id: int
    slug: str
    part: str
    kind: SessionKind
    live: Live
    samples: int
    seed: int

    @staticmethod
    def of(job: Job) -> Asked:
        """What a job is asked."""
        return Asked(**{**job.request, "live": Live(**job.request["live"])})

    @property
    def request(self) -> dict[str, object]:
        """The same as a job keeps it: no answers, for these may be deleted."""
        return {**self._asdict(), "live": self.live._asdict()}


def stability(
    database: Database,
    workers: Workers,
    access: Access,
    part: str,
    kind: SessionKind = "participant",
    live: Live | None = None,
    samples: int = 1000,
    seed: int = 1,
) -> Stability | JobDetail:
    """What stays of an analysis when its participants are drawn anew, with replacement.

    Moves by hand are not repeated: the samples are compared with the tree's own cut.

    Args:
        database: where to read.
        workers: one of them computes it; if it is more than `AT_ONCE`, it becomes a job.
        access: whoever asks, and the study.
        part: which part.
        kind: whether people's answers are analysed or simulated ones.
        live: thresholds and cut in place of the saved ones.
        samples: how many.
        seed: the same number, the same samples.

    Raises:
        NotFoundError: no such part.
        InvalidError: there are no clusters yet.
        BusyError: too much is being computed.
    """
    asked = Asked(access.study_id, access.slug, part, kind, live or Live(), samples, seed)
    with database.reading() as db:
        found, order = prepared(db, asked)
    if order.size <= AT_ONCE:
        return told(found, order, workers.run(f"{access.slug}/{part}", whole, order))
    with database.writing() as db:
        choices = found.choices  # those that are saved now may be others when its turn comes
        fixed = Live(choices.least_peak, choices.most_spread, choices.clusters)
        job = Job(
            kind=KIND,
            researcher_id=access.researcher_id,
            request=asked._replace(live=fixed).request,
            total=order.pieces,
        )
        jobs.add(db, job)
        db.commit()
        return batches.detail(job)


def result(db: Session, access: Access, part: str, job_id: UUID) -> Stability:
    """What a job has found.

    Raises:
        NotFoundError: there is no such job about this part.
        ConflictError: it is not done.
    """
    job = jobs.by_id(db, job_id)
    about = Asked.of(job) if job and job.kind == KIND else None
    if job is None or about is None or (about.study_id, about.part) != (access.study_id, part):
        raise NotFoundError("There is no such job about this part.", code="job_not_found")
    if job.state != "done":
        raise ConflictError(
            f"The bootstrap has no result: it is {job.state}.",
            code="job_not_done",
            mend="Wait until it is done, or draw participants anew.",
        )
    return Stability.model_validate(job.items[0])


def prepared(db: Session, asked: Asked) -> tuple[Analysed, Order]:
    """The analysis that is asked about, and what is to be computed.

    Raises:
        NotFoundError: no such study or part.
        InvalidError: there are no clusters.
    """
    found = impressions.analysed(db, asked.slug, asked.part, asked.kind, asked.live)
    solution, choices = found.solution, found.choices
    if solution is None:
        raise InvalidError(
            sentences.problem(found.answers, choices),
            code="no_clusters",
            mend="Without clusters there is nothing to be stable.",
        )
    return found, Order(
        found.answers.ratings, choices.least_peak, choices.most_spread,
        int(solution.by_tree.max()) + 1, asked.samples, asked.seed,
    )  # fmt: skip


def told(found: Analysed, order: Order, computed: Combined) -> Stability:
    """The numbers in the words of the page."""
    solution = found.solution
    assert solution is not None  # noqa: S101 -- `prepared` refuses what has none
    pairs = [
        PairStability(id=pair, kept=share)
        for pair, share in zip(found.answers.ids, computed.kept_share.tolist(), strict=True)
    ]
    by_participants = [
        ByParticipants(
            participants=one.participants,
            whole=Agreement(**one.whole._asdict()),
            shared=_agreement(one.shared),
            kept_alike=one.kept_alike,
        )
        for one in computed.by_participants
    ]
    of_all = Agreement(**statistics.Agreement.of(computed.whole)._asdict())
    shared = _agreement(statistics.Agreement.of(computed.shared))
    return Stability(
        samples=order.samples,
        seed=order.seed,
        participants=len(order.ratings),
        pairs=pairs,
        clusters=_clusters(found, solution, computed),
        whole=of_all,
        shared=shared,
        by_participants=by_participants,
        enough=enough(by_participants),
        sentence=sentence(solution, pairs, of_all, shared, order.samples),
    )


def _agreement(found: statistics.Agreement) -> Agreement | None:
    return None if np.isnan(found.mean) else Agreement(**found._asdict())


def _clusters(found: Analysed, solution: Solution, computed: Combined) -> list[ClusterStability]:
    """Each cluster as the tree has it, called as the one that its pairs are in now."""
    pairs = {pair.id: pair for pair in found.answers.pairs}
    titles = found.titles
    listed = []
    for cluster, overlap in enumerate(computed.cluster_stability.tolist()):
        first = solution.of_tree(cluster)[0]
        now = solution.cluster_of(first)
        left = first in solution.moved or now is None
        called = Called(between(pairs[first]), named=False) if left else titles[now or 0]
        listed.append(ClusterStability(key=first, title=called.text, overlap=overlap))
    return listed
