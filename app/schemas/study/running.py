"""How a study is run: who may come, when, and how many. Changing it makes no new version."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import AwareDatetime, Field, StringConstraints, model_validator

from app.schemas.study.words import Part

Code = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9_-]{1,64}$")]
Outcome = Literal["complete", "screened_out", "failed_attention"]


class Prolific(Part):
    """Participants come with PROLIFIC_PID, STUDY_ID and SESSION_ID, and go back with a code."""

    complete: Code
    screened_out: Code | None = None
    failed_attention: Code | None = None

    def code(self, outcome: Outcome) -> Code | None:
        """The completion code of an outcome, if it has one."""
        return {
            "complete": self.complete,
            "screened_out": self.screened_out,
            "failed_attention": self.failed_attention,
        }[outcome]


class Sona(Part):
    """Participants come with `?id=`; `credit_url` grants the credit, `{id}` in it is theirs."""

    credit_url: Annotated[str, StringConstraints(pattern=r"^https://[^\s]+$", max_length=500)]


class MTurk(Part):
    """Participants come with workerId and assignmentId; a code is shown for them to hand in."""

    sandbox: bool = False


class Running(Part):
    """How a study is run.

    Attributes:
        open_link: whoever has the study's address may take part; else only personal links and
            recruiting services lead in.
        quota: how many may complete it; None means any number.
        opens_at, closes_at: when new participants may begin.
        lease_minutes: without an answer for so long, a participant's slot goes to another; coming
            back on the personal link stays possible.
        resume_days: for so long after the beginning the personal link can be gone on with.
        retention_days: so long after the last answer, everything personal is deleted; None: never.
        fail_after: so many failed attention checks end the study for a participant; None: none do.
    """

    open_link: bool = True
    quota: Annotated[int, Field(ge=1, le=1_000_000)] | None = None
    opens_at: AwareDatetime | None = None
    closes_at: AwareDatetime | None = None
    lease_minutes: Annotated[int, Field(ge=1, le=100_000)] = 60
    resume_days: Annotated[int, Field(ge=1, le=3650)] = 30
    retention_days: Annotated[int, Field(ge=1, le=36_500)] | None = None
    fail_after: Annotated[int, Field(ge=1, le=100)] | None = None
    prolific: Prolific | None = None
    sona: Sona | None = None
    mturk: MTurk | None = None

    @model_validator(mode="after")
    def _opens_before_it_closes(self) -> Self:
        if self.opens_at and self.closes_at and self.opens_at >= self.closes_at:
            raise ValueError("closes_at: it closes before it opens")
        return self
