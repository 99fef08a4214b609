"""The text of a study file, YAML or JSON, as plain data that still knows where it stood.

YAML is read event by event rather than by a loader: so nothing but plain data can come of it, what
stands there twice or more is told, depth is bounded, and each value keeps its line and column.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import yaml

MOST_BYTES = 2_000_000
DEEPEST = 30

Path: TypeAlias = tuple[str | int, ...]
Place: TypeAlias = tuple[int, int]  # line and column, both counted from 1

_Loader: type[Any] = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # the same, in C
# What YAML 1.1 reads otherwise than a person does: 010 is 8, 1:30 is 90, 1_000 is 1000.
_ODD_NUMBER = re.compile(r"[-+]?(0[0-7_]+|0[xXbB].*|\d[\d_]*(:[\d_.]+)+|\d[\d_]*_[\d_.]*)")
_JSON_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[\[\]{},:]|[^\s\[\]{},:"]+')
_UNSTORABLE = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f\ud800-\udfff]")


class StudyTextError(Exception):
    """The text cannot be read as data.

    Attributes:
        line, column: where, counted from 1.
        message, mend: what is wrong there, and what to do about it.
    """

    def __init__(self, place: Place, message: str, mend: str) -> None:
        super().__init__(message)
        self.line, self.column = place
        self.message = message
        self.mend = mend


@dataclass
class StudyText:
    """What a file says.

    Attributes:
        data: dicts, lists, text, numbers, truth values, None, and dates.
        places: path to where its value begins; for members of an object, their names.
        bare: path to how a value stood there that is no text but was written without quotes.
    """

    data: Any = None
    places: dict[Path, Place] = field(default_factory=dict)
    bare: dict[Path, str] = field(default_factory=dict)

    def place(self, path: Path) -> Place:
        """Where this stands, or the nearest around it that stands anywhere."""
        while path and path not in self.places:
            path = path[:-1]
        return self.places.get(path, (1, 1))


def read_text(text: str, name: str = "") -> StudyText:
    """The text as data; JSON if the name or the first sign says so.

    Raises:
        StudyTextError: it is too long, no YAML or JSON, or says something in two ways.
    """
    if len(text.encode(errors="surrogatepass")) > MOST_BYTES:
        message = f"The file has more than {MOST_BYTES // 1_000_000} MB."
        raise StudyTextError((1, 1), message, "A study file holds texts and names, no motions.")
    text = text.removeprefix("\ufeff")
    ending = name.lower().rpartition(".")[2]
    looks_so = ending not in ("yaml", "yml") and text.lstrip()[:1] in ("{", "[")
    is_json = ending == "json" or looks_so
    read = _read_json(text) if is_json else _read_yaml(text)
    if not isinstance(read.data, dict):
        message = "The file is empty." if read.data is None else "The file holds no members."
        raise StudyTextError((1, 1), message, "Begin with members such as slug: and title:.")
    return read


def unstorable(value: object, path: Path = ()) -> Iterator[tuple[Path, str]]:
    """What no database could store: path, and what is wrong there.

    Control characters, among them NUL, halves of characters, numbers without an end, and what is
    nested deeper than anything that reads it could follow.
    """
    if isinstance(value, dict | list | tuple):
        if len(path) > DEEPEST:
            yield path[:DEEPEST], f"This is more than {DEEPEST} levels deep."
            return
        members = value.items() if isinstance(value, dict) else enumerate(value)
        for key, one in members:
            if isinstance(key, str) and _UNSTORABLE.search(key):
                yield path, "A member's name holds a character that is not printable."
            yield from unstorable(one, (*path, key))
    elif message := _not_storable(value):
        yield path, message


def _not_storable(value: object) -> str | None:
    if isinstance(value, str) and (found := _UNSTORABLE.search(value)):
        return f"The text holds U+{ord(found[0]):04X}, which is no printable character."
    if isinstance(value, float) and not math.isfinite(value):
        return "Only finite numbers can be stored."
    if isinstance(value, int) and abs(value) >= 2**63:
        return "The number is too large."
    return None


class _Builder:
    """Puts values together as they come, bottom and top of a stack of open ones."""

    def __init__(self) -> None:
        self.read = StudyText()
        self._open: list[Any] = []
        self._path: list[str | int] = []
        self._key: list[str | None] = []

    def awaits_key(self) -> bool:
        return bool(self._open) and isinstance(self._open[-1], dict) and self._key[-1] is None

    def key(self, key: str, place: Place) -> None:
        if key in self._open[-1]:
            raise StudyTextError(place, f"“{short(key)}” is there twice.", "Keep one of the two.")
        self._key[-1] = key
        self.read.places[(*self._path, key)] = place

    def value(self, value: Any, place: Place, bare: str | None = None) -> None:  # noqa: ANN401 -- plain data
        path = self._next(value, place)
        if bare is not None:
            self.read.bare[path] = bare

    def begin(self, value: dict[str, Any] | list[Any], place: Place) -> None:
        if len(self._open) >= DEEPEST:
            message = f"This is more than {DEEPEST} levels deep."
            raise StudyTextError(place, message, "A study file has no more than ten.")
        path = self._next(value, place)
        self._path = list(path)
        self._open.append(value)
        self._key.append(None)

    def end(self) -> None:
        self._open.pop()
        self._key.pop()
        self._path = self._path[:-1]

    def _next(self, value: Any, place: Place) -> Path:  # noqa: ANN401 -- plain data
        if not self._open:
            self.read.data = value
            self.read.places[()] = place
            return ()
        inside = self._open[-1]
        if isinstance(inside, dict):
            key = self._key[-1]
            assert key is not None  # noqa: S101 -- keys and values take turns
            inside[key] = value
            self._key[-1] = None
            return (*self._path, key)
        inside.append(value)
        path = (*self._path, len(inside) - 1)
        self.read.places[path] = place
        return path


def _read_yaml(text: str) -> StudyText:
    builder = _Builder()
    scalars = yaml.SafeLoader("")
    documents = 0
    try:
        for event in yaml.parse(text, Loader=_Loader):
            documents += isinstance(event, yaml.DocumentStartEvent)
            if documents > 1:
                message = "A second document begins here."
                raise StudyTextError(_place(event), message, "Keep one study in a file.")
            _take(builder, scalars, event)
    except yaml.MarkedYAMLError as error:
        raise _told(error, text) from error
    except yaml.YAMLError as error:  # a character that is none
        message = f"This is no YAML: {short(str(error).splitlines()[0], 120)}."
        raise StudyTextError(_of_reader(error, text), message, "Take the character out.") from error
    return builder.read


def _take(builder: _Builder, scalars: yaml.SafeLoader, event: Any) -> None:  # noqa: ANN401 -- untyped
    place = _place(event)
    if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None):
        message = "The file repeats a part by & and *."
        mend = "Write the part out; put text in quotes that begins with & or *."
        raise StudyTextError(place, message, mend)
    if isinstance(event, yaml.ScalarEvent):
        _scalar(builder, scalars, event, place)
    elif isinstance(event, yaml.MappingStartEvent | yaml.SequenceStartEvent):
        _check_tag(event, place)
        if builder.awaits_key():
            raise StudyTextError(place, "A member's name is a list.", "Give a name before the :.")
        builder.begin({} if isinstance(event, yaml.MappingStartEvent) else [], place)
    elif isinstance(event, yaml.MappingEndEvent | yaml.SequenceEndEvent):
        builder.end()


def _check_tag(event: Any, place: Place) -> None:  # noqa: ANN401 -- PyYAML is untyped
    if event.tag is not None and event.tag != "!":
        message = f"The file asks for a value of the type {short(event.tag)}."
        raise StudyTextError(place, message, "Write plain text, numbers, lists and members.")


def _scalar(builder: _Builder, scalars: yaml.SafeLoader, event: Any, place: Place) -> None:  # noqa: ANN401
    _check_tag(event, place)
    written = event.value
    tag = scalars.resolve(yaml.ScalarNode, written, event.implicit)  # type: ignore[no-untyped-call]
    if tag in ("tag:yaml.org,2002:str", "tag:yaml.org,2002:value"):
        builder.key(written, place) if builder.awaits_key() else builder.value(written, place)
        return
    kind = tag.rpartition(":")[2]
    if builder.awaits_key():
        what = {"merge": "a reference", "null": "nothing"}.get(kind, f"a {_KINDS.get(kind, kind)}")
        message = f"YAML reads the name {short(written) or 'before the :'} as {what}."
        raise StudyTextError(place, message, quoted(written))
    if kind in ("int", "float") and _ODD_NUMBER.fullmatch(written):
        message = f"YAML does not read {short(written)} as it looks."
        raise StudyTextError(place, message, f"{quoted(written)} Or write a plain number.")
    try:
        value = scalars.construct_object(yaml.ScalarNode(tag, written))
    except (ValueError, OverflowError, yaml.YAMLError) as error:
        message = f"{short(written)} looks like a {_KINDS.get(kind, kind)} and is none."
        raise StudyTextError(place, message, quoted(written)) from error
    builder.value(value, place, written)


_KINDS = {"bool": "truth value", "int": "number", "float": "number", "timestamp": "date"}


def _place(event: Any) -> Place:  # noqa: ANN401 -- PyYAML is untyped
    return event.start_mark.line + 1, event.start_mark.column + 1


def _told(error: yaml.MarkedYAMLError, text: str) -> StudyTextError:
    mark = error.problem_mark or error.context_mark
    line, column = (mark.line, mark.column) if mark else (0, 0)
    sign = text.split("\n")[line][column : column + 1] if line < text.count("\n") + 1 else ""
    problem = short(error.problem or "it breaks off", 120)
    if "mapping values" in problem:
        mend = "Text with a colon in it needs quotes."
    elif sign == "\t":
        mend = "Indent by spaces, not by tabs."
    elif sign and sign in "%@`":
        mend = f"Text that begins with {sign} needs quotes."
    else:
        mend = "Look at this line and the one before: indentation, quotes, brackets, colons."
    return StudyTextError((line + 1, column + 1), f"This is no YAML: {problem}.", mend)


def _of_reader(error: yaml.YAMLError, text: str) -> Place:
    """Where the sign stands that YAML does not allow."""
    found = yaml.reader.Reader.NON_PRINTABLE.search(text)
    at = found.start() if found else int(getattr(error, "position", 0) or 0)
    return _line_and_column(text, at)


def _read_json(text: str) -> StudyText:
    try:
        json.loads(text, parse_constant=_no_constant)
    except json.JSONDecodeError as error:
        message = f"This is no JSON: {error.msg}."
        mend = "Look for a comma or a quote that is missing or too many just before."
        raise StudyTextError((error.lineno, error.colno), message, mend) from error
    except RecursionError as error:
        mend = "A study file has no more than ten."
        message = f"This is more than {DEEPEST} levels deep."
        raise StudyTextError((1, 1), message, mend) from error
    except ValueError as error:  # NaN, or a number of thousands of digits
        raise StudyTextError((1, 1), "A number cannot be read.", f"{error}.") from error
    return _placed(text)


def _placed(text: str) -> StudyText:
    """Valid JSON as data with its places."""
    builder = _Builder()
    line, begins, seen = 1, 0, 0
    for token in _JSON_TOKEN.finditer(text):
        breaks = text.count("\n", seen, token.start())
        if breaks:
            line, begins = line + breaks, text.rindex("\n", seen, token.start()) + 1
        seen = token.start()
        _take_json(builder, token[0], (line, token.start() - begins + 1))
    return builder.read


def _take_json(builder: _Builder, written: str, place: Place) -> None:
    if written in ",:":
        return
    if written in "{[":
        builder.begin({} if written == "{" else [], place)
    elif written in "}]":
        builder.end()
    elif builder.awaits_key():
        builder.key(json.loads(written), place)
    elif written[0] == '"':
        builder.value(json.loads(written), place)
    else:
        builder.value(json.loads(written), place, written)


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is no number of JSON")


def _line_and_column(text: str, at: int) -> Place:
    return text.count("\n", 0, at) + 1, at - (text.rfind("\n", 0, at) + 1) + 1


def short(text: str, most: int = 60) -> str:
    """As much of a text as a message can show, on one line, without signs that do things."""
    line = "".join(sign if sign.isprintable() else "·" for sign in text[: most + 1])
    return line if len(line) <= most else f"{line[: most - 1]}…"


def quoted(written: str) -> str:
    """What to do about text that YAML takes for something else."""
    return f'Put it in quotes: "{written}".' if len(written) <= 60 else "Put it in quotes."
