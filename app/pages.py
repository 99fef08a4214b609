"""Renders templates: what every page gets, said once."""

from __future__ import annotations

from collections.abc import Mapping

from fastapi import Request
from fastapi.templating import Jinja2Templates
from jinja2 import Environment, FileSystemLoader, StrictUndefined, select_autoescape
from starlette.responses import HTMLResponse

from app import i18n
from app.assets import Assets
from app.schemas.study import Language
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
    environment.policies["json.dumps_kwargs"] = {"sort_keys": True, "ensure_ascii": False}
    environment.globals["asset"] = assets.tags
    return Jinja2Templates(env=environment)


def render(
    request: Request,
    template: str,
    *,
    status: int = 200,
    headers: Mapping[str, str] | None = None,
    language: Language = i18n.SOURCE,
    **context: object,
) -> HTMLResponse:
    """A page. Besides ``context`` it knows ``csrf_token`` and ``researcher`` (or ``None``).

    A participant's page says what it says through ``_("…")`` and ``ngettext("…", "…", n)``, in
    ``language``; ``phrases`` writes numbers and times.
    """
    templates: Jinja2Templates = request.app.state.templates
    phrases = i18n.phrases(language)
    common = {
        "language": language,
        "phrases": phrases,
        "_": phrases.text,
        "ngettext": phrases.plural,
        "csrf_token": request.state.csrf.token,
        "researcher": getattr(request.state, "researcher", None),
    }
    return templates.TemplateResponse(
        request, template, {**common, **context}, status_code=status, headers=headers
    )


def wanted_languages(request: Request, chosen: str | None = None) -> tuple[str, ...]:
    """The languages that a person wants: the one chosen on the page, then the browser's."""
    asked = chosen or request.query_params.get("lang")
    return i18n.wanted(asked, request.headers.get("accept-language"))
