"""Participants who come from recruiting services, by personal links, and too late."""

from __future__ import annotations

import re
from html import unescape

import pytest
from sqlalchemy import select

from app.persistence.models import Study, StudySession
from app.services import answers, sessions
from app.services.recruiting import invitation
from tests.support.simulate import add_study, answer_with
from tests.support.taking_part import NEUTRAL

WELCOME = "/studies/emotion-in-walking"
PROLIFIC = {"PROLIFIC_PID": "p<1>", "STUDY_ID": "s1", "SESSION_ID": "x1"}
RUNNING = {
    "prolific": {"complete": "DONE1"},
    "sona": {"credit_url": "https://sona.example/credit?c={id}"},
    "mturk": {},
}


@pytest.fixture
def study(database):
    with database.writing() as db:
        add_study(db)
        db.scalars(select(Study)).one().running = RUNNING
        db.commit()


def run(database, **changes):
    with database.writing() as db:
        row = db.scalars(select(Study)).one()
        row.running = {**RUNNING, **changes}
        db.commit()


def agree(client, address):
    """Fill the welcome page's form in, as a browser sends it."""
    page = client.get(address)
    return client.post(f"{WELCOME}/begin", data=filled(page), follow_redirects=False)


def filled(page):
    fields = re.findall(r'<input type="hidden" name="([^"]+)" value="([^"]*)"', page.text)
    return {**{name: unescape(value) for name, value in fields}, "agree": "yes"}


def query(given):
    return "&".join(f"{name}={value}" for name, value in given.items())


def rows(database):
    with database.reading() as db:
        return db.scalars(select(StudySession)).all()


def finish(database, link):
    token = link.rsplit("/", 1)[1]
    with database.writing() as db:
        for index in range(22):
            answers.record(db, token, answer_with(NEUTRAL, index))
        sessions.complete(db, token)
        db.commit()


def test_prolific_participants_are_known_again_paid_and_forgotten_when_they_withdraw(
    client, database, study
):
    address = f"{WELCOME}?{query(PROLIFIC)}"
    begun = agree(client, address)
    (session,) = rows(database)
    assert (session.source, session.external) == ("prolific", PROLIFIC)
    again = client.get(address, follow_redirects=False)
    assert again.headers["location"] == begun.headers["location"]
    assert len(rows(database)) == 1

    finish(database, begun.headers["location"])
    thanks = client.get(f"{begun.headers['location']}/thanks")
    assert "https://app.prolific.com/submissions/complete?cc=DONE1" in thanks.text

    with database.writing() as db:
        sessions.withdraw(db, begun.headers["location"].rsplit("/", 1)[1])
        db.commit()
    (session,) = rows(database)
    assert (session.source, session.external) == (None, None)


def test_a_sona_participant_goes_back_with_the_own_number(client, database, study):
    begun = agree(client, f"{WELCOME}?id=77")
    finish(database, begun.headers["location"])
    thanks = client.get(f"{begun.headers['location']}/thanks")
    assert "https://sona.example/credit?c=77" in thanks.text


def test_who_looks_at_a_task_on_mturk_cannot_begin_before_accepting_it(client, database, study):
    looking = f"{WELCOME}?assignmentId=ASSIGNMENT_ID_NOT_AVAILABLE&hitId=h"
    page = client.get(looking)
    assert page.status_code == 200
    assert "/begin" not in page.text
    assert rows(database) == []
    accepted = agree(client, f"{WELCOME}?assignmentId=a&hitId=h&workerId=w")
    finish(database, accepted.headers["location"])
    code = rows(database)[0].completion_code
    assert code in client.get(f"{accepted.headers['location']}/thanks").text


def test_personal_links_lead_in_where_the_open_one_does_not(client, database, study):
    run(database, open_link=False)
    assert "/begin" not in client.get(WELCOME).text
    word = invitation(client.app.state.settings.signing_key, "emotion-in-walking", "p17")
    begun = agree(client, f"{WELCOME}?invite={word}")
    assert begun.status_code == 303
    assert rows(database)[0].source == "personal"
    broken = client.get(f"{WELCOME}?invite={word}x")
    assert broken.status_code == 422
    assert "Open the link exactly as you got it" in broken.text


def test_a_chat_program_that_opens_a_link_begins_nothing(client, database, study):
    for address in (WELCOME, f"{WELCOME}?{query(PROLIFIC)}"):
        assert client.get(address).status_code == 200
        assert client.head(address).status_code in (200, 405)
    assert rows(database) == []


def test_whoever_comes_when_all_places_are_taken_reads_so_and_can_begin_nothing(
    client, database, study
):
    run(database, quota=1)
    early = client.get(WELCOME)  # both read the page while there was a place
    assert agree(client, WELCOME).status_code == 303
    late = client.post(f"{WELCOME}/begin", data=filled(early))
    for page in (late, client.get(WELCOME)):
        assert "/begin" not in page.text
        assert "all the participants" in page.text
    assert len(rows(database)) == 1
