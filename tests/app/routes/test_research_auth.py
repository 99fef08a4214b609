"""Accounts: made by a one-time link, entered by a password."""

from __future__ import annotations

from datetime import timedelta

import pytest
from sqlalchemy import select
from starlette.testclient import TestClient

from app.persistence.engine import Database
from app.persistence.models import Researcher, SetupToken, now
from app.services import researchers
from tests.app.conftest import EMAIL, PASSWORD, Researching, csrf_token

ACCOUNT = {"email": "Ada@Example.org", "name": "Ada", "password": PASSWORD}


@pytest.fixture
def link(database: Database) -> str:
    with database.writing() as db:
        return researchers.make_setup_link(db, "")


def make_account(client: TestClient, link: str, **changes: str) -> int:
    form = ACCOUNT | changes | {"csrf_token": csrf_token(client)}
    return client.post(link, data=form).status_code


def is_signed_in(client: TestClient) -> bool:
    return client.get("/research").status_code == 200


def test_the_set_up_link_makes_an_account_and_signs_in(client: TestClient, link: str) -> None:
    assert client.get(link).status_code == 200
    assert make_account(client, link) == 303
    assert is_signed_in(client)


def test_the_link_works_once(client: TestClient, link: str) -> None:
    make_account(client, link)
    assert client.get(link).status_code == 404
    assert make_account(client, link, email="eve@example.org") == 404


def test_the_link_gets_old(client: TestClient, link: str, database: Database) -> None:
    with database.writing() as db:
        db.scalars(select(SetupToken)).one().created_at = now() - timedelta(days=4)
        db.commit()
    assert client.get(link).status_code == 404


def test_a_guessed_link_leads_nowhere(client: TestClient, link: str) -> None:
    assert client.get("/research/set-up/guess").status_code == 404


@pytest.mark.parametrize("wrong", [{"password": "too short"}, {"email": "ada"}, {"name": " "}])
def test_a_refused_form_keeps_the_link_and_what_was_typed(
    client: TestClient, link: str, wrong: dict[str, str]
) -> None:
    assert make_account(client, link, **wrong) == 422
    assert make_account(client, link) == 303


def test_no_secret_is_stored_as_it_is(client: TestClient, link: str, database: Database) -> None:
    make_account(client, link)
    with database.reading() as db:
        account = db.scalars(select(Researcher)).one()
        token = db.scalars(select(SetupToken)).one()
    assert account.password_hash.startswith("$argon2id$")
    assert link.rpartition("/")[2] not in token.token_hash
    assert account.email == "ada@example.org"


def test_an_address_signs_in_whatever_its_case(client: TestClient, link: str) -> None:
    make_account(client, link)
    client.cookies.clear()
    form = {"email": "ADA@example.ORG ", "password": PASSWORD, "csrf_token": csrf_token(client)}
    response = client.post("/research/sign-in", data=form)
    assert response.headers["location"] == "/research"
    assert is_signed_in(client)


def test_a_refusal_does_not_tell_which_of_the_two_is_wrong(
    client: TestClient, researcher: str
) -> None:
    token = csrf_token(client)
    answers = []
    for email, password in ((researcher, "wrong wrong wrong"), ("x@example.org", PASSWORD)):
        form = {"email": email, "password": password, "csrf_token": token}
        response = client.post("/research/sign-in", data=form)
        assert response.status_code == 422
        answers.append("do not fit together" in response.text)
    assert answers == [True, True]
    assert not is_signed_in(client)


def test_signing_out_ends_it(signed_in: Researching) -> None:
    client = signed_in.client
    assert is_signed_in(client)
    form = {"csrf_token": csrf_token(client, "/library")}
    assert client.post("/research/sign-out", data=form).status_code == 303
    assert not is_signed_in(client)


def test_a_new_password_ends_earlier_sign_ins(signed_in: Researching, database: Database) -> None:
    with database.writing() as db:
        researchers.reset_password(db, EMAIL, "another four plain words")
    assert not is_signed_in(signed_in.client)


def test_a_forged_cookie_is_no_sign_in(client: TestClient, researcher: str) -> None:
    client.cookies.set("manner_researcher", "WzEsImFiYyJd.aaaaaa.bbbbbb")
    assert not is_signed_in(client)


def test_who_must_sign_in_comes_back_to_the_page(client: TestClient, researcher: str) -> None:
    asked = client.get("/research/results")
    assert asked.headers["location"] == "/research/sign-in?next=/research/results"
    form = {
        "email": researcher,
        "password": PASSWORD,
        "next": "/research/results",
        "csrf_token": csrf_token(client),
    }
    assert client.post("/research/sign-in", data=form).headers["location"] == "/research/results"


def test_the_page_comes_back_with_all_that_was_chosen_on_it(
    client: TestClient, researcher: str
) -> None:
    page = "/research/studies/emotion?against=all&more=1"
    form_page = client.get(client.get(page).headers["location"])
    assert f'name="next" value="{page.replace("&", "&amp;")}"' in form_page.text


@pytest.mark.parametrize("lure", ["https://evil.example", "//evil.example", "/\\evil.example"])
def test_no_link_lures_to_another_server(client: TestClient, researcher: str, lure: str) -> None:
    form = {
        "email": researcher,
        "password": PASSWORD,
        "next": lure,
        "csrf_token": csrf_token(client),
    }
    assert client.post("/research/sign-in", data=form).headers["location"] == "/research"
