"""The page of API keys: made, shown once, revoked."""

from __future__ import annotations

import html
import re

import pytest
from starlette.testclient import TestClient

from tests.app.conftest import Researching

PAGE = "/research/keys"


def make_key(signed_in: Researching, scope: str = "read", name: str = "notebook") -> str:
    """A fresh key, read off the page that shows it."""
    response = post(signed_in, PAGE, name=name, scope=scope)
    assert response.status_code == 201
    (key,) = set(re.findall(r"mnr_[\w-]{43}", response.text))
    return key


def post(signed_in: Researching, path: str, **form: str):
    return signed_in.client.post(path, data=form, headers=signed_in.headers)


def key_number(page: str) -> str:
    return re.findall(rf"{PAGE}/(\d+)/revoke", page)[0]


def test_a_key_is_shown_once_and_never_again(signed_in: Researching) -> None:
    key = make_key(signed_in)
    page = signed_in.client.get(PAGE).text
    assert key not in page
    assert f"mnr_…{key[-4:]}" in page
    assert "notebook" in page
    assert "not used yet" in page


def test_the_answer_that_shows_a_key_is_kept_nowhere(signed_in: Researching) -> None:
    response = post(signed_in, PAGE, name="notebook", scope="read")
    assert response.headers["cache-control"] == "no-store"
    assert "location" not in response.headers


def test_the_shown_call_works_as_it_stands(signed_in: Researching) -> None:
    page = html.unescape(post(signed_in, PAGE, name="notebook", scope="read").text)
    header, address = re.search(r'curl -H "([^"]+)" "([^"]+)"', page).groups()
    stranger = signed_in.client
    stranger.cookies.clear()
    name, _, value = header.partition(": ")
    assert stranger.get(address, headers={name: value}).status_code == 200
    assert stranger.get(address, headers={name: value + "x"}).status_code == 401


def test_a_revoked_key_is_refused_and_stays_on_the_page(signed_in: Researching) -> None:
    key = make_key(signed_in)
    page = signed_in.client.get(PAGE).text
    response = post(signed_in, f"{PAGE}/{key_number(page)}/revoke")
    assert (response.status_code, response.headers["location"]) == (303, PAGE)
    refused = signed_in.client.get("/api/v1/clips", headers={"Authorization": f"Bearer {key}"})
    assert refused.status_code == 401
    after = signed_in.client.get(PAGE).text
    assert f"mnr_…{key[-4:]}" in after
    assert "/revoke" not in after


@pytest.mark.parametrize("path", [PAGE, f"{PAGE}/1/revoke"])
def test_making_and_revoking_need_the_token_against_forgery(
    signed_in: Researching, path: str
) -> None:
    form = {"name": "notebook", "scope": "write"}
    assert signed_in.client.post(path, data=form).status_code == 403
    assert "mnr_" not in signed_in.client.get(PAGE).text


def test_strangers_are_led_to_the_sign_in_page(client: TestClient) -> None:
    response = client.get(PAGE)
    assert response.status_code == 303
    assert "sign-in" in response.headers["location"]


def test_a_key_does_not_open_pages_nor_make_keys(signed_in: Researching) -> None:
    key = {"Authorization": f"Bearer {make_key(signed_in, 'write')}"}
    client = signed_in.client
    client.cookies.clear()
    for page in (PAGE, "/research", "/research/results"):
        assert client.get(page, headers=key).status_code == 303
    made = client.post(PAGE, data={"name": "more", "scope": "write"}, headers=key)
    assert made.status_code in (303, 403)
    assert "mnr_" not in made.text


def test_a_name_is_shown_as_text_and_an_empty_one_is_refused(signed_in: Researching) -> None:
    make_key(signed_in, name="<script>alert(1)</script>")
    assert "<script>alert" not in signed_in.client.get(PAGE).text
    refused = post(signed_in, PAGE, name="  ", scope="write")
    assert refused.status_code == 422
    assert "needs a name" in refused.text
    assert 'value="write" checked' in refused.text


def test_no_key_reaches_the_log(signed_in: Researching, capsys: pytest.CaptureFixture[str]) -> None:
    key = make_key(signed_in)
    bearer = {"Authorization": f"Bearer {key}"}
    for path in ("/api/v1/clips", f"/api/v1/clips/{key}", f"/nowhere?key={key}"):
        signed_in.client.get(path, headers=bearer)
    text = capsys.readouterr().err
    assert "/api/v1/clips" in text
    assert key not in text
