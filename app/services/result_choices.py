"""What was chosen of several figures, and how often the choice was right."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from app.persistence.responses import Counted
from app.schemas.results import Choices, Clip, Share
from app.schemas.study import AB, Choose
from app.services import sentences
from app.services.result_axes import NEEDED, too_few
from app.services.versions import Pooled
from app.statistics.intervals import wilson


def choices(asked: Pooled, clips: Sequence[Clip], rows: Sequence[Counted]) -> list[Choices]:
    """Of each clip the share of the trials that showed it; of A/B/X, how often X was known."""
    enough = len({row.session_id for row in rows}) >= NEEDED
    if asked.task.kind == "abx":
        return [_correct(clips, rows, enough)]
    return [_chosen(asked, clips, rows, enough)]


def _chosen(asked: Pooled, clips: Sequence[Clip], rows: Sequence[Counted], enough: bool) -> Choices:
    shown: Counter[str] = Counter()
    taken: Counter[str] = Counter()
    for row in rows:
        shown.update(row.clips)
        choice = row.answers["choice"]
        taken[row.clips[choice] if choice >= 0 else ""] += 1
    found = [_share(clip.label, clip.id, taken[clip.id], shown[clip.id], enough) for clip in clips]
    if (word := no_figure(asked)) is not None:
        found.append(_share(word, None, taken[""], len(rows), enough))
    sizes = {len(row.clips) for row in rows}
    return Choices(
        id="choice",
        title="How often each clip was chosen",
        chance=1 / min(sizes) if len(sizes) == 1 and no_figure(asked) is None else None,
        rows=found,
        sentence=_sentence(found, rows),
    )


def _correct(clips: Sequence[Clip], rows: Sequence[Counted], enough: bool) -> Choices:
    labels = {clip.id: clip.label for clip in clips}
    shown: Counter[tuple[str, ...]] = Counter()
    right: Counter[tuple[str, ...]] = Counter()
    for row in rows:
        pair = tuple(sorted(row.clips[:2], key=list(labels).index))
        shown[pair] += 1
        right[pair] += row.clips[row.answers["choice"]] == row.clips[2]
    found = [
        _share(" and ".join(labels[one] for one in pair), None, right[pair], number, enough)
        for pair, number in sorted(shown.items(), key=lambda item: _places(item[0], labels))
    ]
    if len(found) != 1:
        found.insert(0, _share("all pairs", None, right.total(), shown.total(), enough))
    return Choices(
        id="correct",
        title="How often X was recognised",
        chance=0.5,
        rows=found,
        sentence=_sentence(found[:1], rows, recognised=True),
    )


def _places(pair: Iterable[str], labels: dict[str, str]) -> list[int]:
    order = list(labels)
    return [order.index(one) for one in pair]


def no_figure(asked: Pooled) -> str | None:
    """What choosing none of the figures is called, where that is allowed."""
    if isinstance(asked.task, Choose) and asked.task.allow_none:
        return "none of them"
    if isinstance(asked.task, AB) and asked.task.allow_same:
        return "no difference"
    return None


def _share(name: str, clip: str | None, chosen: int, shown: int, enough: bool) -> Share:
    found = wilson(chosen, shown) if enough else None
    return Share(
        name=name, clip=clip, chosen=chosen, shown=shown,
        share=found.share if found else None,
        low=found.low if found else None,
        high=found.high if found else None,
    )  # fmt: skip


def _sentence(
    rows: Sequence[Share], answers: Sequence[Counted], *, recognised: bool = False
) -> str:
    best = max(rows, key=lambda row: row.share or 0, default=None)
    if best is None or best.share is None or best.low is None or best.high is None:
        return too_few(len({row.session_id for row in answers}))
    if recognised:
        return sentences.recognised(best.chosen, best.shown, best.low, best.high)
    return sentences.most_chosen(best.name, best.chosen, best.shown, best.low, best.high)
