"""The migrations and the models tell the same story, on every database."""

from __future__ import annotations

from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from sqlalchemy import Engine, inspect, text

from app.persistence import schema
from app.persistence.models import Base


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
