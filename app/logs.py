"""Structured logs: one line a request, without tokens or addresses of people."""

from __future__ import annotations

import logging
import secrets
import sys
import time

import structlog
from fastapi import Request
from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.error_handling import answer_unforeseen
from app.settings import Settings

log = structlog.get_logger("manner")


def configure_logs(settings: Settings) -> None:
    """Console lines for a person at a terminal, JSON for everything else."""
    console = settings.log_format == "console" or (
        settings.log_format == "auto" and sys.stderr.isatty()
    )
    renderer: list[structlog.typing.Processor] = (
        # Its own way to show a fault prints every variable: passwords and tokens among them.
        [structlog.dev.ConsoleRenderer(exception_formatter=structlog.dev.plain_traceback)]
        if console
        else [structlog.processors.format_exc_info, structlog.processors.JSONRenderer()]
    )
    structlog.configure(
        processors=[
            structlog.contextvars.merge_contextvars,
            structlog.processors.add_log_level,
            structlog.processors.TimeStamper(fmt="iso", utc=True),
            *renderer,
        ],
        wrapper_class=structlog.make_filtering_bound_logger(
            logging.getLevelNamesMapping()[settings.log_level.upper()]
        ),
        logger_factory=lambda *_: structlog.PrintLogger(sys.stderr),
    )


class LogMiddleware:
    """Logs each request under a number of its own, and answers faults that nobody foresaw.

    The log has the route's pattern, never the path: paths carry participants' tokens.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, then write its line."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        request_id = secrets.token_hex(8)
        structlog.contextvars.bind_contextvars(request=request_id)
        started = time.perf_counter()
        status = 0

        async def send_with_number(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = message["status"]
                MutableHeaders(scope=message)["X-Request-ID"] = request_id
            await send(message)

        try:
            await self.app(scope, receive, send_with_number)
        except Exception:
            log.exception("unforeseen fault", route=_route(scope))
            if status:  # half an answer is out already: only the server can break the connection
                raise
            response = answer_unforeseen(Request(scope, receive), request_id)
            await response(scope, receive, send_with_number)
        finally:
            milliseconds = round((time.perf_counter() - started) * 1000, 1)
            write = log.debug if scope["path"].startswith(("/static/", "/health")) else log.info
            write(
                "request", method=scope["method"], route=_route(scope), status=status,
                milliseconds=milliseconds,
            )  # fmt: skip
            structlog.contextvars.clear_contextvars()


def _route(scope: Scope) -> str:
    return str(getattr(scope.get("route"), "path", "unknown"))
