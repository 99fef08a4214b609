"""Authoring spaces, and what researchers choose in the analysis that they are made from.

Revision ID: 0004
Revises: 0003
"""

import sqlalchemy as sa
from alembic import op

revision = "0004"
down_revision = "0003"
branch_labels = None
depends_on = None

JSON = sa.JSON(none_as_null=True)
TIME = sa.DateTime(timezone=True)


def upgrade():
    op.create_table(
        "spaces",
        sa.Column("id", sa.String(64), nullable=False),
        sa.Column("name", sa.String(200), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("definition", JSON, nullable=False),
        sa.Column("study_id", sa.Integer(), nullable=True),
        sa.Column("made_by", sa.Integer(), nullable=True),
        sa.Column("created_at", TIME, nullable=False),
        sa.ForeignKeyConstraint(
            ["study_id"], ["studies.id"], name=op.f("fk_spaces_study_id_studies")
        ),
        sa.ForeignKeyConstraint(
            ["made_by"], ["researchers.id"], name=op.f("fk_spaces_made_by_researchers")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_spaces")),
        sa.UniqueConstraint("name", "number", name=op.f("uq_spaces_name_number")),
    )
    op.create_index(op.f("ix_spaces_study_id"), "spaces", ["study_id"])
    op.create_table(
        "impression_choices",
        sa.Column("study_id", sa.Integer(), nullable=False),
        sa.Column("part", sa.String(60), nullable=False),
        sa.Column("choices", JSON, nullable=False),
        sa.Column("saved_at", TIME, nullable=False),
        sa.ForeignKeyConstraint(
            ["study_id"], ["studies.id"], name=op.f("fk_impression_choices_study_id_studies")
        ),
        sa.PrimaryKeyConstraint("study_id", "part", name=op.f("pk_impression_choices")),
    )


def downgrade():
    op.drop_table("impression_choices")
    op.drop_index(op.f("ix_spaces_study_id"), "spaces")
    op.drop_table("spaces")
