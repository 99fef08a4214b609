"""Logs tell what happened and nothing about persons."""

from __future__ import annotations

import json

import pytest
from starlette.testclient import TestClient

from app.logs import configure_logs, log
from app.persistence.engine import Database
from app.services import researchers
from app.settings import Settings
from tests.app.conftest import PASSWORD, csrf_token


def lines(capsys: pytest.CaptureFixture[str]) -> list[dict[str, object]]:
    return [json.loads(line) for line in capsys.readouterr().err.splitlines()]


def test_each_request_is_one_line_with_its_number(
    client: TestClient, capsys: pytest.CaptureFixture[str]
) -> None:
    response = client.get("/library")
    (line,) = lines(capsys)
    assert line["event"] == "request"
    assert line["request"] == response.headers["x-request-id"]
    assert (line["method"], line["route"], line["status"]) == ("GET", "/library", 200)


def test_tokens_passwords_and_addresses_are_never_logged(
    client: TestClient, database: Database, capsys: pytest.CaptureFixture[str]
) -> None:
    with database.writing() as db:
        link = researchers.make_setup_link(db, "")
    form = {
        "email": "rosa@example.org",
        "name": "Rosa",
        "password": PASSWORD,
        "csrf_token": csrf_token(client),
    }
    client.post(link, data=form)
    client.get("/take/participant-secret-token")
    client.get("/api/v1/sessions/participant-secret-token")
    client.get("/nowhere/participant-secret-token?token=participant-secret-token")
    text = capsys.readouterr().err
    secrets = [link.rpartition("/")[2], PASSWORD, "rosa", form["csrf_token"], "testclient"]
    for secret in (*secrets, "participant-secret-token", *client.cookies.values()):
        assert secret not in text
    assert "/research/set-up/{token}" in text
    assert "/take/{token}" in text


@pytest.mark.parametrize("log_format", ["console", "json"])
def test_a_fault_is_logged_without_the_variables_that_it_met(
    settings: Settings, capsys: pytest.CaptureFixture[str], log_format: str
) -> None:
    configure_logs(settings.model_copy(update={"log_format": log_format}))
    password = PASSWORD.upper()
    try:
        _fail_with(password)
    except RuntimeError:
        log.exception("unforeseen fault")
    text = capsys.readouterr().err
    assert "RuntimeError: broken" in text
    assert password not in text


def _fail_with(password: str) -> None:
    raise RuntimeError("broken" if password else "")
