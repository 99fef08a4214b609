"""Which pairs of two questionnaires are the same, also where one has its poles the other way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from app.schemas.study import Scale


class Same(NamedTuple):
    """The id that a pair has here, and whether its poles are the other way round there."""

    id: str
    turned: bool


def same_pairs(here: Sequence[Scale], there: Sequence[Scale]) -> dict[str, Same]:
    """For each pair of the other questionnaire that is asked here, which one it is.

    Pairs are the same if their ids are, or else their words in any language, in either order. Each
    pair here is at most one there.
    """
    by_id = {pair.id: pair for pair in here}
    by_words = {words: pair for pair in here for words in _words(pair)}
    found: dict[str, Same] = {}
    taken: set[str] = set()
    for pair in sorted(there, key=lambda pair: pair.id not in by_id):  # ids before words
        known = by_id.get(pair.id) or _by_words(by_words, pair)
        if known is not None and known.id not in taken:
            taken.add(known.id)
            found[pair.id] = Same(known.id, _is_turned(known, pair))
    return found


def other_way(pair: Scale) -> Scale:
    """The pair with its poles exchanged."""
    return pair.model_copy(
        update={
            "left": pair.right,
            "right": pair.left,
            "left_more": pair.right_more,
            "right_more": pair.left_more,
        }
    )


def _by_words(known: dict[tuple[str, str], Scale], pair: Scale) -> Scale | None:
    words = _words(pair)
    both = [*words, *((right, left) for left, right in words)]
    return next((known[one] for one in both if one in known), None)


def _is_turned(one: Scale, other: Scale) -> bool:
    here, there = set(_words(one)), _words(other)
    return not here.intersection(there) and any((right, left) in here for left, right in there)


def _words(pair: Scale) -> list[tuple[str, str]]:
    """Left and right in every language that the pair has."""
    languages = {
        language
        for words in (pair.left.root, pair.right.root)
        if isinstance(words, dict)
        for language in words
    }
    spoken = [(pair.left, pair.right)] if not languages else [
        (pair.left.into(one), pair.right.into(one)) for one in sorted(languages)
    ]  # fmt: skip
    return [(str(left).casefold(), str(right).casefold()) for left, right in spoken]
