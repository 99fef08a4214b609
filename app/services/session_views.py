"""What a participant's page is told: the steps, and what each part asks, in one language.

Nothing in it gives away a clip's name, which clip is practice, or that a trial is a check.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from sqlalchemy.orm import Session

from app.persistence import responses, studies
from app.persistence.models import Response
from app.persistence.studies import Media
from app.schemas.sessions import (
    FigureView,
    LanguageView,
    ResponseView,
    SessionView,
    StepView,
    StudyView,
)
from app.schemas.study import (
    LANGUAGE_NAMES,
    AnyPart,
    Form,
    Instructed,
    Instructions,
    Language,
    Match,
    SemanticDifferential,
    StudyDefinition,
    Trials,
    Words,
)
from app.services import matching, matching_page
from app.services.plans import PAUSE, Plan, Step, draw_plan, group_of, planned_steps
from app.services.sessions import open_session, refuse_late
from app.services.studies import definition_of, language_for, localised, media_url

Clips = Mapping[str, Media]


def view(db: Session, token: str) -> SessionView:
    """All that the participant's page needs to go on where it stopped."""
    session = open_session(db, token)
    refuse_late(session)
    language = language_for(definition_of(session.version), session.language)
    definition = localised(session.version, language)
    newest = responses.newest(db, session.id)
    found = _of_plan(db, definition, language, session.plan)
    return found.model_copy(
        update={
            "state": session.state,
            "responses": {index: _response(row) for index, row in sorted(newest.items())},
            "next": next((i for i in range(len(found.steps)) if i not in newest), len(found.steps)),
        }
    )


def preview(
    db: Session, definition: StudyDefinition, language: Language, part: str | None = None
) -> SessionView:
    """A way through a study that is not kept, for its researcher to look at.

    Args:
        db: where the clips are.
        definition: with its clips resolved.
        language: of the texts.
        part: where to begin, the first step of this part.
    """
    plan = preview_plan(definition, part)
    found = _of_plan(db, definition.into(language), language, plan)
    first = next((step.index for step in found.steps if step.part == part), 0)
    return found.model_copy(
        update={"next": first, "study": found.study.model_copy(update={"preview": True})}
    )


def preview_plan(definition: StudyDefinition, part: str | None = None) -> Plan:
    """The way that is previewed: always the same one that sees the part."""
    slot = _slot_that_sees(definition, part)
    return draw_plan(definition, seed=0, slot=slot, design="preview")


def _slot_that_sees(definition: StudyDefinition, part: str | None) -> int:
    groups = next((one.groups for one in definition.parts if one.id == part), None)
    slots = range(max(1, len(definition.groups)))
    return next((slot for slot in slots if not groups or group_of(definition, slot) in groups), 0)


def _of_plan(
    db: Session, definition: StudyDefinition, language: Language, plan: Plan | None
) -> SessionView:
    steps = planned_steps(plan)
    parts = {part.id: part for part in (*definition.parts, PAUSE)}
    seen = {step["part"] for step in steps}
    clips = studies.media(db, _clips(definition, steps))
    scales = (plan or {}).get("scales", {})
    return SessionView(
        study=StudyView(
            title=str(definition.welcome.heading),
            language=language,
            languages=[
                LanguageView(id=one, name=LANGUAGE_NAMES[one]) for one in definition.languages
            ],
            back=definition.back,
        ),
        state="active",
        parts={
            name: _part_view(db, part, clips, language)
            for name, part in parts.items()
            if name in seen
        },
        steps=[
            _step_view(index, step, parts[step["part"]], clips, scales.get(step["part"]))
            for index, step in enumerate(steps)
        ],
        responses={},
        next=0,
    )


def _clips(definition: StudyDefinition, steps: Iterable[Step]) -> set[str]:
    found = {clip for step in steps for clip in step.get("clips", ())}
    for part in definition.parts:
        if isinstance(part, Trials) and isinstance(part.task, SemanticDifferential):
            found |= {part.task.reference} if part.task.reference else set()
        elif isinstance(part, Instructions):
            found |= {example.clip for example in part.figures}
    return found


def _step_view(
    index: int, step: Step, part: AnyPart, clips: Clips, scales: list[str] | None
) -> StepView:
    if not isinstance(part, Trials):
        return StepView(index=index, part=part.id, kind=part.kind, figures=[])
    shown = [_figure(clips[clip]) for clip in step["clips"]]
    if "x" in step:
        shown.append(shown[step["x"]])
    reference = getattr(part.task, "reference", None)
    return StepView(
        index=index,
        part=part.id,
        kind=part.task.kind,
        figures=shown,
        reference=_figure(clips[reference]) if reference else None,
        instruction=_instruction(part, step),
        scales=scales,
        interface=step.get("interface"),
        seen=step.get("seen"),
    )


def _instruction(part: Trials, step: Step) -> str | None:
    check = next((one for one in part.checks if one.id == step.get("check")), None)
    return str(check.text) if isinstance(check, Instructed) else None


def _part_view(db: Session, part: AnyPart, clips: Clips, language: Language) -> dict[str, Any]:
    if part.id == PAUSE.id:  # ours, not the study's: it is still in all languages
        part = PAUSE.model_copy(
            update={
                "heading": PAUSE.heading.into(language),
                "text": PAUSE.text.into(language),
            }
        )
    if isinstance(part, Trials) and isinstance(part.task, Match):
        asked = part.task.model_dump(mode="json", exclude={"space", "practice_targets"})
        return {**asked, **matching_page.page(db, part.task, language)}
    if isinstance(part, Trials):
        return part.task.model_dump(mode="json", exclude={"reference"})
    found = part.model_dump(mode="json", exclude={"groups"})
    if isinstance(part, Form):
        for field in found["fields"]:
            for option in field["options"]:
                del option["screens_out"]
    if isinstance(part, Instructions):
        found["figures"] = [
            _figure(clips[example.clip], _maybe(example.caption)).model_dump()
            for example in part.figures
        ]
    return found


def _maybe(words: Words | None) -> str | None:
    return None if words is None else str(words)


def _figure(media: Media, caption: str | None = None) -> FigureView:
    return FigureView(
        glb_url=media_url(media.glb),
        figure_url=media.figure and media_url(media.figure),
        cyclic=media.cyclic,
        caption=caption,
    )


def _response(row: Response) -> ResponseView:
    return ResponseView(
        revision=row.revision,
        answers=matching.as_sent(row.answers),
        touched=row.record["touched"],
        comment=row.comment,
    )
