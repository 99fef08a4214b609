"""The researchers' page of API keys.

The template `research/keys.html` is given: keys, a list of KeyView; new, the NewKey that was just
made, or None; error, why none was made, or None; name and scope, as they were filled in.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Form, Request
from fastapi.responses import RedirectResponse, Response

from app.dependencies import CsrfChecked, Reading, SignedIn, Writing
from app.errors import InvalidError
from app.pages import render
from app.schemas.keys import Scope
from app.services import keys

router = APIRouter(prefix="/research/keys", include_in_schema=False)


@router.get("")
def show_keys(request: Request, researcher: SignedIn, db: Reading) -> Response:
    """The researcher's keys."""
    found = keys.listed(db, researcher.id)
    return render(
        request, "research/keys.html", keys=found, new=None, error=None, name="", scope="read"
    )


@router.post("", dependencies=[CsrfChecked])
def make_key(
    request: Request, researcher: SignedIn, db: Writing,
    name: Annotated[str, Form()], scope: Annotated[Scope, Form()],
) -> Response:  # fmt: skip
    """Make a key. This answer alone shows it: no address leads to it and nobody keeps it."""
    try:
        new, error = keys.make(db, researcher.id, name, scope), None
    except InvalidError as refused:
        new, error = None, refused
    return render(
        request, "research/keys.html", status=422 if error else 201,
        headers={"Cache-Control": "no-store"}, keys=keys.listed(db, researcher.id), new=new,
        error=error, name=name if error else "", scope=scope if error else "read",
    )  # fmt: skip


@router.post("/{key_id}/revoke", dependencies=[CsrfChecked])
def revoke_key(key_id: int, researcher: SignedIn, db: Writing) -> Response:
    """Let a key open nothing from now on."""
    keys.revoke(db, researcher.id, key_id)
    return RedirectResponse("/research/keys", 303)
