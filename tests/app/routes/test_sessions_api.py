"""What the participant's page and the server tell each other, over HTTP."""

import pytest
from sqlalchemy import func, select

from app.persistence.models import Response
from app.services import sessions
from tests.support.simulate import add_study, answer_with
from tests.support.taking_part import NEUTRAL, begin


@pytest.fixture
def database(client):
    return client.app.state.database


@pytest.fixture
def token(database):
    with database.writing() as db:
        add_study(db)
        token = begin(db)
        db.commit()
    return token


@pytest.fixture
def post(client, token):
    def send(values=NEUTRAL, index=0, revision=1, **changes):
        body = answer_with(values, index, revision).model_dump(mode="json") | changes
        return client.post(f"/api/v1/sessions/{token}/responses", json=body)

    return send


def rows(database):
    with database.reading() as db:
        return db.scalar(select(func.count()).select_from(Response))


def test_the_session_tells_all_that_the_page_needs(client, token):
    told = client.get(f"/api/v1/sessions/{token}").json()
    assert set(told) == {"study", "state", "parts", "steps", "responses", "next"}
    assert set(told["study"]) == {"title", "language", "languages", "back", "preview"}
    (part,) = told["parts"].values()
    assert part["kind"] == "semantic_differential"
    assert {part["scales"][0][name] for name in ("id", "left", "right")} == {
        "sad_happy", "sad", "happy",
    }  # fmt: skip
    assert part["steps"] == ["very", "rather", "neither", "rather", "very"]
    assert set(told["steps"][0]) == {
        "index", "part", "kind", "figures", "reference", "instruction", "scales",
        "interface", "seen",
    }  # fmt: skip
    assert set(told["steps"][0]["figures"][0]) == {"glb_url", "figure_url", "cyclic", "caption"}
    assert [step["index"] for step in told["steps"]] == list(range(22))
    assert (told["state"], told["responses"], told["next"]) == ("active", {}, 0)


def test_an_answer_is_acknowledged_with_201_and_the_same_again_with_200_and_the_same_body(
    post, database
):
    first = post(NEUTRAL | {"sad_happy": -1})
    again = post(NEUTRAL | {"sad_happy": -1})
    assert (first.status_code, again.status_code) == (201, 200)
    assert again.json() == first.json()
    assert set(first.json()) == {"trial_index", "revision", "received_at", "state"}
    assert rows(database) == 1


def test_another_answer_under_the_same_revision_is_409_with_what_is_stored(post, database):
    post(comment="limps")
    other = post(NEUTRAL | {"sad_happy": 2})
    assert other.status_code == 409
    error = other.json()["error"]
    assert error["code"] == "already_answered"
    assert error["stored"]["answers"] == NEUTRAL
    assert error["stored"]["comment"] == "limps"
    assert rows(database) == 1


def test_a_changed_answer_is_a_new_revision_that_a_reload_shows(post, client, token):
    post()
    assert (
        post(NEUTRAL | {"sad_happy": 2}, revision=2, comment="on second thought").status_code == 201
    )
    told = client.get(f"/api/v1/sessions/{token}").json()
    assert told["responses"]["0"] == {
        "revision": 2,
        "answers": NEUTRAL | {"sad_happy": 2},
        "touched": sorted(NEUTRAL),
        "comment": "on second thought",
    }
    assert told["next"] == 1


def test_completing_too_early_is_409_and_names_what_is_missing(post, client, token):
    for index in range(21):
        post(index=index)
    early = client.post(f"/api/v1/sessions/{token}/complete")
    assert early.status_code == 409
    assert early.json()["error"]["code"] == "answers_missing"
    assert early.json()["error"]["where"] == {"missing": [21]}
    post(index=21)
    done = client.post(f"/api/v1/sessions/{token}/complete")
    assert done.status_code == 200
    assert done.json()["state"] == "complete"
    assert done.json()["answers"] == 22
    assert client.post(f"/api/v1/sessions/{token}/complete").json() == done.json()


@pytest.mark.parametrize(
    "changes",
    [
        {"answers": NEUTRAL | {"sad_happy": 3}},
        {"answers": {}},
        {"answers": NEUTRAL | {"sad_happy": "much"}},
        {"trial_index": 22},
        {"trial_index": -1},
        {"revision": 0},
        {"rt_ms": -5},
        {"client_time": "2026-03-01T12:00:00"},
        {"mood": "good"},
        {"comment": "x" * 5001},
    ],
)
def test_what_makes_no_sense_is_422_and_not_stored(client, token, database, changes):
    body = answer_with(NEUTRAL).model_dump(mode="json") | changes
    answer = client.post(f"/api/v1/sessions/{token}/responses", json=body)
    assert answer.status_code == 422
    assert answer.json()["error"]["mend"]
    assert rows(database) == 0


def test_numbers_that_are_none_are_refused(client, token):
    body = answer_with(NEUTRAL).model_dump_json().replace("5210.5", "NaN")
    answer = client.post(
        f"/api/v1/sessions/{token}/responses",
        content=body,
        headers={"Content-Type": "application/json"},
    )
    assert answer.status_code == 422


@pytest.mark.parametrize(
    "start", ['"a": NaN', '"a": Infinity', '"a": 101', '"\\u0000": 1', f'"{"x" * 100_000}": 1']
)
def test_where_a_slider_stood_is_a_place_on_it_under_a_name(client, token, start, database):
    body = answer_with(NEUTRAL).model_dump_json().replace('"start":null', f'"start":{{{start}}}')
    assert start in body
    answer = client.post(
        f"/api/v1/sessions/{token}/responses",
        content=body,
        headers={"Content-Type": "application/json"},
    )
    assert answer.status_code == 422
    assert rows(database) == 0


def test_half_a_character_in_a_comment_does_not_cost_the_answer(client, token, database):
    body = answer_with(NEUTRAL, comment="HERE").model_dump_json().replace("HERE", "\\ud83d \\u0000")
    answer = client.post(
        f"/api/v1/sessions/{token}/responses",
        content=body,
        headers={"Content-Type": "application/json"},
    )
    assert answer.status_code == 201
    with database.reading() as db:
        assert db.scalars(select(Response.comment)).one() == "? "


def test_a_withdrawn_session_takes_no_answer(post, database, token, client):
    with database.writing() as db:
        sessions.withdraw(db, token)
        db.commit()
    assert post().status_code == 409
    assert post().json()["error"]["code"] == "session_withdrawn"
    assert client.get(f"/api/v1/sessions/{token}").json()["state"] == "withdrawn"
    assert rows(database) == 0


def test_an_unknown_token_is_404_everywhere(client, token):
    body = answer_with(NEUTRAL).model_dump(mode="json")
    for answer in (
        client.get("/api/v1/sessions/nobody"),
        client.post("/api/v1/sessions/nobody/responses", json=body),
        client.post("/api/v1/sessions/nobody/complete"),
    ):
        assert answer.status_code == 404
        assert answer.json()["error"]["code"] == "session_not_found"


def test_answers_handed_in_at_shutdown_are_stored(settings, built):
    from starlette.testclient import TestClient

    from app.main import create_app
    from app.persistence.engine import Database, make_engine
    from app.services import answers

    app = create_app(settings, built)
    with TestClient(app):
        database, writer = app.state.database, app.state.writer
        with database.writing() as db:
            add_study(db)
        token = writer.write(begin)
        promises = [
            writer.submit(lambda db, i=i: answers.record(db, token, answer_with(NEUTRAL, i)))
            for i in range(22)
        ]
    assert all(promise.done() for promise in promises)
    engine = make_engine(settings.database)
    assert rows(Database(engine)) == 22
    engine.dispose()
