"""From an entry's source name to the tags that load its built files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from markupsafe import Markup
from starlette.responses import Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

_STYLESHEET = Markup('<link rel="stylesheet" href="/static/{}">')
YEAR = "public, max-age=31536000, immutable"


class Assets:
    """What vite built, read anew when it has built again."""

    def __init__(self, directory: Path) -> None:
        self.directory = directory
        self._manifest: dict[str, Any] = {}
        self._read_at = 0

    def tags(self, entry: str) -> Markup:
        """Stylesheet and module tags of ``entry``, such as ``src/entries/site.ts``, or an icon's.

        An SVG, such as ``src/favicon.svg``, becomes the page's icon; a stylesheet may stand alone.

        Raises:
            LookupError: when the front end was not built or has no such entry.
        """
        manifest = self._current_manifest()
        if entry not in manifest:
            raise LookupError(f"vite built no entry {entry}: look in static/vite.config.ts.")
        if entry.endswith(".svg"):
            icon = Markup('<link rel="icon" type="image/svg+xml" href="/static/{}">')
            return icon.format(manifest[entry]["file"])
        if entry.endswith(".css"):
            return _STYLESHEET.format(manifest[entry]["file"])
        chunks = _with_imports(manifest, entry)
        styles = dict.fromkeys(css for chunk in chunks for css in chunk.get("css", ()))
        lines = [_STYLESHEET.format(css) for css in styles]
        lines += [
            Markup('<link rel="modulepreload" href="/static/{}">').format(chunk["file"])
            for chunk in chunks[1:]
        ]
        file = chunks[0]["file"]
        lines.append(Markup('<script type="module" src="/static/{}"></script>').format(file))
        return Markup("\n").join(lines)

    def _current_manifest(self) -> dict[str, Any]:
        path = self.directory / ".vite" / "manifest.json"
        try:
            changed_at = path.stat().st_mtime_ns
        except FileNotFoundError:
            raise LookupError(
                "The front end is not built: run `npm run build` in static/."
            ) from None
        if changed_at != self._read_at:
            self._manifest = json.loads(path.read_text())
            self._read_at = changed_at
        return self._manifest


def _with_imports(manifest: dict[str, Any], entry: str) -> list[dict[str, Any]]:
    """The entry's chunk first, then all that it imports at once, each one time."""
    names = [entry]
    for name in names:  # grows while it is walked
        names += [n for n in manifest[name].get("imports", ()) if n not in names]
    return [manifest[name] for name in names]


class BuiltFiles(StaticFiles):
    """Built files; those with a hash in their name never change and are kept for a year."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Serve ``path``, saying how long it keeps."""
        response = await super().get_response(path, scope)
        if path.startswith("assets/") and response.status_code in (200, 206, 304):
            response.headers["Cache-Control"] = YEAR
        else:
            response.headers.setdefault("Cache-Control", "no-cache")
        return response
