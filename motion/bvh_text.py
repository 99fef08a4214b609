"""The text of a BVH file: limits, encoding, tokens and places in it."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace

from motion.errors import BvhSyntaxError, Fault

_TOKEN = re.compile(rb"[{}]|[^\s{}]+")
_REST_OF_LINE = re.compile(rb"[^\r\n]*")
# A brace that opens a block, not the second byte of a Japanese character in Shift JIS.
_OPENING_BRACE = re.compile(rb"(?<![\x80-\xff])\{")
LARGEST = 1e30  # a number beyond, or its square, would not fit what is computed and written later
_CONTEXT_WIDTH = 64  # characters of a line shown around a fault


@dataclass(frozen=True)
class Note:
    """One line of an import report.

    Attributes:
        text: what was found and done, or the question.
        line: 1-based line of the file, if it has one.
        where: the place in short words, for display: "line 4 ff.", "21 joints".
        offer: name of the import option that would do it otherwise.
    """

    text: str
    line: int | None = None
    where: str | None = None
    offer: str | None = None


@dataclass(frozen=True)
class Limits:
    """What a file may hold at most; checked before anything is allocated."""

    bytes: int = 100_000_000
    joints: int = 2_000
    depth: int = 200
    frames: int = 1_000_000


def normalise_text(data: bytes, limits: Limits) -> tuple[bytes, list[Note]]:
    """The file without a byte order mark, its lines ended by line feeds.

    Raises:
        BvhSyntaxError: if the file is larger than the limit, or no 8-bit text.
    """
    if len(data) > limits.bytes:
        raise BvhSyntaxError(
            f"The file has {len(data) / 1e6:.0f} MB; at most {limits.bytes / 1e6:.0f} MB are read. "
            "Cut the motion into parts.",
            1,
        )
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise BvhSyntaxError("The file is UTF-16 text. Save it as UTF-8.", 1)
    notes = []
    if data.startswith(b"\xef\xbb\xbf"):
        data = data[3:]
        notes.append(Note("A byte order mark before the text was left out", 1, "line 1"))
    if b"\n" not in data and b"\r" in data:
        data = data.replace(b"\r", b"\n")
        notes.append(Note("Lines ended by carriage returns alone were read as lines"))
    return data, notes


def decode_name(name: bytes) -> tuple[str, bool]:
    """A joint's name, and whether it was UTF-8 (otherwise it is read as Latin-1)."""
    try:
        return name.decode("utf-8"), True
    except UnicodeDecodeError:
        return name.decode("latin-1"), False


def place(data: bytes, offset: int) -> tuple[int, int]:
    """1-based (line, column) of a byte offset."""
    line_start = data.rfind(b"\n", 0, offset) + 1
    return data.count(b"\n", 0, offset) + 1, offset - line_start + 1


def fault_at(data: bytes, offset: int, problem: str, fault: Fault | None = None) -> BvhSyntaxError:
    """An error at a byte offset, with the lines around it."""
    line, column = place(data, offset)
    context = _context(data, offset, line, column)
    return BvhSyntaxError(problem, line, column, replace(fault or Fault(), context=context))


def _context(data: bytes, offset: int, line: int, column: int) -> tuple[tuple[int, str], ...]:
    start = data.rfind(b"\n", 0, offset) + 1
    before = data.rfind(b"\n", 0, max(start - 1, 0)) + 1
    lines, begin = [], before if start else start
    for number in range(line - 1 if start else line, line + 2):
        if begin >= len(data):
            break
        end = data.find(b"\n", begin)
        end = len(data) if end < 0 else end
        lines.append((number, _excerpt(data, begin, end, column)))
        begin = end + 1
    return tuple(lines)


def _excerpt(data: bytes, begin: int, end: int, column: int) -> str:
    """The part of a line around a column, cut at spaces, … where something is left out."""
    first = begin + max(column - 1 - _CONTEXT_WIDTH // 2, 0)
    last = min(first + _CONTEXT_WIDTH, end)
    if begin < first < end:
        first = (data.find(b" ", first, last) + 1) or first
    if first < last < end:
        last = max(data.rfind(b" ", first, last), first) or last
    text = data[first:last].decode("latin-1").strip()
    return ("… " if first > begin else "") + text + (" …" if last < end else "")


class Scanner:
    """Walks over tokens separated by white space; braces are tokens of their own."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.position = 0
        self.start = 0  # of the token read last
        self.decimal_comma: int | None = None  # offset of the first number with one
        self.decimal_point = False

    def next(self) -> bytes:
        """The next token, empty at the end of the text."""
        match = _TOKEN.search(self.data, self.position)
        if match is None:
            self.start = self.position = len(self.data)
            return b""
        self.start, self.position = match.span()
        return match.group()

    def peek(self) -> bytes:
        """The next token without moving on."""
        position, start = self.position, self.start
        token = self.next()
        self.position, self.start = position, start
        return token

    def rest_of_line(self) -> bytes:
        """What follows on this line, up to an opening brace, without white space around it."""
        match = _REST_OF_LINE.match(self.data, self.position)
        text = match.group() if match else b""
        if brace := _OPENING_BRACE.search(text):
            text = text[: brace.start()]
        self.position += len(text)
        return text.strip()

    def expect(self, token: bytes, why: str) -> None:
        """Move over ``token`` (any case) or raise, saying ``why`` it must stand here."""
        found = self.next()
        if found.upper() != token:
            raise self.error(f"Expected {token.decode()} {why}, found {quote(found)}.")

    def number(self, what: str) -> float:
        """The next token as a decimal number of usable size."""
        token = self.next()
        if b"," in token and b"." not in token:
            self.decimal_comma = self.start if self.decimal_comma is None else self.decimal_comma
            token = token.replace(b",", b".")
        elif b"." in token:
            self.decimal_point = True
        try:
            value = float(token) if b"_" not in token else math.nan
        except ValueError:
            value = math.nan
        if not abs(value) <= LARGEST:
            raise self.error(f"Expected a number for {what}, found {quote(token)}.")
        return value

    def whole_number(self, what: str) -> int:
        """The next token as a whole number."""
        value = self.number(what)
        if not value.is_integer():
            raise self.error(f"Expected a whole number for {what}, found {value}.")
        return int(value)

    def error(self, problem: str) -> BvhSyntaxError:
        """An error at the token read last."""
        return fault_at(self.data, self.start, problem)

    def line(self) -> int:
        """1-based line of the token read last."""
        return place(self.data, self.start)[0]


def counted(number: int, thing: str) -> str:
    """A number of things in words: "1 joint", "21 joints"."""
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"


def quote(token: bytes) -> str:
    """A token for a message, shortened."""
    if not token:
        return "the end of the file"
    text = token[:30].decode("latin-1")
    return f"“{text}…”" if len(token) > 30 else f"“{text}”"
