"""Which code made a clip's files."""

from __future__ import annotations

import hashlib
from functools import cache
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path


@cache
def engine_version() -> str:
    """The release and a hash of the motion library's code.

    A number raised by hand would be forgotten one day, and then two unlike files would claim the
    same origin.
    """
    found = find_spec("motion")  # not imported: the command line wants an answer at once
    if found is None or found.origin is None:
        raise RuntimeError("The motion library is missing from this installation.")
    folder = Path(found.origin).parent
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*.py")):
        digest.update(f"{path.relative_to(folder)}\0".encode() + path.read_bytes())
    return f"{version('manner')}+{digest.hexdigest()[:16]}"
