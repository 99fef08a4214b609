"""The pages about motion, and the server's own state."""

from __future__ import annotations

import pytest
from sqlalchemy import text
from starlette.testclient import TestClient

from app.persistence.engine import Database
from tests.app.conftest import Researching
from tests.support.motions import walk


@pytest.mark.parametrize("path", ["/", "/library", "/no-webgl", "/research/sign-in"])
def test_a_page_shows_before_there_are_any_motions(client: TestClient, path: str) -> None:
    response = client.get(path)
    assert response.status_code == 200
    assert response.headers["content-type"] == "text/html; charset=utf-8"
    assert "/static/assets/site-0a1b2c3d.js" in response.text


def test_the_first_page_leads_on(client: TestClient) -> None:
    html = client.get("/").text
    assert 'href="/library"' in html
    assert 'href="/research"' in html


def test_a_clip_has_a_page_of_its_own(client: TestClient, samples_made: int) -> None:
    clip = client.get(f"/api/v1/clips/{walk().content_hash}").json()
    html = client.get(clip["page_url"]).text
    assert clip["glb_url"] in html
    assert clip["figure_url"] in html


def test_a_page_that_is_not_there_says_so(signed_in: Researching) -> None:
    for path in ("/library/0", "/nothing"):
        response = signed_in.client.get(path)
        assert response.status_code == 404
        assert "<h1" in response.text


def test_health_is_good_on_a_prepared_database(client: TestClient) -> None:
    assert client.get("/health").json() == {"status": "ok", "database": "ready"}


def test_health_tells_of_an_outdated_database(client: TestClient, database: Database) -> None:
    with database.writing() as db:
        db.execute(text("UPDATE alembic_version SET version_num = 'older'"))
        db.commit()
    response = client.get("/health")
    assert response.status_code == 503
    assert "manner prepare" in response.json()["database"]
