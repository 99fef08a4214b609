"""What a running study shows: who is how far, what is suspicious, who did what."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Literal
from uuid import UUID

from pydantic import BaseModel, BeforeValidator, StringConstraints

from app.schemas.sessions import SessionState, storable

Role = Literal["owner", "editor", "viewer"]
Kind = Literal["participant", "simulated"]
Stands = Literal["complete", "under_way", "left_early", "ended_early", "withdrawn"]


class Member(BaseModel):
    """A researcher who belongs to a study."""

    email: str
    name: str
    role: Role
    you: bool


class MemberList(BaseModel):
    """A study's members.

    Attributes:
        role: what the asking researcher is.
        everybodys: the study has no members; every researcher is its owner.
    """

    members: list[Member]
    role: Role
    everybodys: bool


class MemberRole(BaseModel):
    """What a member shall be."""

    role: Role


class AuditLine(BaseModel):
    """One thing that somebody did with a study."""

    id: int
    at: datetime
    who: str
    act: str
    sentence: str
    session_id: UUID | None


class AuditTrail(BaseModel):
    """A page of the audit trail, the newest first; `older`, where there is more, asks for it."""

    entries: list[AuditLine]
    older: int | None


class Suspicion(BaseModel):
    """A rule that a session breaks: by what number, and what the rule is."""

    id: Literal["same_answers", "flat_answers", "too_fast", "failed_checks", "hidden"]
    title: str
    number: str
    rule: str


class Mark(BaseModel):
    """What a researcher has set on a session by hand, and why."""

    reason: str
    by: str
    at: datetime


class Reason(BaseModel):
    """Why; it is kept in the audit trail."""

    reason: Annotated[
        str, StringConstraints(strip_whitespace=True, min_length=1, max_length=500),
        BeforeValidator(storable),
    ]  # fmt: skip


class SessionLine(BaseModel):
    """One participant in a list.

    Attributes:
        name: the first digits of the id, to tell participants apart by.
        stands: how far the participant is, in words; `left_early` after a while without a sign.
        seconds: from agreeing to the last answer; None before the first.
        excluded: why a researcher left the session out of the results; None: it counts.
        flag: a mark by hand, to look at it again.
    """

    id: UUID
    name: str
    state: SessionState
    stands: Stands
    group: str | None
    language: str | None
    device: str | None
    source: str | None
    began: datetime
    answered: int
    steps: int
    seconds: int | None
    suspicions: list[Suspicion]
    excluded: Mark | None
    flag: Mark | None


class GroupCounts(BaseModel):
    """How many participants of a group stand where; those left out are in none but `excluded`."""

    id: str | None
    label: str
    complete: int
    under_way: int
    left_early: int
    ended_early: int


class LiveCounts(BaseModel):
    """How many participants stand where.

    Attributes:
        under_way: with a sign of life within the lease; left_early: without.
        ended_early: sent out by an answer or by failed attention checks.
        answers: steps answered, by all of them.
    """

    complete: int
    under_way: int
    left_early: int
    ended_early: int
    withdrawn: int
    excluded: int
    answers: int


class DropoutStep(BaseModel):
    """How many had answered so many steps and not left; `left` went away at the step after them."""

    answered: int
    still: int
    left: int


class PartStart(BaseModel):
    """A part of the study begins after so many steps."""

    start: int
    name: str


class Dropout(BaseModel):
    """Where participants stop, of the `of` that are complete or have left.

    Attributes:
        parts: where each part of the study begins, if that is the same for everybody.
    """

    of: int
    steps: list[DropoutStep]
    parts: list[PartStart]
    sentence: str


class DurationBin(BaseModel):
    """How many took from `start` to less than `end` seconds; the last one is open (`end` null)."""

    start: int
    end: int | None
    count: int


class Durations(BaseModel):
    """How long complete participants took, from agreeing to the last answer."""

    median_seconds: float | None
    bins: list[DurationBin]
    sentence: str


class ClipCount(BaseModel):
    """How often a clip was judged, practice and attention checks left out."""

    clip: str
    label: str
    complete: int
    others: int


class SessionList(BaseModel):
    """Sessions to look at, the latest first; `total` may be more than are listed."""

    total: int
    sessions: list[SessionLine]


class LiveView(BaseModel):
    """All that the live page shows.

    Attributes:
        kind: of the sessions: participants, or simulated ones.
        quota: how many shall complete the study; None: any number.
        lease_minutes: after so long without a sign, somebody counts as having left.
    """

    slug: str
    title: str
    state: str
    kind: Kind
    quota: int | None
    lease_minutes: int
    counts: LiveCounts
    groups: list[GroupCounts]
    dropout: Dropout
    durations: Durations
    clips: list[ClipCount]
    clips_sentence: str
    suspicious: SessionList
    marked: SessionList
    latest: SessionList


class ReplayFigure(BaseModel):
    """A figure as it stood on the page; the third of `abx` is X again."""

    glb_url: str | None
    figure_url: str | None
    name: str


class ToldAnswer(BaseModel):
    """One value of an answer, in words."""

    label: str
    value: str


class Viewed(BaseModel):
    """How a trial was viewed, in words."""

    label: str
    value: str


class ReplayStep(BaseModel):
    """One step of a participant's way, and the newest answer to it.

    Attributes:
        note: what was special about it: practice, an attention check and whether it held.
        answers: empty without an answer, and on pages without a question.
        changed: how often the answer was changed.
        at: when it was stored; `seconds` since the one before (or since agreeing).
        camera: [ms since the figures came, azimuth and elevation in degrees, zoom] of the view, as
            far as it was recorded.
    """

    index: int
    part: str
    kind: str
    title: str
    note: str | None
    figures: list[ReplayFigure]
    reference: ReplayFigure | None
    answered: bool
    answers: list[ToldAnswer]
    comment: str
    changed: int
    rt_ms: float | None
    at: datetime | None
    viewed: list[Viewed]
    camera: list[tuple[float, float, float, float]]


class SessionDetail(BaseModel):
    """One participant's way through the study (its title), step by step."""

    study: str
    session: SessionLine
    version: int
    slot: int | None
    seed: int | None
    consented_at: datetime | None
    completed_at: datetime | None
    steps: list[ReplayStep]
    trail: list[AuditLine]
