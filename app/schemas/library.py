"""Clips and import reports as the API tells them."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field
from pydantic.config import JsonDict

Axis = Literal["x", "y", "z", "-x", "-y", "-z"]

_CLIP: JsonDict = {
    "id": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
    "name": "set_b_sad_slow",
    "source": "sample",
    "state": "kept",
    "tags": {"set": "B", "body": "adult", "emotion": "sad", "speed": "slow", "synthetic": "yes"},
    "frames": 49,
    "frame_time": 0.0333333,
    "duration": 1.6,
    "cyclic": True,
    "stature": 1.74,
    "poster_time": 0.8,
    "skeleton_hash": "c1d2a6f0b3e94787a5f60d1e2b3c4d5e6f708192a3b4c5d6e7f8091a2b3c4d5e",
    "glb_url": "/media/5d41402abc4b2a76b9719d911017c5925d41402abc4b2a76b9719d911017c592.glb",
    "figure_url": "/media/7d793037a0760186574b0282f2f435e77d793037a0760186574b0282f2f435e7.glb",
    "recipe_source": None,
    "variant_of": None,
    "page_url": "/library/0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
}


_STEP: JsonDict = {"operation": "grid@1", "parameters": {"path": 0.4, "timing": 1.6}}
_FINDING: JsonDict = {
    "kind": "foot slip",
    "part": "left foot",
    "start": 0.4,
    "end": 0.6,
    "size": 0.012,
    "unit": "m",
    "limit": 0.005,
}


class Note(BaseModel):
    """One line of an import report: what was repaired, or what a person should confirm."""

    model_config = ConfigDict(
        json_schema_extra={
            "example": {"text": "A tab separates two numbers", "line": 217, "where": "line 217"}
        }
    )

    text: str
    line: int | None = None
    where: str | None = None
    offer: str | None = None


class ImportOptions(BaseModel):
    """What a person says about a file instead of leaving it to be guessed.

    Attributes:
        unit: metres for one unit of the file.
        up_axis: the file's axis that points up.
        roles: body role to the name of its joint; an empty name takes a guessed role away.
        drop_first_frame: leave out a calibration pose at the start.
        fill_gaps: replace missing numbers by values between their neighbours.
        root: which of several hierarchies to read, counted from 0.
        frame_time: seconds, where the file's is missing or wrong.
    """

    model_config = ConfigDict(
        extra="forbid", json_schema_extra={"example": {"unit": 0.01, "up_axis": "z"}}
    )

    unit: float | None = Field(default=None, gt=0, le=1000)
    up_axis: Axis | None = None
    roles: dict[str, str] | None = None
    drop_first_frame: bool = False
    fill_gaps: bool = False
    root: int | None = Field(default=None, ge=0)
    frame_time: float | None = Field(default=None, gt=0, le=10)


class ImportReport(BaseModel):
    """What was found in a file, repaired and guessed.

    Attributes:
        unit: metres for one unit of the file; stature and lowest_foot in metres.
        heading: radians, the way the motion faced before it was turned to +z.
        bake_error: metres, the largest deviation from joints whose positions moved in the file.
    """

    model_config = ConfigDict(extra="allow")

    repairs: list[Note]
    questions: list[Note]
    unit: float
    unit_name: str
    up_axis: str
    stature: float
    lowest_foot: float
    heading: float
    roles: dict[str, str]
    missing_roles: list[str]
    joint_names: list[str]
    frames: int
    frame_time: float
    duration: float
    bake_error: float
    options: ImportOptions = ImportOptions()


class ClipView(BaseModel):
    """A clip of the library; times in seconds, stature in metres.

    Attributes:
        skeleton_hash: the same for all clips that move one skeleton.
        recipe_source: id of the clip that its recipe begins with; variant_of: the same, unless the
            recipe makes something else of it: a motion on another body, or a mix of several.
    """

    model_config = ConfigDict(json_schema_extra={"example": _CLIP})

    id: str
    name: str
    source: Literal["sample", "imported", "edited"]
    state: Literal["kept", "to_confirm", "retired"]
    tags: dict[str, str]
    frames: int
    frame_time: float
    duration: float
    cyclic: bool
    stature: float
    poster_time: float
    skeleton_hash: str
    glb_url: str
    figure_url: str | None
    page_url: str
    recipe_source: str | None
    variant_of: str | None


class Step(BaseModel):
    """One operation of a recipe; what it takes is told by ``GET /api/v1/operations``."""

    model_config = ConfigDict(json_schema_extra={"example": _STEP})

    operation: str
    parameters: dict[str, Any] = {}


class Provenance(BaseModel):
    """What an edited clip is made of.

    Attributes:
        source: id of the clip that was edited; source_hash: hash of its motion.
        recipe: every step with all its parameters.
        engine_version: of the motion library that made it; current_engine: whether that one is
            still in use here.
        content_hash: hash of the edited motion.
    """

    source: str
    source_name: str
    source_hash: str
    recipe: list[Step]
    recipe_hash: str
    engine_version: str
    current_engine: bool
    content_hash: str


class Finding(BaseModel):
    """One thing that an edit broke, with its place in time.

    Attributes:
        kind: such as ``foot slip``; part: the body part.
        start, end: seconds.
        size: the worst value; limit: what would have been allowed; both in ``unit``.
    """

    model_config = ConfigDict(json_schema_extra={"example": _FINDING})

    kind: str
    part: str
    start: float
    end: float
    size: float
    unit: str
    limit: float


class QualityReport(BaseModel):
    """Everything that an edit broke, in the order of time."""

    model_config = ConfigDict(
        json_schema_extra={"example": {"clean": False, "findings": [_FINDING]}}
    )

    clean: bool
    findings: list[Finding]


class ClipDetail(ClipView):
    """A clip with the report of its import, or with what it is made of.

    Attributes:
        provenance: of an edited clip.
        quality: of an edited clip, once somebody has asked for it.
    """

    report: ImportReport | None
    provenance: Provenance | None
    quality: QualityReport | None


class Motion(BaseModel):
    """A motion in numbers: metres, seconds, local rotations as quaternions w, x, y, z.

    Attributes:
        parents: of each joint, −1 for the root; offsets: from the parent.
        root_positions: of each frame; rotations: of each frame and joint.
    """

    names: list[str]
    parents: list[int]
    offsets: list[tuple[float, float, float]]
    frame_time: float
    root_positions: list[tuple[float, float, float]]
    rotations: list[list[tuple[float, float, float, float]]]


class ClipDocument(ClipDetail):
    """A clip with its motion, which ``?motion=false`` leaves out."""

    motion: Motion | None = None


class ClipList(BaseModel):
    """The library."""

    clips: list[ClipView]


class Imported(BaseModel):
    """A clip that waits for confirmation, or was there already, and its report."""

    clip: ClipView
    report: ImportReport
    already_there: bool = False
