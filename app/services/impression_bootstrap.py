"""The bootstrap of an analysis, in pieces that any process can compute.

The pieces and their seeds follow from the number of samples and the seed alone, so that the result
is the same on one processor, on several and on a cluster.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from app.statistics.intervals import Samples
from app.statistics.stability import BySize, Stability, stability

PIECE = 1000  # samples


class Order(NamedTuple):
    """What is asked: ratings (participants, clips, pairs), choices, number of samples, seed."""

    ratings: Samples
    least_peak: float
    most_spread: float
    clusters: int
    samples: int
    seed: int

    @property
    def pieces(self) -> int:
        """How many pieces there are."""
        return -(-self.samples // PIECE)

    @property
    def size(self) -> int:
        """How much work it is: samples × clips × pairs. How many people rated hardly matters."""
        _, clips, pairs = self.ratings.shape
        return self.samples * clips * pairs


class Combined(NamedTuple):
    """The pieces together; arrays as `Stability` has them."""

    kept_share: Samples
    cluster_stability: Samples
    rand: Samples
    by_participants: tuple[BySize, ...]


def whole(order: Order) -> Combined:
    """All pieces, one after the other."""
    return combined([piece(order, number) for number in range(order.pieces)])


def piece(order: Order, number: int) -> Stability:
    """One piece; the first one also tries other numbers of participants."""
    seeds = np.random.SeedSequence(order.seed).spawn(order.pieces)
    return stability(
        order.ratings,
        least_peak=order.least_peak,
        most_spread=order.most_spread,
        clusters=order.clusters,
        samples=min(PIECE, order.samples - number * PIECE),
        generator=np.random.default_rng(seeds[number]),
        sizes=() if number else None,
    )


def combined(pieces: Sequence[Stability]) -> Combined:
    """The pieces in their order as one."""
    weights = [len(one.rand) for one in pieces]
    return Combined(
        np.average([one.kept_share for one in pieces], axis=0, weights=weights),
        np.average([one.cluster_stability for one in pieces], axis=0, weights=weights),
        np.concatenate([one.rand for one in pieces]),
        pieces[0].by_participants,
    )
