"""Headers, forged requests, large bodies, guessed passwords."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from app.main import create_app
from app.security import CONTENT_POLICY, MotionLimiter
from app.settings import Settings
from tests.app.conftest import PASSWORD, Researching, csrf_token


@pytest.mark.parametrize(
    "path", ["/", "/library", "/nothing", "/api/v1/clips", "/api/v1/nothing", "/health"]
)
def test_every_answer_carries_the_security_headers(client: TestClient, path: str) -> None:
    headers = client.get(path).headers
    assert headers["content-security-policy"] == CONTENT_POLICY
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "same-origin"
    assert headers["cache-control"] == "no-store"


def test_the_content_policy_allows_no_foreign_and_no_inline_script() -> None:
    policy = dict(part.split(" ", 1) for part in CONTENT_POLICY.split("; "))
    assert policy["default-src"] == "'none'"
    assert policy["script-src"] == policy["style-src"] == "'self'"
    assert policy["frame-ancestors"] == policy["base-uri"] == "'none'"
    assert "unsafe" not in CONTENT_POLICY


@pytest.mark.parametrize("page", ["/", "/library", "/research/sign-in", "/no-webgl", "/nothing"])
def test_no_page_has_inline_scripts_or_styles(client: TestClient, page: str) -> None:
    html = client.get(page).text
    scripts = re.findall(r"<script(?![^>]*\bsrc=)(?![^>]*application/json)[^>]*>", html)
    assert scripts == []
    assert "<style" not in html
    assert not re.search(r"<[^>]+\s(style|on\w+)=", html)


def test_a_form_without_its_token_changes_nothing(client: TestClient, researcher: str) -> None:
    form = {"email": researcher, "password": PASSWORD}
    for token in ({}, {"csrf_token": ""}, {"csrf_token": "forged"}):
        response = client.post("/research/sign-in", data=form | token)
        assert response.status_code == 403
        assert "reload the page" in response.text
    assert not [name for name in client.cookies if "researcher" in name]


def test_a_broken_cookie_is_refused_like_a_missing_one(client: TestClient) -> None:
    form = {"email": "a@example.org", "password": PASSWORD, "csrf_token": csrf_token(client)}
    client.cookies.clear()
    response = client.post(
        "/research/sign-in", data=form, headers={"Cookie": "manner_csrf=\xfc".encode("latin-1")}
    )
    assert response.status_code == 403


def test_a_token_of_another_browser_is_refused(
    client: TestClient, settings: Settings, built: Path, researcher: str
) -> None:
    with TestClient(create_app(settings, built)) as other:
        stolen = csrf_token(other)
    csrf_token(client)  # this browser has a cookie of its own
    form = {"email": researcher, "password": PASSWORD, "csrf_token": stolen}
    assert client.post("/research/sign-in", data=form).status_code == 403


def test_a_script_without_the_header_changes_nothing(signed_in: Researching) -> None:
    for method, path in (
        ("post", "/api/v1/clips/0/confirm"),
        ("patch", "/api/v1/clips/0"),
        ("delete", "/api/v1/clips/0"),
    ):
        more = {"json": {}} if method == "patch" else {}
        response = getattr(signed_in.client, method)(path, **more)
        assert response.status_code == 403, (method, path)
        assert response.json()["error"]["code"] == "csrf_token_invalid"


def test_a_request_that_declares_too_much_is_refused_unread(client: TestClient) -> None:
    response = client.post("/research/sign-in", data={"email": "x" * 1_000_001})
    assert response.status_code == 413
    assert "1,000,000 bytes" in response.text


def test_a_stream_is_cut_off_at_the_limit(signed_in: Researching, settings: Settings) -> None:
    sent = 0

    def endless() -> Iterator[bytes]:
        nonlocal sent
        head = b'--b\r\nContent-Disposition: form-data; name="file"; filename="a.bvh"\r\n\r\n'
        yield head
        while sent < 3 * settings.upload_limit:
            sent += 1_000_000
            yield b" " * 1_000_000

    response = signed_in.client.post(
        "/api/v1/imports",
        content=endless(),
        headers={**signed_in.headers, "Content-Type": "multipart/form-data; boundary=b"},
    )
    assert response.status_code == 413
    error = response.json()["error"]
    assert error["code"] == "too_large"
    assert f"{settings.upload_limit:,}" in error["message"]


def test_guessing_passwords_is_stopped_after_the_allowed_attempts(
    client: TestClient, researcher: str
) -> None:
    token = csrf_token(client)
    form = {"email": researcher, "password": "wrong wrong wrong", "csrf_token": token}
    answers = [client.post("/research/sign-in", data=form).status_code for _ in range(11)]
    assert answers == [422] * 10 + [429]
    right = client.post("/research/sign-in", data=form | {"password": PASSWORD})
    assert right.status_code == 429
    assert "Wait 15 minutes" in right.text


def test_made_up_tokens_are_forgotten(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(MotionLimiter, "RATE", "1/1 second")
    limiter = MotionLimiter()
    for number in range(1000):
        limiter.count(f"token {number}")
    kept = limiter._limiter.storage
    assert len(kept.storage) > 500
    end = time.monotonic() + 60
    while len(kept.storage) + len(kept.events) + len(kept.locks) > 500:
        assert time.monotonic() < end, "who is counted once is remembered for ever"
        time.sleep(0.05)
        limiter.count(f"another at {time.monotonic()}")


def test_over_https_cookies_are_secure_and_bound_to_the_host(
    settings: Settings, built: Path
) -> None:
    secure = settings.model_copy(update={"public_url": "https://testserver"})
    with TestClient(create_app(secure, built), base_url="https://testserver") as client:
        response = client.get("/research/sign-in")
    cookie = response.headers["set-cookie"]
    assert cookie.startswith("__Host-manner_csrf=")
    for attribute in ("HttpOnly", "SameSite=Lax", "Secure", "Path=/"):
        assert attribute in cookie
    assert "max-age=" in response.headers["strict-transport-security"]
