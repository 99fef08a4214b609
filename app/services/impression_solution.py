"""From means and spreads to clusters of pairs: what is kept, the tree, the cut, moves by hand."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.schemas.impressions import AnalysisChoices
from app.statistics.intervals import Samples
from app.statistics.quantification import Quantified, impressions, kept
from app.statistics.ward import Labels, Tree, cluster_means, cut, ward

LEAST = 2  # pairs to be told apart, and clips to tell them apart by


@dataclass(frozen=True)
class Solution:
    """The clusters of a part's pairs.

    Attributes:
        kept: the kept pairs' ids, in the part's order.
        matrix: A (clips, kept); NaN where nobody rated.
        complete: the clips (clips,) with an answer on every kept pair; the tree rests on them.
        tree: of the kept pairs, by their places in `kept`.
        by_tree: the cluster of each kept pair (kept,) as the tree is cut.
        labels: the same after the moves by hand, without gaps.
        members: each cluster's places in `kept`: leaves in their order, then those moved into it.
        moved: the moves that hold, pair to pair; left_out: those that cannot.
    """

    kept: tuple[str, ...]
    matrix: Samples
    complete: NDArray[np.bool_]
    tree: Tree
    by_tree: Labels
    labels: Labels
    members: tuple[tuple[int, ...], ...]
    moved: dict[str, str]
    left_out: dict[str, str]

    @property
    def clusters(self) -> list[list[str]]:
        """The members' ids of each cluster."""
        return [[self.kept[place] for place in places] for places in self.members]

    @property
    def leaves(self) -> list[str]:
        """The kept pairs as they stand under the dendrogram."""
        return [self.kept[int(place)] for place in self.tree.order]

    @property
    def values(self) -> Samples:
        """A′ (clips, clusters); NaN for a clip that lacks an answer."""
        return cluster_means(self.matrix, self.labels)

    def cluster_of(self, pair: str) -> int | None:
        """Which cluster a pair is in; None for a dropped one."""
        return int(self.labels[self.kept.index(pair)]) if pair in self.kept else None

    def of_tree(self, cluster: int) -> list[str]:
        """The pairs that the tree has in a cluster, in its order, those that were moved last."""
        found = [pair for pair, by in zip(self.kept, self.by_tree, strict=True) if by == cluster]
        return sorted(found, key=lambda pair: (pair in self.moved, self.leaves.index(pair)))


def solve(
    quantified: Quantified, ids: Sequence[str], choices: AnalysisChoices, reach: int
) -> Solution | None:
    """The solution by these choices; None if fewer than two pairs or two clips can be used.

    Of fewer kept pairs than wanted clusters, each is one. A move puts a pair into the cluster in
    which the tree has the other one; whatever was moved before or after, exactly this pair moves.
    """
    chosen = np.flatnonzero(kept(quantified, choices.least_peak, choices.most_spread))
    matrix = impressions(quantified, chosen, reach)
    complete = np.asarray(~np.isnan(matrix).any(axis=1))
    if len(chosen) < LEAST or complete.sum() < LEAST:
        return None
    tree = ward(matrix[complete].T)
    by_tree = cut(tree, min(choices.clusters, len(chosen)))
    names = tuple(ids[int(place)] for place in chosen)
    moved, left_out = _moves(names, by_tree, choices.moved)
    members = _members(names, tree, by_tree, moved)
    labels = np.empty_like(by_tree)
    for number, places in enumerate(members):
        labels[list(places)] = number
    return Solution(names, matrix, complete, tree, by_tree, labels, members, moved, left_out)


def _moves(
    names: Sequence[str], by_tree: Labels, asked: Mapping[str, str]
) -> tuple[dict[str, str], dict[str, str]]:
    """The moves that change something, and those that a dropped pair keeps from being made."""
    cluster = dict(zip(names, by_tree, strict=True))
    possible = {pair: to for pair, to in asked.items() if pair in cluster and to in cluster}
    moved = {pair: to for pair, to in possible.items() if cluster[pair] != cluster[to]}
    return moved, {pair: to for pair, to in asked.items() if pair not in possible}


def _members(
    names: Sequence[str], tree: Tree, by_tree: Labels, moved: Mapping[str, str]
) -> tuple[tuple[int, ...], ...]:
    """The places in each cluster; a cluster that all have left is none."""
    at = {name: place for place, name in enumerate(names)}
    stayed: list[list[int]] = [[] for _ in range(int(by_tree.max()) + 1)]
    came: list[list[int]] = [[] for _ in stayed]
    for place in map(int, tree.order):
        to = moved.get(names[place])
        if to is None:
            stayed[by_tree[place]].append(place)
        else:
            came[by_tree[at[to]]].append(place)
    both = (tuple(own + others) for own, others in zip(stayed, came, strict=True))
    return tuple(places for places in both if places)


def shared_labels(
    one: Iterable[Sequence[str]], other: Iterable[Sequence[str]]
) -> tuple[list[str], Labels, Labels]:
    """The pairs that two solutions both keep, and the clusters of each in the one and the other.

    Args:
        one: members of each cluster.
        other: likewise.
    """
    here, there = (
        {pair: number for number, members in enumerate(clusters) for pair in members}
        for clusters in (one, other)
    )
    both = [pair for pair in here if pair in there]
    labels = ([known[pair] for pair in both] for known in (here, there))
    first, second = (np.array(list(each), dtype=np.intp) for each in labels)
    return both, first, second
