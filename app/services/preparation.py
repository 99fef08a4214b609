"""Everything that must be there before the server starts. Quick when it is."""

from __future__ import annotations

from collections.abc import Callable

from app.persistence import clips, schema
from app.persistence.engine import Database
from app.services import spaces, studies
from app.services.engine_version import engine_version


def needs_migration(database: Database) -> bool:
    """Whether the database's tables are older than the code."""
    return schema.current(database.engine) != schema.head()


def prepare(database: Database, on_progress: Callable[[int, int], None]) -> None:
    """Migrate, make the sample library, then the demonstrations; what is there stays."""
    if needs_migration(database):
        schema.upgrade(database.engine)
    with database.reading() as db:
        ready = clips.has_samples_of(db, engine_version())
        has_spaces = ready and spaces.has_samples(db)
    if not ready:
        # They bring SciPy along, which takes longer to load than all else here.
        from app.services import renewal, samples

        # The samples come last: they are the mark that this engine has prepared everything.
        renewal.renew_imported(database, on_progress)
        samples.make(database, on_progress=on_progress)
    if not has_spaces:
        from app.services import space_samples

        space_samples.make(database)
    with database.writing() as db:
        studies.ensure_demonstration(db)
