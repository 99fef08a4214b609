"""The tables. Times are UTC; contents are found by their SHA-256."""

from __future__ import annotations

import uuid
from datetime import UTC, datetime
from typing import Any

from sqlalchemy import (
    JSON,
    BigInteger,
    Dialect,
    ForeignKey,
    Index,
    Integer,
    LargeBinary,
    MetaData,
    String,
    Text,
    TypeDecorator,
    UniqueConstraint,
    text,
)
from sqlalchemy import DateTime as SqlDateTime
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column, relationship


def now() -> datetime:
    """The present moment, UTC."""
    return datetime.now(UTC)


class UtcDateTime(TypeDecorator[datetime]):
    """An aware UTC datetime, also from SQLite, which forgets the zone."""

    impl = SqlDateTime(timezone=True)
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        """Refuse times without a zone; store the others as UTC."""
        if value is None:
            return None
        if value.tzinfo is None:
            raise ValueError("A stored time needs its time zone.")
        return value.astimezone(UTC)

    def process_result_value(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        """Give back an aware time."""
        if value is None:
            return None
        return value.replace(tzinfo=UTC) if value.tzinfo is None else value.astimezone(UTC)


class Base(DeclarativeBase):
    """All tables, with constraint names that Alembic can find again on every database."""

    metadata = MetaData(
        naming_convention={
            "ix": "ix_%(table_name)s_%(column_0_N_name)s",
            "uq": "uq_%(table_name)s_%(column_0_N_name)s",
            "ck": "ck_%(table_name)s_%(constraint_name)s",
            "fk": "fk_%(table_name)s_%(column_0_N_name)s_%(referred_table_name)s",
            "pk": "pk_%(table_name)s",
        }
    )
    type_annotation_map = {  # noqa: RUF012 -- SQLAlchemy reads it from the class
        datetime: UtcDateTime,
        dict[str, Any]: JSON(none_as_null=True),
        dict[str, str]: JSON(none_as_null=True),
        dict[str, list[float]]: JSON(none_as_null=True),
        list[dict[str, Any]]: JSON(none_as_null=True),
        list[str]: JSON(none_as_null=True),
    }


class Researcher(Base):
    """A person who may sign in."""

    __tablename__ = "researchers"

    id: Mapped[int] = mapped_column(primary_key=True)
    email: Mapped[str] = mapped_column(String(254), unique=True)
    name: Mapped[str] = mapped_column(String(200))
    password_hash: Mapped[str] = mapped_column(String(200))
    created_at: Mapped[datetime] = mapped_column(default=now)


class SetupToken(Base):
    """A one-time link by which a researcher's account is made; only its hash is kept."""

    __tablename__ = "setup_tokens"

    token_hash: Mapped[str] = mapped_column(String(64), primary_key=True)
    created_at: Mapped[datetime] = mapped_column(default=now)
    used_at: Mapped[datetime | None]


class Blob(Base):
    """Bytes, addressed by their SHA-256."""

    __tablename__ = "blobs"

    hash: Mapped[str] = mapped_column(String(64), primary_key=True)
    media_type: Mapped[str] = mapped_column(String(100))
    content: Mapped[bytes] = mapped_column(LargeBinary, deferred=True)
    created_at: Mapped[datetime] = mapped_column(default=now)


class FigureRecord(Base):
    """The mannequin of one skeleton, made once."""

    __tablename__ = "figures"

    skeleton_hash: Mapped[str] = mapped_column(String(64), primary_key=True)
    glb_blob: Mapped[str] = mapped_column(ForeignKey("blobs.hash"))
    engine_version: Mapped[str] = mapped_column(String(64))
    created_at: Mapped[datetime] = mapped_column(default=now)


class ClipRecord(Base):
    """One motion of the library.

    Attributes:
        id: the motion's content hash; of an edited clip, the hash of what it is made by: source,
            recipe and engine version.
        content_hash: of the motion itself.
        source: ``sample``, ``imported`` or ``edited``.
        state: ``kept``, ``to_confirm`` (imported, its report not yet confirmed) or ``retired``
            (a sample that a newer engine makes differently; answers still refer to it).
        frame_time: seconds; duration: seconds; stature: metres; poster_time: seconds.
        clip_blob: the lossless clip; glb_blob: what the viewer plays; source_blob: the BVH file.
        recipe, recipe_source, recipe_hash: of an edited clip, what was done to which clip.
        quality: of an edited clip, the report on what the edit did to the motion, once asked for.
    """

    __tablename__ = "clips"

    id: Mapped[str] = mapped_column(String(64), primary_key=True)
    name: Mapped[str] = mapped_column(String(200))
    source: Mapped[str] = mapped_column(String(20))
    state: Mapped[str] = mapped_column(String(20), index=True)
    skeleton_hash: Mapped[str] = mapped_column(String(64), index=True)
    frames: Mapped[int]
    frame_time: Mapped[float]
    duration: Mapped[float]
    cyclic: Mapped[bool]
    stature: Mapped[float]
    poster_time: Mapped[float]
    tags: Mapped[dict[str, str]] = mapped_column(default=dict)
    report: Mapped[dict[str, Any] | None]
    clip_blob: Mapped[str] = mapped_column(ForeignKey("blobs.hash"))
    glb_blob: Mapped[str] = mapped_column(ForeignKey("blobs.hash"))
    source_blob: Mapped[str | None] = mapped_column(ForeignKey("blobs.hash"))
    content_hash: Mapped[str] = mapped_column(String(64))
    recipe: Mapped[list[dict[str, Any]] | None]
    recipe_source: Mapped[str | None] = mapped_column(ForeignKey("clips.id"), index=True)
    recipe_hash: Mapped[str | None] = mapped_column(String(64))
    quality: Mapped[dict[str, Any] | None]
    engine_version: Mapped[str] = mapped_column(String(64))
    created_at: Mapped[datetime] = mapped_column(default=now)


class PoseRecord(Base):
    """A pose captured from a frame of a clip, from which posture offsets are made.

    Attributes:
        id: hash of the rotations.
        rotations: body role to local rotation (w, x, y, z) in canonical axes.
    """

    __tablename__ = "poses"

    id: Mapped[str] = mapped_column(String(64), primary_key=True)
    name: Mapped[str] = mapped_column(String(200))
    rotations: Mapped[dict[str, list[float]]]
    clip_id: Mapped[str | None] = mapped_column(ForeignKey("clips.id", ondelete="SET NULL"))
    frame: Mapped[int]
    created_at: Mapped[datetime] = mapped_column(default=now)


class GraphRecord(Base):
    """A motion graph: which clips, how alike, and what a person changed by hand."""

    __tablename__ = "graphs"

    id: Mapped[uuid.UUID] = mapped_column(primary_key=True, default=uuid.uuid4)
    name: Mapped[str] = mapped_column(String(200))
    definition: Mapped[dict[str, Any]]
    created_at: Mapped[datetime] = mapped_column(default=now)


class SpaceRecord(Base):
    """An authoring space, frozen.

    Attributes:
        id: hash of the definition.
        name, number: the name that versions have in common, and which of them it is.
        study_id: whose answers it was made of; None where there was no questionnaire.
    """

    __tablename__ = "spaces"
    __table_args__ = (UniqueConstraint("name", "number"),)

    id: Mapped[str] = mapped_column(String(64), primary_key=True)
    name: Mapped[str] = mapped_column(String(200))
    number: Mapped[int]
    definition: Mapped[dict[str, Any]]
    study_id: Mapped[int | None] = mapped_column(ForeignKey("studies.id"), index=True)
    made_by: Mapped[int | None] = mapped_column(ForeignKey("researchers.id"))
    created_at: Mapped[datetime] = mapped_column(default=now)


class ImpressionChoices(Base):
    """What was chosen in a part's analysis: `app.schemas.impressions.AnalysisChoices`."""

    __tablename__ = "impression_choices"

    study_id: Mapped[int] = mapped_column(ForeignKey("studies.id"), primary_key=True)
    part: Mapped[str] = mapped_column(String(60), primary_key=True)
    choices: Mapped[dict[str, Any]]
    saved_at: Mapped[datetime] = mapped_column(default=now, onupdate=now)


class ApiKey(Base):
    """A program's right to call the API in a researcher's name; only the key's hash is kept.

    Attributes:
        hint: the key's last characters, by which its owner knows it again.
        scope: ``read`` or ``write``.
    """

    __tablename__ = "api_keys"

    id: Mapped[int] = mapped_column(primary_key=True)
    researcher_id: Mapped[int] = mapped_column(ForeignKey("researchers.id"), index=True)
    name: Mapped[str] = mapped_column(String(200))
    hint: Mapped[str] = mapped_column(String(10))
    key_hash: Mapped[str] = mapped_column(String(64), unique=True)
    scope: Mapped[str] = mapped_column(String(10))
    created_at: Mapped[datetime] = mapped_column(default=now)
    last_used_at: Mapped[datetime | None]
    revoked_at: Mapped[datetime | None]


class Job(Base):
    """Long work, its state and its progress.

    Attributes:
        state: ``waiting``, ``running``, ``done``, ``cancelled`` or ``failed``.
        kind: ``clips``, or ``stability`` of an analysis.
        request: what is to be done; items: one outcome each, in its order (of a bootstrap the one).
        total, done, failed: numbers of items, or of a bootstrap's pieces.
    """

    __tablename__ = "jobs"

    id: Mapped[uuid.UUID] = mapped_column(primary_key=True, default=uuid.uuid4)
    kind: Mapped[str] = mapped_column(String(20))
    researcher_id: Mapped[int | None] = mapped_column(ForeignKey("researchers.id"))
    state: Mapped[str] = mapped_column(String(20), default="waiting", index=True)
    request: Mapped[dict[str, Any]]
    items: Mapped[list[dict[str, Any]]] = mapped_column(default=list)
    total: Mapped[int]
    done: Mapped[int] = mapped_column(default=0)
    failed: Mapped[int] = mapped_column(default=0)
    created_at: Mapped[datetime] = mapped_column(default=now)
    started_at: Mapped[datetime | None]
    ended_at: Mapped[datetime | None]


class Study(Base):
    """A study under its address: a draft that changes, and versions that do not.

    Attributes:
        state: ``draft`` until first published, then ``open``, ``paused`` or ``closed``.
        draft: the study file as it is being edited; None where it equals the newest version.
        running: who may come and when (`app.schemas.study.Running`).
    """

    __tablename__ = "studies"

    id: Mapped[int] = mapped_column(primary_key=True)
    slug: Mapped[str] = mapped_column(String(100), unique=True)
    title: Mapped[str] = mapped_column(String(200))
    state: Mapped[str] = mapped_column(String(20), default="draft", server_default="open")
    draft: Mapped[dict[str, Any] | None]
    draft_saved_at: Mapped[datetime | None]
    running: Mapped[dict[str, Any]] = mapped_column(default=dict, server_default="{}")
    created_at: Mapped[datetime] = mapped_column(default=now)


class StudyVersion(Base):
    """A study as it was published: never changed, and answers belong to it.

    New participants see the newest.

    Attributes:
        number: 1, 2, … within the study.
        changes: what it changed against the version before, one sentence each.
    """

    __tablename__ = "study_versions"
    __table_args__ = (UniqueConstraint("study_id", "number"),)

    id: Mapped[int] = mapped_column(primary_key=True)
    study_id: Mapped[int] = mapped_column(ForeignKey("studies.id"), index=True)
    number: Mapped[int]
    definition: Mapped[dict[str, Any]]
    definition_hash: Mapped[str] = mapped_column(String(64))
    changes: Mapped[list[str]] = mapped_column(default=list)
    published_by: Mapped[int | None] = mapped_column(ForeignKey("researchers.id"))
    published_at: Mapped[datetime] = mapped_column(default=now)


class StudyMember(Base):
    """What a researcher may do with a study: ``owner``, ``editor`` or ``viewer``."""

    __tablename__ = "study_members"

    study_id: Mapped[int] = mapped_column(ForeignKey("studies.id"), primary_key=True)
    researcher_id: Mapped[int] = mapped_column(ForeignKey("researchers.id"), primary_key=True)
    role: Mapped[str] = mapped_column(String(10))


class AuditEntry(Base):
    """Who did what with a study, and when. Rows are only added.

    Attributes:
        researcher_id: None for what the server or a participant did.
        session_id: the participant that it was about; no foreign key, for it outlives a deletion.
        detail: what the act's sentence needs; a reason goes with the participant's data.
    """

    __tablename__ = "audit"

    id: Mapped[int] = mapped_column(primary_key=True)
    study_id: Mapped[int] = mapped_column(ForeignKey("studies.id"), index=True)
    researcher_id: Mapped[int | None] = mapped_column(ForeignKey("researchers.id"))
    session_id: Mapped[uuid.UUID | None] = mapped_column(index=True)
    act: Mapped[str] = mapped_column(String(40))
    detail: Mapped[dict[str, Any]] = mapped_column(default=dict)
    at: Mapped[datetime] = mapped_column(default=now)


class StudySession(Base):
    """One participant's way through a study.

    A withdrawal leaves this row as a tombstone: state ``withdrawn``, every other datum emptied.

    Attributes:
        kind: ``participant``, ``preview`` or ``simulated``; only participants count.
        token_hash: SHA-256 of the secret in the participant's address.
        slot: place in the study's design, from which group, rows and subsets follow.
        group: between-subject group.
        seed: from which the plan was drawn.
        plan: the trials in this participant's order.
        state: ``active``, ``complete``, ``screened_out``, ``failed_attention`` or ``withdrawn``.
        source: ``open``, ``personal``, ``prolific``, ``sona`` or ``mturk``.
        external: the recruiting service's parameters, needed to pay; gone with a withdrawal.
        excluded: why a researcher left this participant out: {reason, by, at}; None: is counted.
        flags: suspicions marked by hand, reason to note.
    """

    __tablename__ = "sessions"
    __table_args__ = (
        Index(None, "version_id", "slot"),
        # All that the live page counts by, so that it reads no row: rows hold long plans.
        Index(
            "ix_sessions_counted", "study_id", "kind", "state", "version_id", "group", "id",
            "created_at",
        ),
        Index(
            "ix_sessions_excluded", "study_id", "id",
            sqlite_where=text("excluded IS NOT NULL"),
            postgresql_where=text("excluded IS NOT NULL"),
        ),
        Index(
            "ix_sessions_flagged", "study_id", "id",
            sqlite_where=text("flags IS NOT NULL"),
            postgresql_where=text("flags IS NOT NULL"),
        ),
    )  # fmt: skip

    id: Mapped[uuid.UUID] = mapped_column(primary_key=True, default=uuid.uuid4)
    study_id: Mapped[int] = mapped_column(ForeignKey("studies.id"), index=True)
    version_id: Mapped[int] = mapped_column(  # never null; SQLite adds no other column in place
        ForeignKey("study_versions.id"), nullable=True
    )
    kind: Mapped[str] = mapped_column(
        String(20), default="participant", server_default="participant"
    )
    token_hash: Mapped[str] = mapped_column(String(64), unique=True)
    slot: Mapped[int | None]
    group: Mapped[str | None] = mapped_column(String(60))
    seed: Mapped[int | None] = mapped_column(BigInteger)
    plan: Mapped[dict[str, Any] | None]
    state: Mapped[str] = mapped_column(String(20), default="active")
    language: Mapped[str | None] = mapped_column(String(10))
    source: Mapped[str | None] = mapped_column(String(20))
    external: Mapped[dict[str, str] | None]
    excluded: Mapped[dict[str, Any] | None]
    flags: Mapped[dict[str, Any] | None]
    consent_version: Mapped[str | None] = mapped_column(String(64))
    consented_at: Mapped[datetime | None]
    completed_at: Mapped[datetime | None]
    withdrawn_at: Mapped[datetime | None]
    completion_code: Mapped[str | None] = mapped_column(String(40))
    user_agent_class: Mapped[str | None] = mapped_column(String(40))
    created_at: Mapped[datetime] = mapped_column(default=now)

    study: Mapped[Study] = relationship()
    version: Mapped[StudyVersion] = relationship()


class Response(Base):
    """One answer. Never updated: a changed answer is a new revision, and the newest counts.

    Attributes:
        part: the part of the study; trial_type: its kind of trial, or of page.
        clip_id: the judged clip; None on pages and where several are compared.
        clips: all clips of the trial as they stood on the page, from the left; None on pages.
        practice: unannounced practice, not analysed.
        check: name of the attention check that this trial is; passed: whether it held.
        answers: what was chosen (`app.schemas.study.tasks`); comment: free text.
        rt_ms: from the trial's start to the answer.
        record: how the trial was viewed.
        fingerprint: SHA-256 of the request, by which a repeated request is known.
    """

    __tablename__ = "responses"
    __table_args__ = (UniqueConstraint("session_id", "trial_index", "revision"),)

    id: Mapped[int] = mapped_column(
        BigInteger().with_variant(Integer, "sqlite"), primary_key=True, autoincrement=True
    )
    session_id: Mapped[uuid.UUID] = mapped_column(ForeignKey("sessions.id", ondelete="CASCADE"))
    trial_index: Mapped[int]
    revision: Mapped[int]
    part: Mapped[str] = mapped_column(String(60))
    trial_type: Mapped[str] = mapped_column(String(40))
    clip_id: Mapped[str | None] = mapped_column(ForeignKey("clips.id"), index=True)
    clips: Mapped[list[str] | None]
    practice: Mapped[bool]
    check: Mapped[str | None] = mapped_column(String(60))
    passed: Mapped[bool | None]
    answers: Mapped[dict[str, Any]]
    comment: Mapped[str] = mapped_column(Text, default="")
    rt_ms: Mapped[float]
    record: Mapped[dict[str, Any]]
    fingerprint: Mapped[str] = mapped_column(String(64))
    received_at: Mapped[datetime] = mapped_column(default=now)


class SessionSummary(Base):
    """What the live page needs of one session's answers, computed from them again when more come.

    Judged trials are those about clips, without practice and attention checks.

    Attributes:
        upto: number of an answer; all answers of the session up to it are in here.
        answered: of how many of its `steps` there is an answer.
        last_at: when the last answer came; seconds: from agreeing to then.
        median_ms: median time of a judged trial, in whole tenths of a second.
        same_run: the longest row of judged trials that were answered exactly alike.
        rated, flat: judged trials with three values or more; those of them with all values alike.
        checks, failed: attention checks answered, and failed.
        hidden_ms: how long the page was out of sight during trials.
        seen: the clips that were judged, four hexadecimal digits each: the place of the clip among
            the version's. So the database can join those of all sessions to one string, and a
            million answers are counted in a moment.
    """

    __tablename__ = "session_summaries"
    __table_args__ = {"sqlite_with_rowid": False}  # noqa: RUF012 -- SQLAlchemy reads it

    session_id: Mapped[uuid.UUID] = mapped_column(
        ForeignKey("sessions.id", ondelete="CASCADE"), primary_key=True
    )
    upto: Mapped[int] = mapped_column(BigInteger, index=True)
    steps: Mapped[int]
    answered: Mapped[int]
    last_at: Mapped[datetime]
    seconds: Mapped[int]
    judged: Mapped[int]
    median_ms: Mapped[int | None] = mapped_column(BigInteger)  # a page may stay open for weeks
    same_run: Mapped[int]
    rated: Mapped[int]
    flat: Mapped[int]
    checks: Mapped[int]
    failed: Mapped[int]
    hidden_ms: Mapped[int] = mapped_column(BigInteger)
    seen: Mapped[str] = mapped_column(Text)
