"""How tests begin a session and what they answer where the answer does not matter."""

from __future__ import annotations

from typing import Any

from sqlalchemy.orm import Session

from app.services import sessions
from app.services.sessions import Beginning
from app.studies import emotion

SCALES = [scale["id"] for scale in emotion.SCALES]
NEUTRAL = dict.fromkeys(SCALES, 0)


def begin(db: Session, slug: str = emotion.SLUG, version: str = "1", **more: Any) -> str:
    """The secret of a new session by somebody who agreed to that version of the consent."""
    return sessions.begin(db, slug, Beginning(consent_version=version, **more))
