"""The HIERARCHY part of a BVH file."""

from __future__ import annotations

from dataclasses import dataclass, field

from motion.bvh_text import Limits, Note, Scanner, decode_name, place, quote

Vector = tuple[float, float, float]

_CHANNELS = {
    f"{axis}{kind}".upper().encode(): f"{axis}{kind}"
    for axis in "XYZ"
    for kind in ("position", "rotation")
}


@dataclass(frozen=True)
class BvhJoint:
    """One ROOT or JOINT.

    Attributes:
        name: as written.
        parent: index of the parent, -1 for a root.
        offset: position in the parent's frame, file units.
        channels: names in the file's order, such as ``Zrotation``.
        column: column of the first channel among the file's values.
        line: 1-based line of the joint's name.
    """

    name: str
    parent: int
    offset: Vector
    channels: tuple[str, ...]
    column: int
    line: int


@dataclass(frozen=True)
class BvhTip:
    """One End Site: the joint that carries it and its offset, file units."""

    joint: int
    offset: Vector


@dataclass
class _Open:
    """A joint or end site while it is being read."""

    name: str
    parent: int
    start: int
    tip: bool = False
    offset: Vector | None = None
    channels: tuple[str, ...] | None = None
    index: int = field(default=-1)


def read_hierarchy(
    scanner: Scanner, limits: Limits, notes: list[Note]
) -> tuple[tuple[BvhJoint, ...], tuple[BvhTip, ...]]:
    """Read up to MOTION or the end of the text, leaving the scanner after it.

    Raises:
        BvhSyntaxError: if the text is no hierarchy or passes a limit.
    """
    return _HierarchyReader(scanner, limits, notes).read()


class _HierarchyReader:
    def __init__(self, scanner: Scanner, limits: Limits, notes: list[Note]) -> None:
        self.scanner = scanner
        self.limits = limits
        self.notes = notes
        self.nodes: list[_Open] = []
        self.stack: list[_Open] = []
        self.joint_count = 0
        self.other_encoding: int | None = None

    def read(self) -> tuple[tuple[BvhJoint, ...], tuple[BvhTip, ...]]:
        first = self.scanner.peek()
        if not first:
            raise self.scanner.error("The file is empty: this is not a BVH file.")
        if first.upper() == b"HIERARCHY":
            self.scanner.next()
        elif first.upper() != b"ROOT":
            self.scanner.next()
            raise self.scanner.error(
                f"Expected HIERARCHY, found {quote(first)}: this is not a BVH file."
            )
        while (token := self.scanner.next()) and token.upper() != b"MOTION":
            self._step(token)
        if self.stack:
            raise self.scanner.error(
                f"“{self.stack[-1].name}”, opened on line {self._line(self.stack[-1])}, is not "
                "closed before this. Add the missing }."
            )
        if not self.joint_count:
            raise self.scanner.error("The hierarchy has no ROOT, so there is nothing to read.")
        self._note_names()
        return self._finish()

    def _step(self, token: bytes) -> None:
        keyword = token.upper()
        if keyword == b"}":
            if not self.stack:
                raise self.scanner.error("This } closes nothing. Take it out.")
            self.stack.pop()
        elif keyword == (b"JOINT" if self.stack else b"ROOT") and not self._inside_tip():
            self._open_joint()
        elif keyword in (b"END", b"ENDSITE") and self.stack and not self._inside_tip():
            self._open_tip(keyword)
        elif keyword == b"OFFSET" and self.stack and self.stack[-1].offset is None:
            what = f"the OFFSET of “{self.stack[-1].name}”"
            number = self.scanner.number
            self.stack[-1].offset = (number(what), number(what), number(what))
        elif keyword == b"CHANNELS" and self.stack and self.stack[-1].channels is None:
            self.stack[-1].channels = self._channels(self.stack[-1])
        else:
            raise self.scanner.error(self._unexpected(token))

    def _inside_tip(self) -> bool:
        return bool(self.stack) and self.stack[-1].tip

    def _unexpected(self, token: bytes) -> str:
        if not self.stack:
            return f"Expected ROOT or MOTION, found {quote(token)}."
        node = self.stack[-1]
        allowed = "OFFSET or }" if node.tip else "OFFSET, CHANNELS, JOINT, End Site or }"
        return f"Expected {allowed} (once each) in “{node.name}”, found {quote(token)}."

    def _open_joint(self) -> None:
        if self.joint_count >= self.limits.joints:
            raise self.scanner.error(f"More than {self.limits.joints} joints are not read.")
        start = self.scanner.start
        text = self.scanner.rest_of_line()
        name, plain = decode_name(text)
        if not plain and self.other_encoding is None:
            self.other_encoding = place(self.scanner.data, start)[0]
        if not name:
            name = f"joint_{self.joint_count + 1}"
            line = place(self.scanner.data, start)[0]
            self.notes.append(
                Note(f"A joint without a name is called “{name}”", line, f"line {line}")
            )
        parent = self.stack[-1].index if self.stack else -1
        self._open(_Open(name, parent, start, index=self.joint_count))
        self.joint_count += 1

    def _open_tip(self, keyword: bytes) -> None:
        start = self.scanner.start
        if keyword == b"END":
            self.scanner.expect(b"SITE", "after End")
        self.scanner.rest_of_line()  # some writers name their end sites
        self._open(
            _Open(f"End Site of {self.stack[-1].name}", self.stack[-1].index, start, tip=True)
        )

    def _open(self, node: _Open) -> None:
        if len(self.stack) >= self.limits.depth:
            raise self.scanner.error(f"Joints nested deeper than {self.limits.depth} are not read.")
        if len(self.nodes) >= 4 * self.limits.joints:
            raise self.scanner.error(f"More than {4 * self.limits.joints} end sites are not read.")
        self.scanner.expect(b"{", f"after “{node.name}”")
        self.nodes.append(node)
        self.stack.append(node)

    def _channels(self, node: _Open) -> tuple[str, ...]:
        count = self.scanner.whole_number(f"the number of CHANNELS of “{node.name}”")
        if not 0 <= count <= 6 or (node.tip and count):
            raise self.scanner.error(
                f"“{node.name}” cannot have {count} channels; an end site has none, a joint 0 to 6."
            )
        names = []
        for _ in range(count):
            token = self.scanner.next()
            name = _CHANNELS.get(token.upper())
            if name is None:
                raise self.scanner.error(
                    f"Expected {count} channels such as Xposition or Zrotation for “{node.name}”, "
                    f"found {quote(token)}."
                )
            names.append(name)
        return tuple(names)

    def _note_names(self) -> None:
        if self.other_encoding is not None:
            text = "Names that are not UTF-8 were read as Latin-1"
            self.notes.append(Note(text, self.other_encoding, f"line {self.other_encoding} ff."))

    def _line(self, node: _Open) -> int:
        return place(self.scanner.data, node.start)[0]

    def _finish(self) -> tuple[tuple[BvhJoint, ...], tuple[BvhTip, ...]]:
        joints: list[BvhJoint] = []
        tips: list[BvhTip] = []
        column = 0
        for node in self.nodes:
            if node.offset is None and not node.tip:
                line = self._line(node)
                text = f"“{node.name}” has no OFFSET; it is taken as 0 0 0"
                self.notes.append(Note(text, line, f"line {line}"))
            offset = node.offset or (0.0, 0.0, 0.0)
            if node.tip:
                tips.append(BvhTip(node.parent, offset))
                continue
            channels = node.channels or ()
            joints.append(
                BvhJoint(node.name, node.parent, offset, channels, column, self._line(node))
            )
            column += len(channels)
        return tuple(joints), tuple(tips)


def describe_channel(joints: tuple[BvhJoint, ...], column: int) -> tuple[str, str]:
    """(joint, channel) names of a column of the motion's values.

    Raises:
        IndexError: for a column that no joint has.
    """
    for joint in joints:
        if joint.column <= column < joint.column + len(joint.channels):
            return joint.name, joint.channels[column - joint.column]
    raise IndexError(column)
