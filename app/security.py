"""Headers, forgery tokens, body limits, sign-in cookies and brakes."""

from __future__ import annotations

import hmac
import secrets
from functools import cached_property

from itsdangerous import BadSignature, URLSafeTimedSerializer
from limits import RateLimitItem, parse
from limits.storage import MemoryStorage
from limits.strategies import FixedWindowRateLimiter
from starlette.datastructures import Headers, MutableHeaders
from starlette.exceptions import HTTPException
from starlette.requests import HTTPConnection, Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.error_handling import answer_error
from app.errors import ForbiddenError, TooLargeError, TooManyError
from app.settings import Settings

CONTENT_POLICY = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "img-src 'self' data: blob:",
        "font-src 'self'",
        "connect-src 'self' blob:",
        "worker-src 'self' blob:",
        "form-action 'self'",
        "base-uri 'none'",
        "frame-ancestors 'none'",
    )
)
HEADERS = {
    "Content-Security-Policy": CONTENT_POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "same-origin",  # addresses carry participants' tokens
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "camera=(), microphone=(), geolocation=(), payment=()",
}


class HeadersMiddleware:
    """Puts the security headers on every answer, and keeps what names no duration out of caches."""

    def __init__(self, app: ASGIApp, secure: bool) -> None:
        self.app = app
        self.headers = dict(HEADERS)
        if secure:
            self.headers["Strict-Transport-Security"] = "max-age=31536000"

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on; complete the answer's headers."""

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in self.headers.items():
                    headers.setdefault(name, value)
                headers.setdefault("Cache-Control", "no-store")
            await send(message)

        await self.app(scope, receive, send_with_headers)


class BodyLimitMiddleware:
    """Stops reading a request body that is larger than its address may take."""

    def __init__(self, app: ASGIApp, limit: int, upload_limit: int) -> None:
        self.app = app
        self.limit = limit
        self.upload_limit = upload_limit

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on, counting what comes in."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        upload = scope["path"] == "/api/v1/imports"
        limit = self.upload_limit if upload else self.limit
        message = f"More than the {limit:,} bytes that fit here."
        declared = Headers(scope=scope).get("content-length", "")
        if declared.isdigit() and int(declared) > limit:
            answer = answer_error(Request(scope, receive), TooLargeError(message))
            await answer(scope, receive, send)
            return
        received = 0

        async def receive_within_limit() -> Message:
            nonlocal received
            part = await receive()
            received += len(part.get("body", b""))
            if received > limit:
                # FastAPI lets this kind through where it would call any other a bad request.
                raise HTTPException(413, message)
            return part

        await self.app(scope, receive_within_limit, send)


class Csrf:
    """One request's token against forged requests: signed, and equal to a cookie underneath."""

    def __init__(self, key: str, cookie: str | None) -> None:
        self._serializer = URLSafeTimedSerializer(key, salt="csrf")
        self.cookie = cookie
        self.is_new = False

    @cached_property
    def token(self) -> str:
        """For a form's hidden field or the page's meta element."""
        if not self.cookie:
            self.cookie = secrets.token_urlsafe(24)
            self.is_new = True
        return str(self._serializer.dumps(self.cookie))

    def check(self, token: str | None) -> None:
        """Raise ForbiddenError unless ``token`` was made for this browser within a day."""
        try:
            content = self._serializer.loads(token or "", max_age=86_400)
        except BadSignature:
            content = ""
        known = (self.cookie or "").encode()  # bytes: text with an umlaut cannot be compared
        if not known or not hmac.compare_digest(str(content).encode(), known):
            raise ForbiddenError(
                "The page was open for too long, or the browser keeps no cookies for this site.",
                code="csrf_token_invalid",
                mend="Go back, reload the page and try again.",
            )


class CsrfMiddleware:
    """Gives each request its ``state.csrf`` and sets the cookie once a token was handed out."""

    def __init__(self, app: ASGIApp, key: str, secure: bool) -> None:
        self.app = app
        self.key = key
        self.name = cookie_name("manner_csrf", secure)
        self.attributes = "Path=/; HttpOnly; SameSite=Lax" + ("; Secure" if secure else "")

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on with ``state.csrf``."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        csrf = Csrf(self.key, HTTPConnection(scope).cookies.get(self.name))
        scope.setdefault("state", {})["csrf"] = csrf

        async def send_with_cookie(message: Message) -> None:
            if message["type"] == "http.response.start" and csrf.is_new:
                headers = MutableHeaders(scope=message)
                headers.append("Set-Cookie", f"{self.name}={csrf.cookie}; {self.attributes}")
            await send(message)

        await self.app(scope, receive, send_with_cookie)


class SignInCookies:
    """The signed cookie of a signed-in researcher: who, and a mark of the password then."""

    def __init__(self, settings: Settings) -> None:
        self.name = cookie_name("manner_researcher", settings.secure)
        self.secure = settings.secure
        self.seconds = int(settings.session_hours * 3600)
        self._serializer = URLSafeTimedSerializer(settings.signing_key, salt="researcher")

    def make(self, researcher_id: int, password_mark: str) -> str:
        """The cookie's value."""
        return str(self._serializer.dumps([researcher_id, password_mark]))

    def read(self, value: str | None) -> tuple[int, str] | None:
        """Researcher and password mark; ``None`` for a cookie that is forged or too old."""
        try:
            researcher_id, mark = self._serializer.loads(value or "", max_age=self.seconds)
        except (BadSignature, ValueError, TypeError):
            return None
        return int(researcher_id), str(mark)


def cookie_name(name: str, secure: bool) -> str:
    """With https the name makes browsers refuse cookies planted by a neighbouring host."""
    return f"__Host-{name}" if secure else name


class AttemptLimiter:
    """Counts failed attempts to sign in, by the address that they come from."""

    def __init__(self, rate: str) -> None:
        self._rate, self._limiter = _brake(rate)

    def check(self, address: str) -> None:
        """Raise TooManyError when ``address`` has failed too often of late."""
        if not self._limiter.test(self._rate, address):
            raise TooManyError(
                "Too many attempts to sign in from your network.",
                mend=f"Wait {self._rate.get_expiry() // 60} minutes and try again.",
            )

    def count_failure(self, address: str) -> None:
        """Remember one failed attempt."""
        self._limiter.hit(self._rate, address)


class MotionLimiter:
    """Counts the motions that a session has asked for: a page asks for at most 20 in a second."""

    RATE = "300/10 seconds"

    def __init__(self) -> None:
        self._rate, self._limiter = _brake(self.RATE)

    def count(self, token: str) -> None:
        """Raise TooManyError when no hand on a slider asks so often."""
        if not self._limiter.hit(self._rate, token):
            raise TooManyError(
                "Too many motions were asked for in a short time.",
                mend=f"Wait {self._rate.get_expiry()} seconds and move a slider again.",
            )


def _brake(rate: str) -> tuple[RateLimitItem, FixedWindowRateLimiter]:
    # Not the moving window: that would keep every name that was ever counted, and anybody can
    # invent as many tokens as there is memory.
    return parse(rate), FixedWindowRateLimiter(MemoryStorage())
