"""One shape of error."""

from __future__ import annotations

from pathlib import Path

import pytest
from starlette.testclient import TestClient

from app import errors
from app.main import create_app
from app.settings import Settings
from tests.app.conftest import Researching, csrf_token

DETAILED = errors.ConflictError(
    "It is taken.", code="taken", where={"line": 3}, mend="Take another.", extra={"offer": "b"}
)


@pytest.fixture
def faulty_client(settings: Settings, built: Path) -> TestClient:
    app = create_app(settings, built)

    def fail() -> None:
        raise DETAILED

    def break_down() -> None:
        raise RuntimeError("secret detail")

    def answer_number(number: int) -> int:
        return number

    for prefix in ("/api/v1", "/page"):
        app.get(f"{prefix}/fail")(fail)
        app.get(f"{prefix}/break")(break_down)
        app.get(f"{prefix}/number")(answer_number)
    return TestClient(app)


def test_the_api_tells_code_message_place_and_mend(faulty_client: TestClient) -> None:
    response = faulty_client.get("/api/v1/fail")
    assert response.status_code == 409
    assert response.json() == {
        "error": {
            "code": "taken",
            "message": "It is taken.",
            "where": {"line": 3},
            "mend": "Take another.",
            "offer": "b",
        }
    }


@pytest.mark.parametrize(
    ("path", "status", "code"),
    [
        ("/api/v1/nothing", 404, "not_found"),
        ("/api/v1/number?number=x", 422, "invalid_request"),
        ("/api/v1/break", 500, "internal"),
        ("/api/v1/fail", 409, "taken"),
    ],
)
def test_every_failure_of_the_api_has_the_one_shape(
    faulty_client: TestClient, path: str, status: int, code: str
) -> None:
    response = faulty_client.get(path)
    assert response.status_code == status
    error = response.json()["error"]
    assert {"code", "message", "where", "mend"} <= set(error)
    assert error["code"] == code
    assert response.headers["content-type"] == "application/json"


def test_a_wrong_field_is_named_without_repeating_what_was_sent(faulty_client: TestClient) -> None:
    error = faulty_client.get("/api/v1/number?number=private").json()["error"]
    assert error["where"]["fields"][0]["field"] == "number"
    assert "private" not in str(error)


@pytest.mark.parametrize(("path", "status"), [("/nothing", 404), ("/page/fail", 409)])
def test_a_page_says_what_is_wrong_and_leads_on(
    faulty_client: TestClient, path: str, status: int
) -> None:
    response = faulty_client.get(path)
    assert response.status_code == status
    assert response.headers["content-type"].startswith("text/html")
    assert "<h1" in response.text
    assert 'href="/"' in response.text


def test_an_unforeseen_fault_shows_its_number_and_nothing_else(faulty_client: TestClient) -> None:
    response = faulty_client.get("/page/break")
    assert response.status_code == 500
    assert response.headers["x-request-id"] in response.text
    assert "secret detail" not in response.text
    assert "default-src 'none'" in response.headers["content-security-policy"]


@pytest.mark.parametrize("path", ["/studies/%00", "/library/a%00b", "/api/v1/clips/%00"])
def test_an_address_that_no_database_can_look_up_is_no_fault_of_ours(
    signed_in: Researching, path: str
) -> None:
    response = signed_in.client.get(path)
    assert response.status_code in (404, 422)
    assert "internal" not in response.text


def test_a_form_that_no_database_can_look_up_is_refused(client: TestClient) -> None:
    form = {"email": "a\0b", "password": "long enough", "csrf_token": csrf_token(client)}
    assert client.post("/research/sign-in", data=form).status_code == 422


def test_every_kind_of_error_has_a_status_of_its_own() -> None:
    from app.error_handling import STATUSES

    assert set(errors.MannerError.__subclasses__()) == set(STATUSES)
