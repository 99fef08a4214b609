"""Whether a study takes a newcomer now."""

from __future__ import annotations

from datetime import datetime, timedelta
from typing import Literal

from sqlalchemy.orm import Session

from app.persistence import sessions as store
from app.persistence.models import Study
from app.schemas.study import Running
from app.services.recruiting import Arrival

Closed = Literal["not_published", "not_yet_open", "paused", "closed", "by_invitation", "full"]


def closed_for(
    db: Session, study: Study, running: Running, coming: Arrival, moment: datetime
) -> Closed | None:
    """Why the study takes nobody who comes like this; None where it does."""
    if study.state in ("draft", "paused", "closed"):
        names: dict[str, Closed] = {
            "draft": "not_published", "paused": "paused", "closed": "closed",
        }  # fmt: skip
        return names[study.state]
    if running.opens_at and moment < running.opens_at:
        return "not_yet_open"
    if running.closes_at and moment >= running.closes_at:
        return "closed"
    if coming.source == "open" and not running.open_link:
        return "by_invitation"
    since = moment - timedelta(minutes=running.lease_minutes)
    if running.quota is not None and store.count_held(db, study.id, since) >= running.quota:
        return "full"
    return None
