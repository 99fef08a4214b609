"""What clusters of adjective pairs are called: by a researcher, by the paper, by a pair's words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from app.schemas.study import Language, Scale, Words
from app.services.impression_solution import Solution, shared_labels
from app.statistics.agreement import contingency, matching
from app.studies.adjectives import SCALES
from app.studies.published_clusters import CLUSTERS

QUESTIONNAIRE = frozenset(scale["id"] for scale in SCALES)
# The paper's titles; the Finnish and Japanese ones are ours.
TITLES = {
    "quickness": Words({"en": "quickness", "fi": "nopeus", "ja": "素早さ"}),
    "clearness": Words({"en": "clearness", "fi": "selkeys", "ja": "明瞭さ"}),
    "activeness": Words({"en": "activeness", "fi": "aktiivisuus", "ja": "積極性"}),
    "largeness": Words({"en": "largeness", "fi": "suuruus", "ja": "大きさ"}),
}
LONGEST = 200
Clusters = Sequence[Sequence[str]]


class Called(NamedTuple):
    """A cluster's title; `named`: whether a researcher gave it."""

    title: Words
    named: bool

    @property
    def text(self) -> str:
        """The title in one language, as long as a title may be."""
        return str(self.title)[:LONGEST]


def titles(
    clusters: Clusters, pairs: Mapping[str, Scale], names: Mapping[str, str]
) -> list[Called]:
    """What each cluster is called.

    Args:
        clusters: members of each, in their order.
        pairs: all pairs that the part asks for.
        names: given ones, by the pair that stands first in the cluster.
    """
    given = [names.get(members[0]) for members in clusters]
    defaults = _defaults(clusters, pairs)
    taken = {name.casefold() for name in given if name}
    found = []
    for members, name, default in zip(clusters, given, defaults, strict=True):
        if name:
            found.append(Called(Words(name), named=True))
        elif default and str(default).casefold() not in taken:
            found.append(Called(default, named=False))
        else:
            found.append(Called(between(pairs[members[0]]), named=False))
    return found


def in_force(clusters: Clusters, names: Mapping[str, str]) -> dict[str, str]:
    """The names by the pair that stands first in each cluster now.

    A name goes with the pair that it was given by, wherever in a cluster that stands; of several in
    one cluster the first counts.
    """
    found = {}
    for members in clusters:
        name = next((names[pair] for pair in members if pair in names), None)
        if name:
            found[members[0]] = name
    return found


def carried(before: Solution, names: Mapping[str, str], after: Solution) -> dict[str, str]:
    """The names of one solution for the clusters of another that they overlap most."""
    known = in_force(before.clusters, names)
    old, new = before.clusters, after.clusters
    _, one, other = shared_labels(old, new)
    together = contingency(one, other)
    pairs = [(row, column) for row, column in matching(one, other).pairs if together[row, column]]
    return {new[column][0]: known[old[row][0]] for row, column in pairs if old[row][0] in known}


def between(pair: Scale) -> Words:
    """A pair's words with a dash between them, in every language that it has."""
    left, right = pair.left, pair.right
    languages: dict[Language, None] = {}
    for words in (left.root, right.root):
        if isinstance(words, dict):
            languages |= dict.fromkeys(words)
    if not languages:
        return Words(f"{left} – {right}")
    return Words({one: f"{left.into(one)} – {right.into(one)}" for one in languages})


def _defaults(clusters: Clusters, pairs: Mapping[str, Scale]) -> list[Words | None]:
    """For the published questionnaire, the paper's titles by best overlap with its clusters.

    Of the paper's two motion sets the one whose clusters are more alike decides.
    """
    if not clusters or not QUESTIONNAIRE.issuperset(pairs):
        return [None] * len(clusters)
    _, found = max(
        (_overlapping(clusters, table) for table in CLUSTERS.values()),
        key=lambda scored: scored[0],
    )
    return found


def _overlapping(
    clusters: Clusters, table: Mapping[str, Sequence[str]]
) -> tuple[float, list[Words | None]]:
    """How well clusters and a table agree, and which title goes to which cluster."""
    from scipy.optimize import linear_sum_assignment  # slow to import, as in `ward`

    ours = [set(members) for members in clusters]
    jaccard = np.array(
        [[len(own & set(theirs)) / len(own | set(theirs)) for theirs in table.values()]
         for own in ours]
    )  # fmt: skip
    found: list[Words | None] = [None] * len(ours)
    keys = list(table)
    rows, columns = linear_sum_assignment(jaccard, maximize=True)
    for row, column in zip(rows, columns, strict=True):
        if jaccard[row, column]:
            found[row] = TITLES[keys[column]]
    return float(jaccard[rows, columns].sum()), found
