"""Which slot of a study's design a newcomer takes.

Slots are numbered 0, 1, 2 … within a version. A slot is held by a participant who completed it, or
who is under way and has given a sign within the lease. A newcomer takes the lowest free one; so
groups, rows and subsets fill up evenly on what is complete and under way, and what somebody left
behind is done again by another.
"""

from __future__ import annotations

from datetime import datetime, timedelta
from itertools import count

from sqlalchemy.orm import Session

from app.persistence import sessions as store
from app.persistence.models import Study, StudyVersion
from app.schemas.study import Running


def take_slot(db: Session, study: Study, version: StudyVersion, kind: str, moment: datetime) -> int:
    """The lowest free slot; the study's row is locked by the caller until the commit.

    Simulated participants and previews have slots among their own kind and take none away.
    """
    running = Running.model_validate(study.running)
    since = moment - timedelta(minutes=running.lease_minutes)
    held = store.held_slots(db, version.id, kind, since)
    taken = set(held)
    return next(slot for slot in count() if slot not in taken)
