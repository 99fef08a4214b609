"""The participants' TypeScript says nothing that was not asked of the catalog."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html.parser import HTMLParser

import pytest

from app.settings import PROJECT

SOURCE = PROJECT / "static" / "src"
SPEAKING = sorted(
    path
    for folder in ("participant", "trials", "viewer")
    for path in (SOURCE / folder).rglob("*.ts")
    if not path.name.endswith(".test.ts") and path.name != "testing.ts"
)
NAMES = {"Manner", "X", "A", "B"}
HELD = "\x00"


class Said(HTMLParser):
    """The texts and the telling attributes of a piece of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_data(self, data: str) -> None:
        self.found.append(data)

    def handle_starttag(self, _: str, attributes: list[tuple[str, str | None]]) -> None:
        told = ("aria-label", "title", "placeholder", "alt", "aria-valuetext")
        self.found += [value or "" for name, value in attributes if name in told]


def templates(source: str) -> Iterator[str]:
    """Every `html` template of a script, with what is put into it left out."""
    for start in re.finditer(r"\bhtml`", source):
        yield _template(source, start.end())[1]


def _template(source: str, at: int) -> tuple[int, str]:
    """From behind the opening backtick: where it ends, and its own text."""
    text = ""
    while source[at] != "`":
        if source.startswith("${", at):
            at, text = _expression(source, at + 2), text + HELD
        else:
            step = 2 if source[at] == "\\" else 1
            at, text = at + step, text + source[at : at + step]
    return at + 1, text


def _expression(source: str, at: int) -> int:
    """From behind `${`: behind the brace that closes it."""
    depth = 1
    while depth:
        sign = source[at]
        if sign == "`":
            at = _template(source, at + 1)[0]
            continue
        if sign in "\"'":
            at = re.compile(rf"(?:[^{sign}\\]|\\.)*{sign}").match(source, at + 1).end()
            continue
        depth += {"{": 1, "}": -1}.get(sign, 0)
        at += 1
    return at


def unasked(source: str) -> list[str]:
    """What the templates of a script say by themselves."""
    found = []
    for template in templates(source):
        reader = Said()
        reader.feed(template)
        pieces = [piece.strip() for text in reader.found for piece in text.split(HELD)]
        found += [piece for piece in pieces if re.search(r"[^\W\d_]", piece)]
    return [piece for piece in found if piece not in NAMES]


@pytest.mark.parametrize("path", SPEAKING, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_a_script_for_participants_says_nothing_untranslated(path):
    assert unasked(path.read_text("utf-8")) == []


def test_what_a_script_says_by_itself_is_noticed():
    source = """html`<p title="Hello" class=${open ? `a ${b}` : "}"}>${t("Yes")} and
      ${list.map((one) => html`<b>No</b>`)}</p>`"""
    assert sorted(unasked(source)) == ["Hello", "No", "and"]
