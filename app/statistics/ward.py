"""Ward's hierarchical clustering; SciPy's hierarchy underneath.

Sources: J. H. Ward, Hierarchical grouping to optimize an objective function, JASA 58 (1963); the
notation is that of Oshita et al., equations 4 to 6, with squared Euclidean distance.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.statistics.intervals import Samples

Labels = NDArray[np.intp]


@dataclass(frozen=True)
class Tree:
    """Which groups merged, from the nearest to the last.

    Attributes:
        merges: (n − 1, 4) as SciPy's: two groups (items are 0 … n − 1, the group made by row i is
            n + i), the height √(2 ΔE) and the size. R's `hclust(..., "ward.D2")` has these heights.
        order: the items (n,) as they stand under the dendrogram without crossing lines.
    """

    merges: Samples
    order: Labels

    @property
    def heights(self) -> Samples:
        """The height of each merge (n − 1,), never falling."""
        return self.merges[:, 2]


def ward(columns: Samples) -> Tree:
    """Merge items until one group is left, each time the two that raise E least.

    Args:
        columns: (n, d), the items' vectors; of an impression matrix its columns, `matrix.T`.

    Raises:
        ValueError: no items, or numbers that are missing or not finite.
    """
    from scipy.cluster import hierarchy  # slow to import, and the server need not wait for it

    if not len(columns) or not np.isfinite(columns).all():
        raise ValueError("Ward's method needs items whose numbers are all known")
    if len(columns) == 1:
        return Tree(np.empty((0, 4)), np.zeros(1, dtype=np.intp))
    merges = hierarchy.linkage(columns, "ward")
    return Tree(merges, hierarchy.leaves_list(merges).astype(np.intp))


def cut(tree: Tree, clusters: int) -> Labels:
    """Which cluster each item is in (n,), numbered from 0 as they stand in the dendrogram.

    The last `clusters` − 1 merges are undone; so there are exactly so many clusters even where
    heights are equal.

    Raises:
        ValueError: fewer than one cluster, or more than items.
    """
    items = len(tree.order)
    if not 1 <= clusters <= items:
        raise ValueError(f"{items} items cannot be cut into {clusters} clusters")
    root = np.arange(2 * items - 1)
    for made in range(items - clusters - 1, -1, -1):
        root[tree.merges[made, :2].astype(np.intp)] = root[items + made]
    _, first, which = np.unique(root[tree.order], return_index=True, return_inverse=True)
    labels = np.empty(items, dtype=np.intp)
    labels[tree.order] = np.argsort(np.argsort(first))[which]
    return labels


def clusters_at(tree: Tree, height: float) -> int:
    """How many clusters a cut at this height makes; a merge exactly there is not cut."""
    return 1 + int(np.sum(tree.heights > height))


def cluster_means(matrix: Samples, labels: Labels) -> Samples:
    """The matrix A′ (clips, clusters): of each clip the mean over each cluster's pairs.

    Args:
        matrix: A (clips, pairs).
        labels: the pairs' clusters (pairs,), 0 and up without gaps.
    """
    member = labels[:, None] == np.arange(labels.max() + 1)
    return matrix @ (member / member.sum(axis=0))


def merge_increase(one: Samples, other: Samples) -> float:
    """ΔE of merging two groups (n, d) and (m, d), by equations 4 to 6 as they are written."""
    return _error(np.concatenate([one, other])) - _error(one) - _error(other)


def _error(group: Samples) -> float:
    """E(G): squared distances from the group's centre."""
    return float(np.sum((group - group.mean(axis=0)) ** 2))
