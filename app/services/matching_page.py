"""What the page of a match is told: sliders with their words, and the examples of the space."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sqlalchemy.orm import Session

from app.persistence import studies
from app.persistence.studies import Media
from app.schemas.spaces import START, Primary, Sliders, SpaceDefinition
from app.schemas.study import Interface, Language, Match
from app.services.matching import sliders_of, space_of
from app.services.studies import media_url

SHOWN_WORDS = 3  # of a cluster's pairs, at the ends of its slider


def page(db: Session, task: Match, language: Language) -> dict[str, Any]:
    """What the page of a match is told besides the task: sliders, and the examples' motions.

    The examples have numbers instead of names, which would give away how they were meant.
    """
    definition = space_of(db, task).definition
    examples = [one.clip for one in definition.examples]
    shown = studies.media(db, examples) if task.examples else {}
    return {
        "start": START,
        "sliders": {one: _sliders(definition, one, language) for one in task.interfaces},
        "example_figures": [
            _figure(shown[clip], str(number)) for number, clip in enumerate(examples, 1) if shown
        ],
    }


def _figure(media: Media, caption: str) -> dict[str, Any]:
    return {
        "glb_url": media_url(media.glb),
        "figure_url": media.figure and media_url(media.figure),
        "cyclic": media.cyclic,
        "caption": caption,
    }


def _sliders(
    definition: SpaceDefinition, interface: Interface, language: Language
) -> list[dict[str, str]]:
    sliders = definition.sliders(interface)
    if sliders is None:
        bare = enumerate(sliders_of(definition, interface), start=1)
        return [{"id": name, "title": str(n), "left": "", "right": ""} for n, name in bare]
    return [_slider(sliders, one, language) for one in sliders.primary]


def _slider(sliders: Sliders, one: Primary, language: Language) -> dict[str, str]:
    parameters = {parameter.id: parameter for parameter in sliders.parameters}
    members = [parameters[name] for name in one.members[:SHOWN_WORDS]]
    return {
        "id": one.id,
        "title": str(one.title.into(language)),
        "left": _listed(p.left.into(language) for p in members),
        "right": _listed(p.right.into(language) for p in members),
    }


def _listed(words: Iterable[object]) -> str:
    """Each once: the ends of all features are “less” and “more”."""
    return ", ".join(dict.fromkeys(map(str, words)))
