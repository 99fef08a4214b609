"""Studies get versions, drafts, members and an audit trail; sessions a design; trials more kinds.

Columns are added in place: on SQLite, copying the table would break what refers to its rows.

Revision ID: 0003
Revises: 0002
"""

import json

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"
branch_labels = None
depends_on = None

JSON = sa.JSON(none_as_null=True)
TIME = sa.DateTime(timezone=True)
ASKED = ("question", "hint", "comment", "scales", "steps")
COUNTED_BY = ["study_id", "kind", "state", "version_id", "group", "id", "created_at"]
OF_SESSIONS = (
    sa.Column("kind", sa.String(20), nullable=False, server_default="participant"),
    sa.Column("slot", sa.Integer(), nullable=True),
    sa.Column("group", sa.String(60), nullable=True),
    sa.Column("language", sa.String(10), nullable=True),
    sa.Column("source", sa.String(20), nullable=True),
    sa.Column("external", JSON, nullable=True),
    sa.Column("excluded", JSON, nullable=True),
    sa.Column("flags", JSON, nullable=True),
)


def upgrade():
    _create_versions()
    _create_members_and_audit()
    _create_summaries()
    _widen_studies()
    _widen_sessions()
    _widen_responses()
    _carry_over()
    op.drop_column("studies", "definition")
    op.drop_column("studies", "definition_hash")


def downgrade():
    _take_back()
    with op.batch_alter_table("responses") as batch:
        batch.alter_column("clip_id", existing_type=sa.String(64), nullable=False)
        for column in ("part", "trial_type", "clips", "check", "passed"):
            batch.drop_column(column)
    op.drop_table("session_summaries")
    for index in ("excluded", "flagged", "version_id_slot", "counted"):
        op.drop_index(op.f(f"ix_sessions_{index}"), "sessions")
    if op.get_bind().dialect.name != "sqlite":
        op.drop_column("sessions", "version_id")
    for column in OF_SESSIONS:
        op.drop_column("sessions", column.name)
    for column in ("state", "draft", "draft_saved_at", "running"):
        op.drop_column("studies", column)
    for table in ("audit", "study_members"):
        op.drop_table(table)
    if op.get_bind().dialect.name == "sqlite":
        op.execute("ALTER TABLE sessions DROP COLUMN version_id")
    op.drop_table("study_versions")


def _create_versions():
    op.create_table(
        "study_versions",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("study_id", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("definition", JSON, nullable=False),
        sa.Column("definition_hash", sa.String(64), nullable=False),
        sa.Column("changes", JSON, nullable=False),
        sa.Column("published_by", sa.Integer(), nullable=True),
        sa.Column("published_at", TIME, nullable=False),
        sa.ForeignKeyConstraint(
            ["study_id"], ["studies.id"], name=op.f("fk_study_versions_study_id_studies")
        ),
        sa.ForeignKeyConstraint(
            ["published_by"],
            ["researchers.id"],
            name=op.f("fk_study_versions_published_by_researchers"),
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_study_versions")),
        sa.UniqueConstraint("study_id", "number", name=op.f("uq_study_versions_study_id_number")),
    )
    op.create_index(op.f("ix_study_versions_study_id"), "study_versions", ["study_id"])


def _create_members_and_audit():
    op.create_table(
        "study_members",
        sa.Column("study_id", sa.Integer(), nullable=False),
        sa.Column("researcher_id", sa.Integer(), nullable=False),
        sa.Column("role", sa.String(10), nullable=False),
        sa.ForeignKeyConstraint(
            ["study_id"], ["studies.id"], name=op.f("fk_study_members_study_id_studies")
        ),
        sa.ForeignKeyConstraint(
            ["researcher_id"],
            ["researchers.id"],
            name=op.f("fk_study_members_researcher_id_researchers"),
        ),
        sa.PrimaryKeyConstraint("study_id", "researcher_id", name=op.f("pk_study_members")),
    )
    op.create_table(
        "audit",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("study_id", sa.Integer(), nullable=False),
        sa.Column("researcher_id", sa.Integer(), nullable=True),
        sa.Column("session_id", sa.Uuid(), nullable=True),
        sa.Column("act", sa.String(40), nullable=False),
        sa.Column("detail", JSON, nullable=False),
        sa.Column("at", TIME, nullable=False),
        sa.ForeignKeyConstraint(
            ["study_id"], ["studies.id"], name=op.f("fk_audit_study_id_studies")
        ),
        sa.ForeignKeyConstraint(
            ["researcher_id"], ["researchers.id"], name=op.f("fk_audit_researcher_id_researchers")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_audit")),
    )
    op.create_index(op.f("ix_audit_study_id"), "audit", ["study_id"])
    op.create_index(op.f("ix_audit_session_id"), "audit", ["session_id"])


def _create_summaries():
    names = ("steps", "answered", "seconds", "judged", "same_run", "rated", "flat", "checks")
    op.create_table(
        "session_summaries",
        sa.Column("session_id", sa.Uuid(), nullable=False),
        sa.Column("upto", sa.BigInteger(), nullable=False),
        *(sa.Column(name, sa.Integer(), nullable=False) for name in (*names, "failed")),
        sa.Column("last_at", TIME, nullable=False),
        sa.Column("median_ms", sa.BigInteger(), nullable=True),
        sa.Column("hidden_ms", sa.BigInteger(), nullable=False),
        sa.Column("seen", sa.Text(), nullable=False),
        sa.ForeignKeyConstraint(
            ["session_id"],
            ["sessions.id"],
            name=op.f("fk_session_summaries_session_id_sessions"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("session_id", name=op.f("pk_session_summaries")),
        sqlite_with_rowid=False,
    )
    op.create_index(op.f("ix_session_summaries_upto"), "session_summaries", ["upto"])


def _widen_studies():
    state = sa.Column("state", sa.String(20), nullable=False, server_default="open")
    op.add_column("studies", state)
    op.add_column("studies", sa.Column("draft", JSON, nullable=True))
    op.add_column("studies", sa.Column("draft_saved_at", TIME, nullable=True))
    op.add_column("studies", sa.Column("running", JSON, nullable=False, server_default="{}"))


def _widen_sessions():
    if op.get_bind().dialect.name == "sqlite":
        op.execute(
            "ALTER TABLE sessions ADD COLUMN version_id INTEGER REFERENCES study_versions (id)"
        )
    else:
        op.add_column("sessions", sa.Column("version_id", sa.Integer(), nullable=True))
        name = op.f("fk_sessions_version_id_study_versions")
        op.create_foreign_key(name, "sessions", "study_versions", ["version_id"], ["id"])
    for column in OF_SESSIONS:
        op.add_column("sessions", column)
    op.create_index(op.f("ix_sessions_version_id_slot"), "sessions", ["version_id", "slot"])
    op.create_index(op.f("ix_sessions_counted"), "sessions", COUNTED_BY)
    for name, column in (("excluded", "excluded"), ("flagged", "flags")):
        marked = sa.text(f"{column} IS NOT NULL")
        op.create_index(
            op.f(f"ix_sessions_{name}"),
            "sessions",
            ["study_id", "id"],
            sqlite_where=marked,
            postgresql_where=marked,
        )


def _widen_responses():
    # Nothing refers to the answers' rows, so that copying them is safe.
    with op.batch_alter_table("responses") as batch:
        batch.add_column(sa.Column("part", sa.String(60), nullable=False, server_default="clips"))
        batch.add_column(
            sa.Column(
                "trial_type", sa.String(40), nullable=False, server_default="semantic_differential"
            )
        )
        batch.add_column(sa.Column("clips", JSON, nullable=True))
        batch.add_column(sa.Column("check", sa.String(60), nullable=True))
        batch.add_column(sa.Column("passed", sa.Boolean(), nullable=True))
        batch.alter_column("clip_id", existing_type=sa.String(64), nullable=True)
    with op.batch_alter_table("responses") as batch:
        batch.alter_column("part", server_default=None)
        batch.alter_column("trial_type", server_default=None)


def _carry_over():
    """Every study becomes its own first version, and keeps the hash that its answers name."""
    link = op.get_bind()
    studies = link.execute(
        sa.text("SELECT id, definition, definition_hash, created_at FROM studies")
    )
    for study, definition, known_hash, created_at in studies.all():
        version = link.execute(
            sa.text(
                "INSERT INTO study_versions"
                " (study_id, number, definition, definition_hash, changes, published_at)"
                " VALUES (:study, 1, :definition, :hash, '[]', :at) RETURNING id"
            ),
            {
                "study": study,
                "definition": json.dumps(_converted(_loaded(definition))),
                "hash": known_hash,
                "at": created_at,
            },
        ).scalar_one()
        link.execute(
            sa.text(
                "UPDATE sessions SET version_id = :version, source = 'open' WHERE study_id = :study"
            ),
            {"version": version, "study": study},
        )
    for session, plan in link.execute(sa.text("SELECT id, plan FROM sessions")).all():
        if plan is not None:
            link.execute(
                sa.text("UPDATE sessions SET plan = :plan WHERE id = :id"),
                {"plan": json.dumps(_planned(_loaded(plan))), "id": session},
            )


def _loaded(value):
    return json.loads(value) if isinstance(value, str) else value


def _converted(old):
    task = {"kind": "semantic_differential", **{name: old[name] for name in ASKED}}
    # No placeholder was an empty one.
    task["comment"] = {name: text for name, text in old["comment"].items() if text}
    part = {
        "kind": "trials",
        "id": "clips",
        "task": task,
        "stimuli": old["stimuli"],
        "practice": old["practice"],
    }
    kept = ("slug", "title", "welcome", "consent", "thanks", "contact")
    return {**{name: old[name] for name in kept}, "parts": [part]}


def _planned(old):
    steps = [
        {"part": "clips", "clips": [trial["clip"]], "practice": trial["practice"]}
        for trial in old["trials"]
    ]
    return {"steps": steps}


def _take_back():
    """Earlier versions of this server know one kind of study only; what is not of it goes."""
    op.add_column("studies", sa.Column("definition", JSON, nullable=True))
    op.add_column("studies", sa.Column("definition_hash", sa.String(64), nullable=True))
    op.execute("DELETE FROM responses")
    op.execute("DELETE FROM sessions")
    op.execute("DELETE FROM audit")
    op.execute("DELETE FROM study_members")
    op.execute("DELETE FROM study_versions")
    op.execute("DELETE FROM studies")
    with op.batch_alter_table("studies") as batch:
        batch.alter_column("definition", existing_type=JSON, nullable=False)
        batch.alter_column("definition_hash", existing_type=sa.String(64), nullable=False)
