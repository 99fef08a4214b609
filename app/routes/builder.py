"""The pages on which studies are made and run.

What the templates of `templates/research/` are given:

- `studies.html`: studies, a list of StudyLine (app/schemas/studies_api.py); home, the server's
  public address;
- `builder.html`, `settings.html`: study, a StudyDetail; role; home;
- `preview.html`: study, the title; address, where the page's script finds the way through it.
"""

from __future__ import annotations

from urllib.parse import urlencode

from fastapi import APIRouter, Request
from fastapi.responses import Response

from app.dependencies import Reading, SignedIn, StudyViewer
from app.i18n import SOURCE
from app.pages import render
from app.schemas.study import Language
from app.security import CONTENT_POLICY
from app.services import drafts, previews, studies

router = APIRouter(prefix="/research", include_in_schema=False)

# The builder shows the preview in a frame; no other page frames or is framed.
FRAMES = {"Content-Security-Policy": f"{CONTENT_POLICY}; frame-src 'self'"}
FRAMED = {
    "Content-Security-Policy": CONTENT_POLICY.replace(
        "frame-ancestors 'none'", "frame-ancestors 'self'"
    )
}

WELCOME = ":welcome"  # no part can be called so


@router.get("")
def show_studies(request: Request, researcher: SignedIn, db: Reading) -> Response:
    """Every study of the researcher with its state and counts."""
    found = drafts.listed(db, researcher.id).studies
    return render(
        request, "research/studies.html", studies=found, home=_home(request), section="studies"
    )


@router.get("/studies/{slug}/edit")
def show_builder(request: Request, access: StudyViewer, db: Reading) -> Response:
    """The builder."""
    return _page(request, "builder", access, db, FRAMES)


@router.get("/studies/{slug}/settings")
def show_settings(request: Request, access: StudyViewer, db: Reading) -> Response:
    """Who may come, when, from where, and who works on the study."""
    return _page(request, "settings", access, db)


@router.get("/studies/{slug}/preview")
def show_preview(
    request: Request, access: StudyViewer, db: Reading,
    part: str = "", language: Language | None = None,
) -> Response:  # fmt: skip
    """The participant's pages with what is being edited. Nothing is stored."""
    if part == WELCOME:
        page = previews.welcome(db, access, language)
        return render(
            request, "participant/welcome.html", headers=FRAMED, language=page.language,
            study=page.study, clip=page.clip, languages=[], carried={}, problem=None,
            previewing=False, only_shown=True,
        )  # fmt: skip
    query = urlencode({"part": part, **({"language": language} if language else {})})
    address = f"/api/v1/studies/{access.slug}/preview?{query}"
    spoken = language or SOURCE
    return render(
        request, "research/preview.html", headers=FRAMED, language=spoken, address=address
    )


def _page(
    request: Request,
    name: str,
    access: StudyViewer,
    db: Reading,
    headers: dict[str, str] | None = None,
) -> Response:
    return render(
        request, f"research/{name}.html", headers=headers, study=drafts.view(db, access),
        role=access.role, home=_home(request), section="studies",
        adjectives=studies.asks_pairs(db, access.slug),
    )  # fmt: skip


def _home(request: Request) -> str:
    return str(request.app.state.settings.public_url)
