"""How stable an analysis of adjective pairs is: the bootstrap over its participants."""

from __future__ import annotations

import threading
from collections.abc import Sequence

import numpy as np

from app.errors import BusyError, InvalidError
from app.jobs import executor
from app.persistence.engine import Database
from app.schemas.impressions import (
    ByParticipants,
    ClusterStability,
    PairStability,
    Stability,
)
from app.schemas.results import SessionKind
from app.services import impression_sentences as sentences
from app.services import impressions
from app.services.impression_bootstrap import Combined, Order, combined, piece, whole
from app.services.impression_names import Called, between
from app.services.impression_solution import Solution
from app.services.impressions import Analysed, Live
from app.services.sentences import number
from app.statistics.intervals import present
from app.workers import Workers

# Samples × clips × pairs: 7000 samples for 27 clips and 41 pairs take a process about 5 s.
AT_ONCE = 8_000_000
GOOD = 0.9  # the adjusted Rand index from which on a number of participants is said to do
SURE = 0.9  # the share of samples from which on a pair is said to stay


def stability(
    database: Database,
    workers: Workers,
    scheduler: str,
    slug: str,
    part: str,
    kind: SessionKind = "participant",
    live: Live | None = None,
    samples: int = 1000,
    seed: int = 1,
) -> Stability:
    """What stays of an analysis when its participants are drawn anew, with replacement.

    Moves by hand are not repeated: the samples are compared with the tree's own cut.

    Args:
        database: where to read.
        workers: one of them computes it; if it is more than `AT_ONCE`, the engine does.
        scheduler: of the engine, empty for this machine.
        slug: which study.
        part: which part.
        kind: whether people's answers are analysed or simulated ones.
        live: thresholds and cut in place of the saved ones.
        samples: how many.
        seed: the same number, the same samples.

    Raises:
        NotFoundError: no such study or part.
        InvalidError: there are no clusters yet.
        BusyError: too much is being computed.
    """
    with database.reading() as db:
        found = impressions.analysed(db, slug, part, kind, live)
    solution = found.solution
    if solution is None:
        raise InvalidError(
            sentences.problem(found.answers, found.choices),
            code="no_clusters",
            mend="Without clusters there is nothing to be stable.",
        )
    order = Order(
        found.answers.ratings, found.choices.least_peak, found.choices.most_spread,
        int(solution.by_tree.max()) + 1, samples, seed,
    )  # fmt: skip
    key = f"{slug}/{part}"
    return _told(found, solution, order, _computed(workers, scheduler, key, order))


_engine = threading.Lock()


def _computed(workers: Workers, scheduler: str, key: str, order: Order) -> Combined:
    if order.size <= AT_ONCE:
        return workers.run(key, whole, order)
    if not _engine.acquire(blocking=False):  # each starts processes of its own
        raise BusyError("Another large bootstrap is being computed at this moment.")
    try:
        with executor(scheduler) as engine:
            under_way = [engine.submit(piece, order, place) for place in range(order.pieces)]
            return combined([one.result() for one in under_way])
    finally:
        _engine.release()


def _told(found: Analysed, solution: Solution, order: Order, result: Combined) -> Stability:
    rand = present(result.rand)
    low, high = np.quantile(rand, [0.025, 0.975]) if rand.size else (None, None)
    by_participants = [
        ByParticipants(participants=one.participants, mean=one.rand, low=one.low, high=one.high)
        for one in result.by_participants
        if not np.isnan(one.rand)
    ]
    pairs = [
        PairStability(id=pair, kept=share)
        for pair, share in zip(found.answers.ids, result.kept_share.tolist(), strict=True)
    ]
    return Stability(
        samples=order.samples,
        seed=order.seed,
        pairs=pairs,
        clusters=_clusters(found, solution, result),
        rand_mean=float(rand.mean()) if rand.size else None,
        rand_low=low,
        rand_high=high,
        by_participants=by_participants,
        sentence=_sentence(solution, pairs, rand, len(result.rand), by_participants),
    )


def _clusters(found: Analysed, solution: Solution, result: Combined) -> list[ClusterStability]:
    """Each cluster as the tree has it, called as the one that its pairs are in now."""
    pairs = {pair.id: pair for pair in found.answers.pairs}
    titles = found.titles
    told = []
    for cluster, overlap in enumerate(result.cluster_stability.tolist()):
        first = solution.of_tree(cluster)[0]
        now = solution.cluster_of(first)
        left = first in solution.moved or now is None
        called = Called(between(pairs[first]), named=False) if left else titles[now or 0]
        told.append(ClusterStability(key=first, title=called.text, overlap=overlap))
    return told


def _sentence(
    solution: Solution,
    pairs: list[PairStability],
    rand: np.ndarray[tuple[int], np.dtype[np.float64]],
    samples: int,
    by_participants: list[ByParticipants],
) -> str:
    sure = sum(one.kept >= SURE for one in pairs if one.id in solution.kept)
    told = [
        f"With other participants of the same kind, {sure} of the {len(solution.kept)} kept pairs "
        f"would stay in at least {SURE:.0%} of {samples} samples.".replace("%", " %")
    ]
    if rand.size:
        low, high = np.quantile(rand, [0.025, 0.975])
        told.append(
            f"The clusters agree with those found here by an adjusted Rand index of "
            f"{number(rand.mean())} on average (95 % of samples: {number(low)} to {number(high)})."
        )
    if missing := samples - rand.size:
        told.append(f"In {missing} samples fewer pairs are kept than there are clusters.")
    if enough := _enough(by_participants):
        told.append(f"From about {enough} participants on, the index is at least {GOOD}.")
    elif by_participants:
        most = by_participants[-1].participants
        told.append(f"Even {most} participants would not bring it to {GOOD} on average.")
    if solution.moved:
        told.append("Moves by hand are not repeated in the samples.")
    return " ".join(told)


def _enough(by_participants: Sequence[ByParticipants]) -> int | None:
    """The least number of participants from which on every tried one does."""
    poor = [place for place, one in enumerate(by_participants) if one.mean < GOOD]
    rest = by_participants[poor[-1] + 1 if poor else 0 :]
    return rest[0].participants if rest else None
