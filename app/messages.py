"""Collects what the interface says to participants and brings the catalogs up to date.

`make messages` runs this. Templates say `_("…")` and `ngettext("…", "…", n)`, TypeScript says
`t("…")` and `tn("…", "…", n)`, and `app/error_texts.py` lists the answers to errors.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_file

from app import error_texts, i18n
from app.settings import PROJECT

TEMPLATES = (
    "base.html", "error.html", "no_webgl.html", "single.html", "macros/languages.html",
    "participant/*.html",
)  # fmt: skip
# A text in double quotes, or several that are put together with +.
_LITERAL = r'"(?:[^"\\\n]|\\.)*"(?:\s*\+\s*"(?:[^"\\\n]|\\.)*")*'
_CALL = re.compile(
    rf"(?<![\w.$#])(?P<name>tn?)\(\s*(?:(?P<first>{_LITERAL})\s*(?:,\s*(?P<second>{_LITERAL}))?)?"
)
_IMPORT = re.compile(r'import \{[^}]*\btn?\b[^}]*\} from "[./]+/words"')
Found = tuple[str, str | tuple[str, str]]


def collect() -> Catalog:
    """A catalog of all messages with the files that say them, and no translations.

    Raises:
        ValueError: TypeScript asks for a text that does not stand there literally.
    """
    catalog = Catalog(project="Manner")
    for path, message in sorted({*_of_templates(), *_of_scripts(), *_of_errors()}, key=str):
        catalog.add(message, locations=[(path, 0)])
    return catalog


def update() -> None:
    """Add new messages to every catalog and drop those that nobody says any more.

    A language that has no catalog yet gets an empty one.
    """
    template = collect()
    for language in i18n.TRANSLATED:
        is_new = not i18n.catalog_path(language).exists()
        catalog = Catalog(language, project="Manner") if is_new else i18n.read_catalog(language)
        catalog.update(template, no_fuzzy_matching=True, update_creation_date=False)
        i18n.write_catalog(catalog, language)


def in_script(source: str) -> Iterator[str | tuple[str, str]]:
    """The messages of a TypeScript source, in their order.

    Raises:
        ValueError: a message does not stand there literally.
    """
    for call in _CALL.finditer(source):
        plural = call["name"] == "tn"
        if call["first"] is None or (plural and call["second"] is None):
            line = source.count("\n", 0, call.start()) + 1
            raise ValueError(f"line {line}: give {call['name']}() its text literally")
        first = _joined(call["first"])
        yield (first, _joined(call["second"])) if plural else first


def _joined(literals: str) -> str:
    """The text of `"…" + "…"`."""
    found: list[str] = re.findall(r'"(?:[^"\\\n]|\\.)*"', literals)
    return "".join(json.loads(literal) for literal in found)


def _of_templates() -> Iterator[Found]:
    folder = PROJECT / "templates"
    for pattern in TEMPLATES:
        for path in sorted(folder.glob(pattern)):
            for _, message, _, _ in extract_from_file(
                "jinja2", path, keywords={"_": None, "ngettext": (1, 2)}, options={"silent": "no"}
            ):
                yield _name(path), message if isinstance(message, str) else (message[0], message[1])


def _of_scripts() -> Iterator[Found]:
    for path in sorted((PROJECT / i18n.SCRIPTS).rglob("*.ts")):
        source = path.read_text("utf-8")
        if path.name.endswith(".test.ts") or not _IMPORT.search(source):
            continue
        try:
            yield from ((_name(path), message) for message in in_script(source))
        except ValueError as error:
            raise ValueError(f"{_name(path)}, {error}") from None


def _of_errors() -> Iterator[Found]:
    for text in error_texts.all_texts():
        yield "app/error_texts.py", text


def _name(path: Path) -> str:
    return path.relative_to(PROJECT).as_posix()


if __name__ == "__main__":
    update()
