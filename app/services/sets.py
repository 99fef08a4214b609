"""Sets of clips: which source by which preset, under which names and tags."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from sqlalchemy.orm import Session

from app.errors import InvalidError, NotFoundError
from app.persistence import clips
from app.persistence.models import ClipRecord
from app.schemas.edits import ClipRequest, Edit
from app.schemas.jobs import MOST, Batch, Choice, Plan, PlannedClip
from app.services import edits
from app.studies.emotion import MODIFIED

if TYPE_CHECKING:  # it brings SciPy, for which the server's start shall not wait
    from motion.recipe import Preset

FOERGER_SET = "foerger-modified"
KEPT_TAGS = ("body", "synthetic")

Pair = tuple[ClipRecord, str]


def plan(db: Session, choice: Choice) -> Plan:
    """What a choice comes to: every source by every preset, each once.

    Raises:
        InvalidError: there is no such preset, or these are too many.
        NotFoundError: there is no such clip.
    """
    sources = [edits.source_clip(db, clip_id) for clip_id in dict.fromkeys(choice.sources)]
    presets = list(dict.fromkeys(choice.presets))
    if len(sources) * len(presets) > MOST:
        raise InvalidError(
            f"These are {len(sources) * len(presets):,} clips; a set takes {MOST:,} at most.",
            code="too_many_clips",
            mend="Choose fewer clips or presets.",
        )
    return _planned(db, [(s, p) for s in sources for p in presets], choice.tags)


def foerger(db: Session) -> Plan:
    """The twenty clips that Förger made from two (his figure 29), here from the samples."""
    pairs = [(_neutral(db, body), preset) for body, names in MODIFIED.items() for preset in names]
    return _planned(db, pairs, {"set": FOERGER_SET})


def requests(db: Session, batch: Batch) -> list[ClipRequest]:
    """The clips of a batch that was given as sources and presets."""
    choice = Choice(sources=batch.sources or [], presets=batch.presets or [], tags=batch.tags)
    return as_requests(plan(db, choice))


def as_requests(planned: Plan) -> list[ClipRequest]:
    """The plan as what a batch is made of."""
    return [
        ClipRequest(source=item.source, preset=item.preset, name=item.name, tags=item.tags)
        for item in planned.items
    ]


def _planned(db: Session, pairs: Sequence[Pair], tags: dict[str, str]) -> Plan:
    found = {preset: _preset(preset) for _, preset in pairs}
    ids = [edits.edited_id(source.id, found[preset].operations) for source, preset in pairs]
    there = clips.present(db, ids)
    return Plan(
        items=[
            _item(source, found[preset], tags, clip_id if clip_id in there else None)
            for (source, preset), clip_id in zip(pairs, ids, strict=True)
        ]
    )


def _item(
    source: ClipRecord, preset: Preset, tags: dict[str, str], clip_id: str | None
) -> PlannedClip:
    name, own_tags = name_and_tags(source, preset.name)
    return PlannedClip(
        source=source.id,
        source_name=source.name,
        preset=preset.name,
        preset_title=preset.title,
        name=name,
        tags={**own_tags, **tags},
        clip=clip_id,
    )


def name_and_tags(source: ClipRecord, preset_name: str) -> tuple[str, dict[str, str]]:
    """What a clip that a preset makes is called, and its tags."""
    preset = _preset(preset_name)
    tags = {
        "set": "modified",
        **kept_tags(source),
        "emotion": preset.emotion,  # the intended one
        "preset": preset.name,
        "made": "modified",
        "from": source.name,
    }
    return f"{source.name[:150]} · {preset.title.lower()}", tags


def kept_tags(source: ClipRecord) -> dict[str, str]:
    """What is as true of an edited clip as of its source."""
    return {name: source.tags[name] for name in KEPT_TAGS if name in source.tags}


def _preset(name: str) -> Preset:
    from motion.recipe import PRESETS

    edits.read_recipe(Edit(source="", preset=name))  # tells a wrong name, and what was meant
    return PRESETS[name]


def _neutral(db: Session, body: str) -> ClipRecord:
    wanted = {"set": "acted", "body": body, "emotion": "neutral"}
    for clip in _samples(db):
        if wanted.items() <= clip.tags.items():
            return clip
    raise NotFoundError(
        f"The sample library has no neutral clip of a {body} body.",
        code="sample_missing",
        mend="Let whoever runs the server call: manner prepare.",
    )


def _samples(db: Session) -> Iterable[ClipRecord]:
    return (clip for clip, _ in clips.listed(db, imported=False))
