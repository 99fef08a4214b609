"""A participant's pages in three languages: what the server says without scripts."""

import json
import re
from html import unescape

import pytest

from app import i18n, messages
from app.persistence.models import ClipRecord
from tests.support.published import add_published
from tests.support.simulate import add_study
from tests.support.three_languages import HEADINGS, SLUG, THANKS, three_languages

LANGUAGES = pytest.mark.parametrize("language", ["en", "fi", "ja"])
WELCOME = f"/studies/{SLUG}"
PROLIFIC = {"complete": "DONE1", "screened_out": "OUT2"}
FROM = {
    "prolific": "PROLIFIC_PID=ada&STUDY_ID=s&SESSION_ID=x",
    "sona": "id=77%26",
    "mturk": "workerId=w&assignmentId=a",
}


@pytest.fixture
def database(client):
    database = client.app.state.database
    with database.writing() as db:
        add_study(db)
    return database


@pytest.fixture
def open_study(database):
    """Publishes the study with these settings."""

    def publish(state="open", **running):
        with database.writing() as db:
            clips = [clip.id for clip in db.query(ClipRecord).order_by(ClipRecord.name).limit(2)]
            add_published(db, three_languages(clips), state, **running)
            db.commit()

    return publish


def shown(page):
    """What the page says, as one line."""
    body = re.sub(r"<script.*?</script>|<[^>]+>", " ", page.text, flags=re.S)
    return " ".join(unescape(body).split())


def begin(client, language, query=""):
    page = client.get(f"{WELCOME}?lang={language}&{query}")
    hidden = re.findall(r'<input type="hidden" name="([^"]+)" value="([^"]*)"', page.text)
    form = {name: unescape(value) for name, value in hidden} | {"agree": "yes"}
    answer = client.post(f"{WELCOME}/begin", data=form)
    assert answer.status_code == 303, answer.text
    return answer.headers["location"].removeprefix("/take/")


def answer_all(client, token, sees="yes"):
    """Answers every step over the API; stops where the study ends early."""
    api = f"/api/v1/sessions/{token}"
    for step in client.get(api).json()["steps"]:
        answers = {"sees": sees} if step["kind"] == "form" else {"sad_happy": 1}
        sent = {
            "trial_index": step["index"], "revision": 1, "answers": answers, "touched": [],
            "rt_ms": 9, "time_elapsed_ms": 9, "client_time": "2026-01-01T00:00Z", "record": {},
        }  # fmt: skip
        answer = client.post(f"{api}/responses", json=sent)
        assert answer.status_code == 201, answer.text
        if answer.json()["state"] != "active":
            return
    assert client.post(f"{api}/complete").status_code == 200


def test_the_page_comes_in_the_browsers_language_unless_one_was_chosen(client, open_study):
    open_study()
    finnish = {"Accept-Language": "fi-FI,fi;q=0.9,en;q=0.5"}
    assert HEADINGS["fi"] in client.get(WELCOME, headers=finnish).text
    assert HEADINGS["ja"] in client.get(f"{WELCOME}?lang=ja", headers=finnish).text
    assert HEADINGS["en"] in client.get(WELCOME, headers={"Accept-Language": "sv"}).text


def test_the_languages_can_be_chosen_and_what_a_service_sent_comes_along(client, open_study):
    open_study(prolific=PROLIFIC)
    page = client.get(f"{WELCOME}?lang=fi&{FROM['prolific']}").text
    nav = re.search(r"<nav.*?</nav>", page, re.S).group()
    links = re.findall(r'href="([^"]+)" lang="(\w\w)"', nav)
    assert [language for _, language in links] == ["en", "fi", "ja"]
    assert re.search(r'lang="fi" hreflang="fi" aria-current="true">Suomi</a>', nav)
    assert nav.count("aria-current") == 1
    for link, language in links:
        there = client.get(unescape(link)).text
        assert f'<html lang="{language}"' in there
        assert 'name="PROLIFIC_PID" value="ada"' in there


@LANGUAGES
def test_the_language_stays_with_the_session_whatever_the_browser_says(
    client, open_study, language
):
    open_study()
    token = begin(client, language)
    for address in (f"/take/{token}", f"/take/{token}/withdraw"):
        page = client.get(address, headers={"Accept-Language": "sv,fi;q=0.1"})
        assert f'<html lang="{language}"' in page.text
    assert client.get(f"/api/v1/sessions/{token}").json()["study"]["language"] == language
    answer_all(client, token)
    assert THANKS[language] in client.get(f"/take/{token}/thanks").text


@pytest.mark.parametrize("language", i18n.TRANSLATED)
def test_no_page_of_a_participant_says_anything_in_english(client, open_study, language):
    open_study()
    token = begin(client, language)
    pages = [
        client.get(f"{WELCOME}?lang={language}"),
        client.post(f"{WELCOME}/begin", headers={"Accept-Language": language}),
        client.get(f"/no-webgl?lang={language}"),
        client.get(f"/take/unknown?lang={language}"),
        client.get(f"/studies/unknown?lang={language}"),
        client.get(f"/take/{token}"),
        client.get(f"/take/{token}/withdraw"),
    ]
    answer_all(client, token)
    pages.append(client.get(f"/take/{token}/thanks"))
    english = [
        text for message in messages.collect() if message.id
        for text in ([message.id] if isinstance(message.id, str) else message.id)
        if len(text) > 3 and "{" not in text
    ]  # fmt: skip
    for page in pages:
        assert f'<html lang="{language}"' in page.text
        assert [text for text in english if text in shown(page)] == []


def test_scripts_get_their_words_in_finnish_and_need_none_in_english(client, open_study):
    open_study()
    finnish = client.get(f"/take/{begin(client, 'fi')}").text
    english = client.get(f"/take/{begin(client, 'en')}").text
    block = re.search(r'<script type="application/json" id="words">(.*?)</script>', finnish).group(
        1
    )
    assert json.loads(block) == i18n.phrases("fi").for_scripts
    assert 'id="words"' not in english


def test_only_japanese_pages_bring_the_japanese_font(client, open_study):
    open_study()
    assert "japanese" in client.get(f"{WELCOME}?lang=ja").text
    assert "assets/japanese" not in client.get(f"{WELCOME}?lang=fi").text
    assert "assets/japanese" not in client.get(WELCOME).text


def test_the_api_answers_a_participant_in_the_pages_language_and_others_in_english(client):
    finnish = {"Accept-Language": "fi"}
    error = client.get("/api/v1/sessions/nobody", headers=finnish).json()["error"]
    assert error["code"] == "session_not_found"
    assert error["message"] == "Tätä henkilökohtaista linkkiä ei tunneta täällä."
    assert error["mend"] == "Avaa linkki täsmälleen sellaisena kuin sait sen."
    english = client.get("/api/v1/sessions/nobody").json()["error"]
    assert english["message"] == "This personal link is not known here."
    research = client.get("/api/v1/studies", headers=finnish).json()["error"]
    assert research["message"] == "This needs an API key."


@pytest.mark.parametrize(
    ("reason", "said"),
    [
        ({"state": "paused"}, "Tämä tutkimus on tauolla."),
        ({"state": "closed"}, "Tämä tutkimus on suljettu."),
        ({"opens_at": "2100-03-01T18:05:00+00:00"}, "Tämä tutkimus ei ole vielä auki."),
        ({"closes_at": "2000-03-01T18:05:00+00:00"}, "Tämä tutkimus on suljettu."),
        ({"open_link": False}, "Tähän tutkimukseen tarvitaan henkilökohtainen linkki."),
    ],
    ids=["paused", "closed", "too early", "too late", "by invitation"],
)
def test_a_study_that_takes_nobody_says_why(client, open_study, reason, said):
    open_study(**reason)
    page = client.get(f"{WELCOME}?lang=fi")
    assert said in shown(page)
    assert "<form" not in page.text
    if "opens_at" in reason:
        assert '<time datetime="2100-03-01T18:05:00+00:00" data-local>' in page.text
        assert "1. maaliskuuta 2100" in page.text


def test_a_full_study_says_so(client, open_study):
    open_study(quota=1)
    begin(client, "en")
    assert "この調査は定員に達しました。" in shown(client.get(f"{WELCOME}?lang=ja"))


@LANGUAGES
@pytest.mark.parametrize(
    ("sees", "code"), [("yes", "DONE1"), ("no", "OUT2")],
    ids=["complete", "screened out"],
)  # fmt: skip
def test_prolific_is_returned_to_with_the_outcomes_code(client, open_study, language, sees, code):
    open_study(prolific=PROLIFIC)
    token = begin(client, language, FROM["prolific"])
    answer_all(client, token, sees)
    page = client.get(f"/take/{token}/thanks").text
    assert f'<output id="code">{code}</output>' in page
    address = f"https://app.prolific.com/submissions/complete?cc={code}"
    assert f'<a class="button primary" href="{address}">' in page
    assert (THANKS[language] in page) == (sees == "yes")


def test_who_is_screened_out_without_a_code_is_asked_to_return_the_submission(client, open_study):
    open_study(prolific={"complete": "DONE1"})
    token = begin(client, "en", FROM["prolific"])
    answer_all(client, token, "no")
    page = client.get(f"/take/{token}/thanks")
    assert "Please return your submission on Prolific." in shown(page)
    assert "DONE1" not in page.text


def test_sona_gets_its_credit_address_and_mturk_a_code_to_hand_in(client, open_study):
    open_study(sona={"credit_url": "https://uni.example/credit?id={id}"}, mturk={})
    token = begin(client, "en", FROM["sona"])
    answer_all(client, token)
    assert (
        'href="https://uni.example/credit?id=77%26">Get my credit'
        in client.get(f"/take/{token}/thanks").text
    )
    token = begin(client, "en", FROM["mturk"])
    answer_all(client, token)
    page = client.get(f"/take/{token}/thanks")
    assert re.search(r'<output id="code">MNR-', page.text)
    assert "Enter this code on the task’s page at MTurk." in shown(page)


def test_an_mturk_worker_who_only_looks_is_told_to_accept_first(client, open_study):
    open_study(mturk={})
    page = client.get(f"{WELCOME}?lang=ja&assignmentId=ASSIGNMENT_ID_NOT_AVAILABLE")
    assert "これはプレビューです。" in shown(page)
    assert "<form" not in page.text


def test_a_preview_speaks_the_language_that_is_looked_at(client, open_study, signed_in):
    open_study()
    preview = f"/research/studies/{SLUG}/preview"
    assert '<html lang="fi"' in client.get(f"{preview}?language=fi").text
    assert "最初の動きを読み込んでいます。" in shown(client.get(f"{preview}?language=ja"))
