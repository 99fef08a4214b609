"""Edits, their checks, and what they are made of, as the API tells them."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, StringConstraints, model_validator
from pydantic.config import JsonValue

from app.schemas.library import ClipDetail, QualityReport, Step

SOURCE = "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11"
_STEPS: list[JsonValue] = [
    {"operation": "grid@1", "parameters": {"path": 0.4, "timing": 1.6}},
    {"operation": "posture@1", "parameters": {"offsets": [{"pose": "head_down", "amount": 0.8}]}},
]
_POSE_ID = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"

# PostgreSQL stores no NUL, and would say so only when a job has made the clip.
Name = Annotated[
    str,
    StringConstraints(min_length=1, max_length=200, strip_whitespace=True, pattern=r"^[^\x00]*$"),
]
TagName = Annotated[str, StringConstraints(min_length=1, max_length=50)]
TagValue = Annotated[str, StringConstraints(min_length=1, max_length=200)]
Tags = Annotated[dict[TagName, TagValue], Field(max_length=32)]


def _example(**members: JsonValue) -> ConfigDict:
    return ConfigDict(json_schema_extra={"example": members})


# Read by the recipe itself, which names the step and the parameter at fault.
Steps = Annotated[
    list[Any],
    Field(
        json_schema_extra={"items": {"$ref": "#/components/schemas/Step"}},
        description="Steps of a recipe, done one after the other",
        examples=[_STEPS],
    ),
]


class Edit(BaseModel):
    """What is done to which clip: operations, or the name of a preset.

    Attributes:
        source: a clip's id.
        preset: a name from ``GET /api/v1/presets``.
    """

    model_config = ConfigDict(
        extra="forbid", json_schema_extra={"example": {"source": SOURCE, "operations": _STEPS}}
    )

    source: str = Field(max_length=64)
    operations: Steps | None = None
    preset: str | None = Field(default=None, max_length=100)

    @model_validator(mode="after")
    def _one_of_both(self) -> Edit:
        if (self.operations is None) == (self.preset is None):
            raise ValueError("give either operations or a preset")
        return self


class ClipRequest(Edit):
    """An edit to keep as a clip. Without a name it is called after its source."""

    model_config = ConfigDict(
        extra="forbid",
        json_schema_extra={
            "example": {
                "source": SOURCE,
                "preset": "sad",
                "name": "walk_sad",
                "tags": {"emotion": "sad", "made": "modified"},
            }
        },
    )

    name: Name | None = None
    tags: Tags = {}


class Label(BaseModel):
    """A clip's name, and its tags if they change as well."""

    model_config = ConfigDict(
        extra="forbid",
        json_schema_extra={"example": {"name": "walk_sad", "tags": {"emotion": "sad"}}},
    )

    name: Name
    tags: Tags | None = None


class Contacts(BaseModel):
    """When each foot stands: stretches from start to end, in seconds."""

    model_config = _example(left=[[0.0, 0.6]], right=[[0.5, 1.1]])

    left: list[tuple[float, float]]
    right: list[tuple[float, float]]


class Checked(BaseModel):
    """What an edit would give: its report, when its feet stand, duration (s) and frames."""

    recipe_hash: str
    report: QualityReport
    contacts: Contacts
    duration: float
    frames: int


class EasedOff(BaseModel):
    """The recipe at the greatest share, from 0 to 1, that breaks nothing."""

    operations: list[Step]
    share: float
    report: QualityReport


class Rebuilt(BaseModel):
    """A clip made again from its recipe.

    Attributes:
        identical: whether the motion came out the same to the last bit.
        clip: the clip of this engine: the same one, or a new one beside that of an older engine.
    """

    identical: bool
    clip: ClipDetail


class OperationView(BaseModel):
    """One kind of step.

    Attributes:
        name: as recipes write it, with its version.
        parameters: JSON Schema (2020-12) with ``unit``, range and ``default`` of each.
    """

    model_config = _example(
        name="tempo@1",
        title="Tempo",
        summary="Makes the whole motion faster or slower.",
        parameters={
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "type": "object",
            "properties": {
                "factor": {"type": "number", "minimum": 0.25, "maximum": 4.0, "default": 1.0}
            },
            "additionalProperties": False,
        },
    )

    name: str
    title: str
    summary: str
    parameters: dict[str, Any]


class OperationList(BaseModel):
    """Everything that a recipe's steps can do."""

    operations: list[OperationView]


class PresetView(BaseModel):
    """A recipe with a name and the emotion that it is meant to show."""

    model_config = _example(
        name="sad",
        title="Sad",
        summary="Shorter paths, even speed, the head down.",
        emotion="sad",
        axis="sad_happy",
        pole="sad",
        operations=_STEPS,
    )

    name: str
    title: str
    summary: str
    emotion: str
    axis: str
    pole: str
    operations: list[Step]


class PresetList(BaseModel):
    """The recipes that come with the server."""

    presets: list[PresetView]


class PoseRequest(BaseModel):
    """Which frame of which clip, counted from 0, to keep as a pose."""

    model_config = ConfigDict(
        extra="forbid", json_schema_extra={"example": {"clip": SOURCE, "frame": 12, "name": "bent"}}
    )

    clip: str = Field(max_length=64)
    frame: int = Field(ge=0, le=10_000_000)
    name: Name


class PoseView(BaseModel):
    """A standing pose: one that comes with the server (``stance``), or one from a clip.

    Attributes:
        id: what recipes call it by.
        rotations: body role to rotation (w, x, y, z) in canonical axes.
    """

    model_config = _example(
        id=_POSE_ID,
        name="bent",
        stance=False,
        clip=SOURCE,
        frame=12,
        created_at="2026-01-31T12:00:00Z",
        rotations={"head": [0.98, 0.2, 0.0, 0.0]},
    )

    id: str
    name: str
    stance: bool
    clip: str | None
    frame: int | None
    created_at: datetime | None
    rotations: dict[str, list[float]]


class PoseList(BaseModel):
    """The poses that posture offsets can be made of."""

    poses: list[PoseView]
