"""Edited clips and what they are made of; keys for programs; long work; motion graphs.

Columns are added in place: on SQLite, copying the table would break what refers to its rows.

Revision ID: 0002
Revises: 0001
"""

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"
branch_labels = None
depends_on = None

JSON = sa.JSON(none_as_null=True)
TIME = sa.DateTime(timezone=True)
OF_EDITED_CLIPS = ("recipe", "recipe_source", "recipe_hash", "quality")


def upgrade():
    op.add_column(
        "clips", sa.Column("content_hash", sa.String(64), nullable=False, server_default="")
    )
    op.execute("UPDATE clips SET content_hash = id")
    op.add_column("clips", sa.Column("recipe", JSON, nullable=True))
    op.add_column("clips", sa.Column("recipe_hash", sa.String(64), nullable=True))
    op.add_column("clips", sa.Column("quality", JSON, nullable=True))
    _add_recipe_source()
    op.create_index(op.f("ix_clips_recipe_source"), "clips", ["recipe_source"])
    _create_poses()
    _create_graphs()
    _create_keys()
    _create_jobs()


def downgrade():
    for table in ("jobs", "api_keys", "graphs", "poses"):
        op.drop_table(table)
    op.execute("DELETE FROM clips WHERE recipe_source IS NOT NULL")
    op.drop_index(op.f("ix_clips_recipe_source"), "clips")
    for column in (*OF_EDITED_CLIPS, "content_hash"):
        op.drop_column("clips", column)


def _add_recipe_source():
    if op.get_bind().dialect.name == "sqlite":
        op.execute("ALTER TABLE clips ADD COLUMN recipe_source VARCHAR(64) REFERENCES clips (id)")
        return
    op.add_column("clips", sa.Column("recipe_source", sa.String(64), nullable=True))
    name = op.f("fk_clips_recipe_source_clips")
    op.create_foreign_key(name, "clips", "clips", ["recipe_source"], ["id"])


def _create_poses():
    op.create_table(
        "poses",
        sa.Column("id", sa.String(64), nullable=False),
        sa.Column("name", sa.String(200), nullable=False),
        sa.Column("rotations", JSON, nullable=False),
        sa.Column("clip_id", sa.String(64), nullable=True),
        sa.Column("frame", sa.Integer(), nullable=False),
        sa.Column("created_at", TIME, nullable=False),
        sa.ForeignKeyConstraint(
            ["clip_id"], ["clips.id"], name=op.f("fk_poses_clip_id_clips"), ondelete="SET NULL"
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_poses")),
    )


def _create_graphs():
    op.create_table(
        "graphs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(200), nullable=False),
        sa.Column("definition", JSON, nullable=False),
        sa.Column("created_at", TIME, nullable=False),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_graphs")),
    )


def _create_keys():
    op.create_table(
        "api_keys",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("researcher_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(200), nullable=False),
        sa.Column("hint", sa.String(10), nullable=False),
        sa.Column("key_hash", sa.String(64), nullable=False),
        sa.Column("scope", sa.String(10), nullable=False),
        sa.Column("created_at", TIME, nullable=False),
        sa.Column("last_used_at", TIME, nullable=True),
        sa.Column("revoked_at", TIME, nullable=True),
        sa.ForeignKeyConstraint(
            ["researcher_id"],
            ["researchers.id"],
            name=op.f("fk_api_keys_researcher_id_researchers"),
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_api_keys")),
        sa.UniqueConstraint("key_hash", name=op.f("uq_api_keys_key_hash")),
    )
    op.create_index(op.f("ix_api_keys_researcher_id"), "api_keys", ["researcher_id"])


def _create_jobs():
    op.create_table(
        "jobs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.String(20), nullable=False),
        sa.Column("researcher_id", sa.Integer(), nullable=True),
        sa.Column("state", sa.String(20), nullable=False),
        sa.Column("request", JSON, nullable=False),
        sa.Column("items", JSON, nullable=False),
        sa.Column("total", sa.Integer(), nullable=False),
        sa.Column("done", sa.Integer(), nullable=False),
        sa.Column("failed", sa.Integer(), nullable=False),
        sa.Column("created_at", TIME, nullable=False),
        sa.Column("started_at", TIME, nullable=True),
        sa.Column("ended_at", TIME, nullable=True),
        sa.ForeignKeyConstraint(
            ["researcher_id"], ["researchers.id"], name=op.f("fk_jobs_researcher_id_researchers")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_jobs")),
    )
    op.create_index(op.f("ix_jobs_state"), "jobs", ["state"])
