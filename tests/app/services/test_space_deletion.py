"""Which spaces can be deleted, by whom, and who is told what of them."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest
from sqlalchemy import Engine

from app.errors import ConflictError, ForbiddenError, NotFoundError
from app.persistence.engine import Database
from app.persistence.models import Researcher, Study, StudyMember, StudyVersion
from app.schemas.spaces import SpaceDefinition
from app.services import audit, new_spaces, samples, space_deletion, spaces
from app.services.space_clips import Source
from app.services.space_making import define
from motion.storage import clip_to_bytes
from tests.support.motions import walks

OWNER, EDITOR, VIEWER, STRANGER = 1, 2, 3, 4
ROLES = {OWNER: "owner", EDITOR: "editor", VIEWER: "viewer"}
STUDY = 1


@pytest.fixture
def database(engine: Engine) -> Database:
    """Four researchers; three of them have a study, which names no space."""
    database = Database(engine)
    samples.make(database, walks)
    with database.writing() as db:
        for number, name in enumerate(("Ada", "Ben", "Cleo", "Dan"), start=1):
            db.add(Researcher(id=number, email=f"{name}@x.org", name=name, password_hash=""))
        db.add(Study(id=STUDY, slug="gaits", title="Gaits at dawn", draft={}))
        db.flush()
        db.add_all(
            StudyMember(study_id=STUDY, researcher_id=who, role=role) for who, role in ROLES.items()
        )
        db.commit()
    return database


@cache
def defined() -> SpaceDefinition:
    of = [Source(w.clip.content_hash, w.name, clip_to_bytes(w.clip)) for w in walks()]
    return define("Walks", of, {})


def kept(
    database: Database,
    number: int = 1,
    study_id: int | None = None,
    made_by: int | None = OWNER,
) -> str:
    """The id of one more version of the space."""
    origin = defined().origin.model_copy(update={"note": f"Number {number}."})
    with database.writing() as db:
        version = defined().model_copy(update={"origin": origin})
        line = new_spaces.keep(db, version, study_id=study_id, made_by=made_by)
        db.commit()
    assert line.number == number
    return line.id


def delete(database: Database, space: str, who: int, versions: Any = "one") -> None:
    with database.writing() as db:
        space_deletion.delete(db, space, versions, who)


def left(database: Database, who: int = OWNER) -> list[int]:
    """The numbers of the versions that are still there."""
    with database.reading() as db:
        return [space.number for space in spaces.listed(db, who).spaces]


def named_by(database: Database, reference: str, kind: str) -> None:
    """Have the study name a space: to match in, or to make a stimulus."""
    task = {"kind": "match", "space": reference}
    stimulus = {"made": {"space": reference, "values": {}}}
    content = {"parts": [{"task": task} if kind == "task" else {"stimuli": [stimulus]}]}
    with database.writing() as db:
        db.get_one(Study, STUDY).draft = content
        db.commit()


def publish(database: Database) -> None:
    """The draft becomes a version."""
    with database.writing() as db:
        study = db.get_one(Study, STUDY)
        db.add(StudyVersion(study_id=STUDY, number=1, definition=study.draft, definition_hash="0"))
        study.draft = None
        db.commit()


@pytest.mark.parametrize(
    ("study_id", "made_by", "allowed"),
    [
        (None, OWNER, {OWNER, EDITOR, VIEWER, STRANGER}),  # of clips, which are everybody's
        (STUDY, OWNER, {OWNER, EDITOR}),
        (STUDY, VIEWER, {OWNER, EDITOR, VIEWER}),  # who made it may take it back
        (None, None, set()),  # it comes with the server
    ],
)
def test_a_space_is_deleted_by_whom_it_concerns(
    database: Database, study_id: int | None, made_by: int | None, allowed: set[int]
) -> None:
    for who in (OWNER, EDITOR, VIEWER, STRANGER):
        space = kept(database, study_id=study_id, made_by=made_by)
        with database.reading() as db:
            (listed,) = spaces.listed(db, who).spaces
        assert listed.may_delete == (who in allowed)
        if who in allowed:
            delete(database, space, who)
            assert left(database) == []
            continue
        with pytest.raises((ConflictError, ForbiddenError)) as refused:
            delete(database, space, who)
        assert refused.value.code == ("sample_space" if made_by is None else "role_too_low")
        assert left(database) == [1]


def test_the_studys_title_is_told_to_its_members_only(database: Database) -> None:
    kept(database, study_id=STUDY)
    for who, title in ((VIEWER, "Gaits at dawn"), (STRANGER, None)):
        with database.reading() as db:
            assert [one.study_title for one in spaces.listed(db, who).spaces] == [title]


@pytest.mark.parametrize("kind", ["task", "stimulus"])
def test_what_a_draft_names_stays_until_it_is_taken_out(database: Database, kind: str) -> None:
    first, second = kept(database, 1), kept(database, 2)
    named_by(database, second, kind)
    with pytest.raises(ConflictError) as refused:
        delete(database, second, OWNER)
    assert refused.value.code == "space_in_use"
    assert refused.value.message == ("“Walks”, version 2, is used by the study “Gaits at dawn”.")
    assert refused.value.where == {"studies": ["gaits"]}
    assert refused.value.mend == "Take it out of the draft first."
    with pytest.raises(ConflictError):
        delete(database, first, OWNER, "all")
    assert left(database) == [2, 1]
    with pytest.raises(ConflictError, match="by a study of others"):
        delete(database, second, STRANGER)
    delete(database, first, OWNER)
    named_by(database, "Another", kind)
    delete(database, second, OWNER)
    assert left(database) == []


def test_a_name_stands_for_the_newest_version(database: Database) -> None:
    first, second = kept(database, 1), kept(database, 2)
    named_by(database, "Walks", "task")
    with pytest.raises(ConflictError):
        delete(database, second, OWNER)
    delete(database, first, OWNER)
    assert left(database) == [2]


def test_what_was_published_stays_whatever_the_draft_says_now(database: Database) -> None:
    space = kept(database)
    named_by(database, space, "stimulus")
    publish(database)
    named_by(database, "Another", "stimulus")
    with pytest.raises(ConflictError) as refused:
        delete(database, space, OWNER)
    assert "published" in str(refused.value.mend)
    assert left(database) == [1]


def test_all_versions_go_together_or_none_does(database: Database) -> None:
    newest = [kept(database, number, made_by=made_by) for number, made_by in ((1, None), (2, 1))][1]
    with pytest.raises(ConflictError):
        delete(database, newest, OWNER, "all")
    assert left(database) == [2, 1]
    delete(database, newest, OWNER)
    others = [kept(database, number, study_id=STUDY) for number in (2, 3)]
    with pytest.raises(ForbiddenError) as refused:
        delete(database, others[0], VIEWER, "all")
    assert refused.value.mend == "Ask Ada, who made it."
    with pytest.raises(NotFoundError):
        delete(database, newest[::-1], OWNER)


def test_the_studys_history_tells_of_it(database: Database) -> None:
    space = kept(database, study_id=STUDY)
    delete(database, space, EDITOR, "all")
    with database.reading() as db:
        (line,) = audit.trail(db, STUDY).entries
    assert line.who == "Ben"
    assert line.sentence == "deleted the authoring space “Walks”, version 1"
