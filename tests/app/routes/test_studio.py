"""Who may open the studio."""

from __future__ import annotations

from starlette.testclient import TestClient

from tests.app.conftest import Researching


def test_a_stranger_is_led_to_sign_in_and_back_to_the_clip(client: TestClient) -> None:
    response = client.get("/studio?clip=abc", follow_redirects=False)
    assert response.status_code == 303
    assert response.headers["location"] == "/research/sign-in?next=/studio%3Fclip%3Dabc"


def test_a_researcher_gets_the_clip_that_was_asked_for_as_text(signed_in: Researching) -> None:
    page = signed_in.client.get('/studio?clip="><script>alert(1)</script>').text
    assert "<motion-studio clip=" in page
    assert "<script>alert" not in page
