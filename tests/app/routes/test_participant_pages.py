"""A participant without scripts: what the server itself says and keeps."""

import re

import pytest
from sqlalchemy import select

from app.persistence.models import Response, StudySession
from app.services import answers, sessions
from app.studies import emotion
from tests.support.simulate import add_study, answer_with
from tests.support.taking_part import NEUTRAL

WELCOME = f"/studies/{emotion.SLUG}"


@pytest.fixture
def database(client):
    database = client.app.state.database
    with database.writing() as db:
        add_study(db)
    return database


def csrf(page):
    return re.search(r'name="csrf_token" value="([^"]+)"', page.text).group(1)


@pytest.fixture
def token(client, database):
    page = client.get(WELCOME)
    form = {"csrf_token": csrf(page), "consent_version": "1", "agree": "yes"}
    answer = client.post(f"{WELCOME}/begin", data=form, headers={"User-Agent": "Mobile"})
    assert answer.status_code == 303
    return answer.headers["location"].removeprefix("/take/")


def session_rows(database):
    with database.reading() as db:
        return list(db.scalars(select(StudySession)))


def answer_all(database, token):
    with database.writing() as db:
        for index in range(22):
            answers.record(db, token, answer_with(NEUTRAL, index))
        code = sessions.complete(db, token).completion_code
        db.commit()
    return code


def test_the_welcome_page_says_what_is_asked_and_changes_nothing(client, database):
    page = client.get(WELCOME)
    assert page.status_code == 200
    for told in ("22 short clips", "What is kept", "How long", "Your right", "Who asks"):
        assert told in page.text
    assert session_rows(database) == []


def test_agreeing_begins_a_session_without_an_address_of_the_network(client, database, token):
    (session,) = session_rows(database)
    assert session.user_agent_class == "phone"
    assert session.consent_version == "1"
    stored = " ".join(str(getattr(session, c.key)) for c in StudySession.__table__.columns)
    assert "testclient" not in stored  # where the test's requests come from
    assert token not in stored
    page = client.get(f"/take/{token}")
    assert page.status_code == 200
    assert f'<manner-trial token="{token}"' in page.text


def test_without_the_tick_nothing_begins_and_the_page_says_so(client, database):
    page = client.get(WELCOME)
    form = {"csrf_token": csrf(page), "consent_version": "1"}
    answer = client.post(f"{WELCOME}/begin", data=form)
    assert answer.status_code == 422
    assert "tick the box" in answer.text
    assert session_rows(database) == []


def test_agreeing_to_an_older_text_asks_again(client, database):
    page = client.get(WELCOME)
    form = {"csrf_token": csrf(page), "consent_version": "0", "agree": "yes"}
    answer = client.post(f"{WELCOME}/begin", data=form)
    assert answer.status_code == 422
    assert "has changed" in answer.text
    assert session_rows(database) == []


@pytest.mark.parametrize("address", [f"{WELCOME}/begin", "/take/x/withdraw"])
def test_a_form_from_elsewhere_is_refused(client, database, address):
    answer = client.post(address, data={"consent_version": "1", "agree": "yes"})
    assert answer.status_code == 403
    assert session_rows(database) == []


def test_the_thanks_page_is_there_only_once_all_has_arrived(client, database, token):
    early = client.get(f"/take/{token}/thanks")
    assert (early.status_code, early.headers["location"]) == (303, f"/take/{token}")
    code = answer_all(database, token)
    late = client.get(f"/take/{token}")
    assert (late.status_code, late.headers["location"]) == (303, f"/take/{token}/thanks")
    thanks = client.get(f"/take/{token}/thanks")
    assert code in thanks.text
    assert "You judged 22 movements" in thanks.text


def test_withdrawing_asks_first_then_deletes_and_stays_so(client, database, token):
    code = answer_all(database, token)
    asking = client.get(f"/take/{token}/withdraw")
    assert "22 answers" in asking.text
    with database.reading() as db:
        assert len(db.scalars(select(Response)).all()) == 22
    done = client.post(f"/take/{token}/withdraw", data={"csrf_token": csrf(asking)})
    assert done.status_code == 200
    with database.reading() as db:
        assert db.scalars(select(Response)).all() == []
    assert [session.state for session in session_rows(database)] == ["withdrawn"]
    for address in (f"/take/{token}", f"/take/{token}/withdraw"):
        again = client.get(address)
        assert "Your answers are deleted" in again.text
        assert code not in again.text


def test_a_link_that_is_not_ours_is_an_error_page_that_helps(client, database):
    for address in ("/take/nobody", "/take/nobody/thanks", "/take/nobody/withdraw"):
        answer = client.get(address)
        assert answer.status_code == 404
        assert "personal link" in answer.text
    unknown = client.get("/studies/nothing")
    assert unknown.status_code == 404
    assert "no study" in unknown.text


def test_no_page_of_a_participant_names_a_clip(client, database, token):
    for address in (WELCOME, f"/take/{token}", f"/api/v1/sessions/{token}"):
        assert "acted_" not in client.get(address).text
