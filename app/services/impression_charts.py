"""The figures of an analysis of adjective pairs, for print."""

from __future__ import annotations

from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.figures import impressions as figures
from app.figures import render
from app.figures.theme import Mode
from app.schemas.results import SessionKind
from app.services import impression_sentences as sentences
from app.services import impressions
from app.services.charts import PRINT_WIDTH
from app.services.impression_answers import pair_words
from app.services.impression_solution import Solution
from app.services.impressions import Analysed, Live

HEAT_MAP, DENDROGRAM = "heat-map", "dendrogram"


def printed(
    db: Session,
    slug: str,
    name: str,
    mode: Mode,
    part: str | None = None,
    kind: SessionKind = "participant",
    live: Live | None = None,
) -> str:
    """One figure as SVG.

    Raises:
        NotFoundError: no such study, part or figure, or there are no clusters yet.
    """
    if name not in (HEAT_MAP, DENDROGRAM):
        raise NotFoundError(
            f"The analysis has no figure “{name[:80]}”.",
            code="figure_not_found",
            mend=f"Take {HEAT_MAP} or {DENDROGRAM}.",
        )
    found = impressions.analysed(db, slug, part, kind, live)
    if found.solution is None:
        raise NotFoundError(sentences.problem(found.answers, found.choices), code="no_clusters")
    draw = _heat_map if name == HEAT_MAP else _dendrogram
    return draw(found, found.solution, mode)


def _heat_map(found: Analysed, solution: Solution, mode: Mode) -> str:
    clips = [str(one.label or one.name) for one in found.answers.clips]
    values = impressions.listed(solution.matrix[:, solution.tree.order])
    return render.svg(figures.heat_map(_rows(found, solution), clips, values, mode, PRINT_WIDTH))


def _dendrogram(found: Analysed, solution: Solution, mode: Mode) -> str:
    heights = solution.tree.heights.tolist()
    apart = int(solution.by_tree.max())  # as many of the last merges are undone
    cut = (heights[-apart] + (heights[-apart - 1] if apart < len(heights) else 0)) / 2
    return render.svg(
        figures.dendrogram(
            _rows(found, solution), _joints(solution), cut if apart else None, mode, PRINT_WIDTH
        )
    )


def _rows(found: Analysed, solution: Solution) -> list[figures.Row]:
    pairs = {pair.id: pair for pair in found.answers.pairs}
    rows = []
    for pair in solution.leaves:
        cluster = solution.cluster_of(pair) or 0
        words = pair_words(pairs[pair])
        label = f"{words}, moved" if pair in solution.moved else words
        rows.append(figures.Row(label, cluster, found.titles[cluster].text))
    return rows


def _joints(solution: Solution) -> list[figures.Joint]:
    """The merges as lines between rows; those within one cluster of the tree's cut know it."""
    items = len(solution.kept)
    places = dict(zip(solution.tree.order.tolist(), map(float, range(items)), strict=True))
    heights = dict.fromkeys(range(items), 0.0)
    by_tree: dict[int, int | None] = dict(enumerate(solution.by_tree.tolist()))
    now = [
        solution.cluster_of(solution.of_tree(cluster)[0])
        for cluster in range(int(solution.by_tree.max()) + 1)
    ]
    found = []
    for number, (left, right, height, _) in enumerate(solution.tree.merges.tolist()):
        one, other, made = int(left), int(right), items + number
        within = by_tree[one] if by_tree[one] == by_tree[other] else None
        by_tree[made] = within
        found.append(
            figures.Joint(
                (places[one], places[other]),
                (heights[one], heights[other]),
                height,
                None if within is None else now[within],
            )
        )
        places[made] = (places[one] + places[other]) / 2
        heights[made] = height
    return found
