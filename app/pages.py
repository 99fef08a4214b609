"""Renders templates: what every page gets, said once."""

from __future__ import annotations

from collections.abc import Mapping

from fastapi import Request
from fastapi.templating import Jinja2Templates
from jinja2 import Environment, FileSystemLoader, StrictUndefined, select_autoescape
from starlette.responses import HTMLResponse

from app.assets import Assets
from app.settings import PROJECT


def make_templates(assets: Assets) -> Jinja2Templates:
    """The page templates; a name that is not there is an error, not an empty place."""
    environment = Environment(
        loader=FileSystemLoader(PROJECT / "templates"),
        autoescape=select_autoescape(),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.globals["asset"] = assets.tags
    return Jinja2Templates(env=environment)


def render(
    request: Request,
    template: str,
    *,
    status: int = 200,
    headers: Mapping[str, str] | None = None,
    **context: object,
) -> HTMLResponse:
    """A page. Besides ``context`` it knows ``csrf_token`` and ``researcher`` (or ``None``)."""
    templates: Jinja2Templates = request.app.state.templates
    common = {
        "csrf_token": request.state.csrf.token,
        "researcher": getattr(request.state, "researcher", None),
    }
    return templates.TemplateResponse(
        request, template, {**common, **context}, status_code=status, headers=headers
    )
