"""The bootstrap of an analysis, in pieces that any process can compute.

The pieces and their seeds follow from the number of samples and the seed alone, so that the result
is the same on one processor, on several and on a cluster.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from app.statistics.intervals import Samples
from app.statistics.stability import Bootstrap, BySize, Drawn, sizes

PIECE = 100  # samples
MOST_BY_SIZE = 200  # samples for each number of participants


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
        """How many pieces there are: some samples each, then each number of participants."""
        return self.pieces_drawn + len(sizes(len(self.ratings)))

    @property
    def pieces_drawn(self) -> int:
        """How many of them are of as many participants as there are."""
        return -(-self.samples // PIECE)

    @property
    def size(self) -> int:
        """How much work it is: samples × clips × pairs. How many people rated hardly matters."""
        _, clips, pairs = self.ratings.shape
        return self.samples * clips * pairs


class Combined(NamedTuple):
    """The pieces together; arrays as `Drawn` has them."""

    kept_share: Samples
    cluster_stability: Samples
    whole: Samples
    shared: Samples
    by_participants: tuple[BySize, ...]


def whole(order: Order) -> Combined:
    """All pieces, one after the other."""
    return combined([piece(order, number) for number in range(order.pieces)])


def piece(order: Order, number: int) -> Drawn | BySize:
    """One piece."""
    seed = np.random.SeedSequence(order.seed).spawn(order.pieces)[number]
    generator = np.random.default_rng(seed)
    bootstrap = Bootstrap.of(
        order.ratings,
        least_peak=order.least_peak,
        most_spread=order.most_spread,
        clusters=order.clusters,
    )
    if number < order.pieces_drawn:
        return bootstrap.drawn(min(PIECE, order.samples - number * PIECE), generator)
    participants = sizes(len(order.ratings))[number - order.pieces_drawn]
    samples = max(min(order.samples // 5, MOST_BY_SIZE), 1)
    return bootstrap.by_size(participants, samples, generator)


def combined(pieces: Sequence[Drawn | BySize]) -> Combined:
    """The pieces in their order as one."""
    drawn = [one for one in pieces if isinstance(one, Drawn)]
    weights = [len(one.whole) for one in drawn]
    return Combined(
        np.average([one.kept_share for one in drawn], axis=0, weights=weights),
        np.average([one.cluster_stability for one in drawn], axis=0, weights=weights),
        np.concatenate([one.whole for one in drawn]),
        np.concatenate([one.shared for one in drawn]),
        tuple(one for one in pieces if isinstance(one, BySize)),
    )
