"""What a running study shows: who is how far, what is suspicious, who did what."""

from __future__ import annotations

from datetime import datetime
from typing import Literal
from uuid import UUID

from pydantic import BaseModel

Role = Literal["owner", "editor", "viewer"]


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
