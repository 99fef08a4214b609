"""The interface's phrases in a participant's language: catalogs, plurals, numbers and times.

A phrase is found by its English text. The catalogs (`app/locales`) are read as they are written,
so there is nothing to compile; `make messages` brings them up to date with the pages.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any

from babel import Locale
from babel.dates import format_datetime
from babel.messages.catalog import Catalog
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po
from babel.numbers import format_decimal
from babel.support import NullTranslations, Translations
from markupsafe import Markup

from app.schemas.study import LANGUAGES, Language
from app.settings import PROJECT

LOCALES = PROJECT / "app" / "locales"
SOURCE: Language = "en"
TRANSLATED = tuple(language for language in LANGUAGES if language != SOURCE)
SCRIPTS = "static/src/"


class Phrases:
    """Everything that the interface says in one language."""

    def __init__(self, language: Language) -> None:
        self.language = language
        self.locale = Locale.parse(language)
        catalog = None if language == SOURCE else read_catalog(language)
        self._texts = _translations(catalog) if catalog else NullTranslations()
        self.for_scripts: dict[str, Any] = {
            "language": language,
            "texts": _used_by_scripts(catalog) if catalog else {},
        }

    def text(self, phrase: str, /, **values: object) -> Markup:
        """A phrase, with `{name}` in it replaced by a value; numbers as the language writes them.

        The phrases are ours and may hold links; the values are escaped.
        """
        return self._filled(self._texts.gettext(phrase), values)

    def plural(self, one: str, many: str, n: int, /, **values: object) -> Markup:
        """A phrase that depends on a number; `{n}` in it is the number."""
        return self._filled(self._texts.ngettext(one, many, n), {"n": n, **values})

    def number(self, value: float) -> str:
        """1234.5 as “1,234.5”, “1 234,5” or however else it is written."""
        return format_decimal(value, locale=self.locale)

    def moment(self, when: datetime) -> str:
        """A day and a time of day, UTC."""
        return format_datetime(when, "long", locale=self.locale)

    def _filled(self, text: str, values: Mapping[str, object]) -> Markup:
        written = {
            name: self.number(value) if isinstance(value, int | float) else value
            for name, value in values.items()
        }
        return Markup(text).format(**written)  # noqa: S704 -- our own text; values are escaped


@cache
def phrases(language: Language) -> Phrases:
    """The phrases of a language, read once."""
    return Phrases(language)


def wanted(asked: str | None, accepted: str | None) -> tuple[str, ...]:
    """The languages that a person wants, the dearest first.

    Args:
        asked: a language chosen by hand (`?lang=`).
        accepted: the header Accept-Language, such as `fi-FI, en;q=0.8`.
    """
    return (*([asked] if asked else []), *_by_weight(accepted or ""))


def best(languages: Sequence[Language], wanted: Iterable[str | None]) -> Language:
    """The first wanted language that there is, else the usual one, which stands first."""
    known = {str(language): language for language in languages}
    return next((known[one] for one in wanted if one in known), languages[0])


def _by_weight(accepted: str) -> list[str]:
    """The main languages of an Accept-Language header, the dearest first."""
    weighed: list[tuple[float, str]] = []
    for item in accepted.split(","):
        tag, *parameters = (piece.strip() for piece in item.split(";"))
        quality = next((p[2:] for p in parameters if p.startswith("q=")), "1")
        try:
            weight = float(quality)
        except ValueError:
            continue
        if weight > 0:
            weighed.append((weight, tag.split("-")[0].lower()))
    return [tag for _, tag in sorted(weighed, key=lambda one: -one[0])]


def read_catalog(language: Language) -> Catalog:
    """The catalog of a language as its file has it."""
    with catalog_path(language).open("rb") as file:
        return read_po(file, locale=language, abort_invalid=True)


def write_catalog(catalog: Catalog, language: Language) -> None:
    """Write a catalog as its file."""
    path = catalog_path(language)
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("wb") as file:
        write_po(file, catalog, width=100, include_lineno=False, ignore_obsolete=True)


def catalog_path(language: Language) -> Path:
    """Where the catalog of a language lies."""
    return LOCALES / language / "LC_MESSAGES" / "manner.po"


def _translations(catalog: Catalog) -> NullTranslations:
    compiled = BytesIO()
    write_mo(compiled, catalog)
    compiled.seek(0)
    return Translations(compiled)


def _used_by_scripts(catalog: Catalog) -> dict[str, str | list[str]]:
    """English text to translation, for what the TypeScript says; a list where there are plurals."""
    found: dict[str, str | list[str]] = {}
    for message in catalog:
        if any(path.startswith(SCRIPTS) for path, _ in message.locations):
            key = message.id if isinstance(message.id, str) else message.id[0]
            text = message.string
            found[key] = text if isinstance(text, str) else list(text or ())
    return found
