"""Deletes what was promised to be deleted: sessions whose retention time is over."""

from __future__ import annotations

from datetime import datetime, timedelta
from functools import partial

from sqlalchemy.orm import Session

from app.persistence import live as store
from app.persistence import studies
from app.persistence.engine import Database
from app.persistence.models import now
from app.persistence.writer import Writer
from app.services import audit
from app.services.live import session_name
from app.services.sessions import erase
from app.services.studies import running_of

AT_ONCE = 100  # sessions in one transaction, so that participants' answers need not wait long


def sweep(database: Database, writer: Writer, moment: datetime | None = None) -> int:
    """Delete every session whose study keeps answers no longer; tombstones stay.

    Args:
        database: where to look.
        writer: who deletes.
        moment: from which the days are counted back; now, if left out.

    Returns:
        How many sessions were deleted.
    """
    moment = moment or now()
    with database.reading() as db:
        terms = {one.id: running_of(one).retention_days for one in studies.all_studies(db)}
    deleted = 0
    for study_id, days in terms.items():
        if days is not None:
            before = moment - timedelta(days=days)
            while some := writer.write(partial(_delete, study_id=study_id, before=before)):
                deleted += some
    return deleted


def _delete(db: Session, study_id: int, before: datetime) -> int:
    study = studies.by_id(db, study_id)
    days = running_of(study).retention_days
    if days is None:  # changed meanwhile
        return 0
    found = store.expired(db, study_id, before, AT_ONCE)
    for session in found:
        erase(db, session)
        audit.note(
            db, study_id, "session_expired", None, session.id,
            name=session_name(session.id), days=days,
        )  # fmt: skip
    return len(found)
