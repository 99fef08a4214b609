"""The migrations and the models tell the same story, on every database."""

from __future__ import annotations

import uuid
from datetime import UTC, datetime
from typing import Any

from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from sqlalchemy import Connection, Engine, MetaData, inspect, select, text
from sqlalchemy.orm import Session

from app.persistence import schema
from app.persistence.models import Base, Response, StudySession, StudyVersion
from app.schemas.study import StudyDefinition
from app.services.plans import planned_steps


def test_upgrading_from_empty_gives_exactly_the_models_tables(engine: Engine) -> None:
    with engine.connect() as connection:
        context = MigrationContext.configure(connection, opts={"compare_type": True})
        assert compare_metadata(context, Base.metadata) == []


def test_downgrading_leaves_nothing_and_upgrading_again_works(engine: Engine) -> None:
    schema.downgrade(engine, "base")
    assert set(inspect(engine).get_table_names()) <= {"alembic_version"}
    assert schema.current(engine) is None
    schema.upgrade(engine)
    assert schema.current(engine) == schema.head()
    assert set(Base.metadata.tables) <= set(inspect(engine).get_table_names())


def test_clips_from_before_edited_ones_keep_their_answers_and_know_their_motion(
    engine: Engine,
) -> None:
    schema.downgrade(engine, "0001")
    digest, moment = "a" * 64, "2026-01-01 00:00:00+00:00"
    with engine.execution_options(writes=True).begin() as db:
        db.execute(
            text("INSERT INTO blobs VALUES (:digest, 'model/gltf-binary', :content, :moment)"),
            {"digest": digest, "content": b"glb", "moment": moment},
        )
        db.execute(
            text(
                "INSERT INTO clips (id, name, source, state, skeleton_hash, frames, frame_time,"
                " duration, cyclic, stature, poster_time, tags, clip_blob, glb_blob,"
                " engine_version, created_at) VALUES (:digest, 'walk', 'imported', 'kept', :digest,"
                " 2, 0.1, 0.1, :no, 1.7, 0, '{}', :digest, :digest, 'old', :moment)"
            ),
            {"digest": digest, "no": False, "moment": moment},
        )
    schema.upgrade(engine)
    with engine.connect() as db:
        row = db.execute(text("SELECT id, content_hash, recipe_source FROM clips")).one()
    assert tuple(row) == (digest, digest, None)


OLD_STUDY = {
    "slug": "walks", "title": "Walks", "contact": None, "question": "How?", "hint": "Choose.",
    "welcome": {"heading": "Hello", "lead": "Look.", "facts": ["a", "b", "c"], "example": None},
    "consent": {"version": "1", "heading": "Before", "terms": [], "statement": "Yes."},
    "scales": [{"id": "x", "left": "l", "right": "r", "left_more": "ll", "right_more": "rr"}],
    "steps": ["very", "neither", "very"], "comment": {"label": "More?", "placeholder": ""},
    "practice": 1, "thanks": {"heading": "Thanks", "text": "{clips}"},
    "stimuli": [
        {"clip": "a" * 64, "name": "walk", "label": "a walk", "body": "man", "style": "sad"}
    ],
}  # fmt: skip


def test_a_study_from_before_versions_becomes_its_first_version_with_its_answers(
    engine: Engine,
) -> None:
    schema.downgrade(engine, "0002")
    session = uuid.uuid4()
    with engine.execution_options(writes=True).begin() as db:
        old = MetaData()
        old.reflect(db)
        _fill_old_tables(db, old.tables, session)
    schema.upgrade(engine)
    with Session(engine) as db:
        (version,) = db.scalars(select(StudyVersion))
        assert (version.number, version.definition_hash) == (1, "h" * 64)
        definition = StudyDefinition.model_validate(version.definition)
        (row,) = db.scalars(select(Response))
        (kept,) = db.scalars(select(StudySession))
    assert definition.trials[0].stimuli[0].clip == "a" * 64
    assert kept.id == session
    assert (kept.version_id, kept.kind, kept.source) == (version.id, "participant", "open")
    steps = planned_steps(kept.plan)
    assert [(step["clips"], step["practice"]) for step in steps] == [(["a" * 64], True)]
    assert steps[0]["part"] == row.part == definition.trials[0].id
    assert (row.answers, row.trial_type) == ({"x": 1}, "semantic_differential")


def _fill_old_tables(db: Connection, tables: Any, session: uuid.UUID) -> None:
    moment, digest = datetime(2026, 1, 1, tzinfo=UTC), "a" * 64

    def add(table: str, **row: Any) -> None:
        db.execute(tables[table].insert().values(**row))

    add("blobs", hash=digest, media_type="model/gltf-binary", content=b"glb", created_at=moment)
    add(
        "clips", id=digest, name="walk", source="sample", state="kept", skeleton_hash=digest,
        frames=2, frame_time=0.1, duration=0.1, cyclic=False, stature=1.7, poster_time=0.0,
        tags={}, clip_blob=digest, glb_blob=digest, content_hash=digest, engine_version="old",
        created_at=moment,
    )  # fmt: skip
    add(
        "studies", id=1, slug="walks", title="Walks", definition=OLD_STUDY,
        definition_hash="h" * 64, created_at=moment,
    )  # fmt: skip
    add(
        "sessions", id=session.hex if db.dialect.name == "sqlite" else session, study_id=1,
        token_hash="t" * 64, state="active", created_at=moment,
        plan={"trials": [{"clip": digest, "practice": True}]},
    )  # fmt: skip
    add(
        "responses", session_id=session.hex if db.dialect.name == "sqlite" else session,
        trial_index=0, revision=1, clip_id=digest, practice=True, answers={"x": 1}, comment="",
        rt_ms=1.0, record={}, fingerprint="f" * 64, received_at=moment,
    )  # fmt: skip
