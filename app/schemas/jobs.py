"""Many clips at once: what is asked for, what it comes to, how far it is."""

from __future__ import annotations

from datetime import datetime
from typing import Literal
from uuid import UUID

from pydantic import BaseModel, ConfigDict, Field, model_validator

from app.schemas.edits import SOURCE, ClipRequest, Tags

MOST = 2000  # clips in one job
State = Literal["waiting", "running", "done", "cancelled", "failed"]


class Choice(BaseModel):
    """Every one of the sources by every one of the presets, with tags that all get."""

    model_config = ConfigDict(
        extra="forbid",
        json_schema_extra={
            "example": {
                "sources": [SOURCE],
                "presets": ["sad", "angry"],
                "tags": {"set": "pilot"},
            }
        },
    )

    sources: list[str] = Field(max_length=MOST)
    presets: list[str] = Field(max_length=MOST)
    tags: Tags = {}


class Batch(BaseModel):
    """Clips to make: each one by itself, or sources by presets."""

    model_config = ConfigDict(
        extra="forbid", json_schema_extra=Choice.model_config["json_schema_extra"]
    )

    items: list[ClipRequest] | None = Field(default=None, min_length=1, max_length=MOST)
    sources: list[str] | None = Field(default=None, min_length=1, max_length=MOST)
    presets: list[str] | None = Field(default=None, min_length=1, max_length=MOST)
    tags: Tags = {}

    @model_validator(mode="after")
    def _one_of_both(self) -> Batch:
        product = (self.sources is not None, self.presets is not None)
        if product != (self.items is None, self.items is None):
            raise ValueError("give either items, or sources and presets")
        return self


class PlannedClip(BaseModel):
    """A clip that a set will hold.

    Attributes:
        name, tags: as proposed; both may be changed before it is made.
        clip: its id if the library has it already.
    """

    source: str
    source_name: str
    preset: str
    preset_title: str
    name: str
    tags: dict[str, str]
    clip: str | None


class Plan(BaseModel):
    """What a choice comes to, in its order."""

    items: list[PlannedClip]


class JobView(BaseModel):
    """Long work and how far it is.

    Attributes:
        kind: `clips`, or `stability` of an analysis of impressions.
        total: number of clips; done: of those that are kept; failed: of those that could not be
            made. What a cancelled job has made stays. A bootstrap counts pieces of its work.
    """

    model_config = ConfigDict(
        from_attributes=True,
        json_schema_extra={
            "example": {
                "id": "4f0f1e3a-5b7e-4a43-9d5a-6f3f1f0c2d11",
                "kind": "clips",
                "state": "running",
                "total": 20,
                "done": 7,
                "failed": 0,
                "created_at": "2026-01-05T09:30:00Z",
                "started_at": "2026-01-05T09:30:01Z",
                "ended_at": None,
            }
        },
    )

    id: UUID
    kind: str
    state: State
    total: int
    done: int
    failed: int
    created_at: datetime
    started_at: datetime | None
    ended_at: datetime | None


class JobItem(BaseModel):
    """One clip of a job, in the order asked for: made (`clip`), failed (`error`) or neither yet."""

    source: str
    name: str
    clip: str | None
    error: str | None


class JobDetail(JobView):
    """A job with what became of each clip, if it makes any."""

    items: list[JobItem]


class JobList(BaseModel):
    """The last jobs, the newest first."""

    jobs: list[JobView]
