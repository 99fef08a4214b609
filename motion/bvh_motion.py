"""The MOTION part of a BVH file."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.bvh_hierarchy import BvhJoint, describe_channel
from motion.bvh_numbers import BadNumberError, Numbers, parse_numbers
from motion.bvh_text import LARGEST, Limits, Note, Scanner, counted, fault_at, place, quote
from motion.errors import BvhSyntaxError, Fault

Array = NDArray[np.float64]

_FRAMES = re.compile(rb"\s*+frames\s*+:?", re.IGNORECASE)
_FRAME_TIME = re.compile(rb"\s*+frame\s*+time\s*+:?", re.IGNORECASE)
_NUMBER = re.compile(rb"\S+")
_RATES = (24, 25, 30, 48, 50, 60, 72, 75, 90, 100, 120, 144, 150, 200, 240, 250)


@dataclass(frozen=True)
class BvhMotion:
    """(T, C) values, seconds a frame and the line of the first frame; no line, no motion."""

    values: Array
    frame_time: float | None
    line: int | None


def read_motion(
    scanner: Scanner,
    joints: tuple[BvhJoint, ...],
    limits: Limits,
    notes: list[Note],
    fill_gaps: bool,
    frame_time: float | None,
) -> BvhMotion:
    """Read from behind MOTION to the end of the text.

    Raises:
        BvhSyntaxError: if frame time or values cannot be read.
    """
    channels = sum(len(joint.channels) for joint in joints)
    if not scanner.peek():
        notes.append(Note("The file has a skeleton but no motion"))
        return BvhMotion(np.empty((0, channels)), frame_time, None)
    _keyword(scanner, _FRAMES, "Frames:")
    declared = scanner.whole_number("the number of Frames")
    frames_line = scanner.line()
    seconds = _read_frame_time(scanner, notes, frame_time)
    if not scanner.peek():
        notes.append(
            Note("The file has a skeleton but no frames", frames_line, f"line {frames_line}")
        )
        return BvhMotion(np.empty((0, channels)), seconds, None)
    reader = _ValueReader(scanner, joints, channels, limits, notes)
    values = reader.read()
    if fill_gaps:
        reader.fill(values)
    else:
        reader.refuse_gaps(values)
    _note_frames(notes, declared, len(values), frames_line)
    return BvhMotion(values, seconds, reader.first_line)


def _keyword(scanner: Scanner, pattern: re.Pattern[bytes], word: str) -> None:
    match = pattern.match(scanner.data, scanner.position)
    if match is None:
        found = scanner.next()
        raise scanner.error(f"Expected “{word}” after MOTION, found {quote(found)}.")
    scanner.position = match.end()


def _read_frame_time(scanner: Scanner, notes: list[Note], given: float | None) -> float:
    _keyword(scanner, _FRAME_TIME, "Frame Time:")
    seconds = scanner.number("the Frame Time")
    line = scanner.line()
    written = scanner.data[scanner.start : scanner.position].decode("latin-1")
    if given is not None:
        notes.append(
            Note(f"Frame time {given:g} s used instead of {written}", line, f"line {line}")
        )
        return given
    if seconds <= 0:
        problem = f"The frame time must be above 0 s, not {written}. 1/30 s is 0.0333333."
        raise fault_at(scanner.data, scanner.start, problem, Fault(offer="frame_time"))
    rate = next((rate for rate in _RATES if 0 < abs(seconds * rate - 1) < 2e-3), None)
    if rate is not None:
        text = f"Frame time {written} kept as written (1/{rate} s offered)"
        notes.append(Note(text, line, f"line {line}", offer="frame_time"))
    return seconds


def _note_frames(notes: list[Note], declared: int, present: int, line: int) -> None:
    if declared != present:
        many = f"{declared:,}".replace(",", " ")
        text = f"{many} frames declared, {present} complete ones present and read"
        notes.append(Note(text, line, f"line {line}"))


class _ValueReader:
    """Numbers after the frame time, as rows of one frame each."""

    def __init__(
        self,
        scanner: Scanner,
        joints: tuple[BvhJoint, ...],
        channels: int,
        limits: Limits,
        notes: list[Note],
    ) -> None:
        self.data = scanner.data
        self.start = scanner.position
        self.joints = joints
        self.channels = channels
        self.limits = limits
        self.notes = notes
        scanner.next()
        self.first_line = scanner.line()
        self._settle_decimal_marks(scanner)

    def _settle_decimal_marks(self, scanner: Scanner) -> None:
        comma = self.data.find(b",", self.start)
        if comma < 0 and scanner.decimal_comma is None:
            return
        place_of_comma = comma if scanner.decimal_comma is None else scanner.decimal_comma
        if scanner.decimal_point or b"." in self.data[self.start :]:
            raise fault_at(
                self.data,
                place_of_comma,
                "Numbers with decimal commas stand beside numbers with decimal points. "
                "Write all with points.",
            )
        text = "Decimal commas were read as decimal points"
        line = place(self.data, place_of_comma)[0]
        self.notes.append(Note(text, line, f"line {line} ff."))
        self.data = self.data[: self.start] + self.data[self.start :].replace(b",", b".")

    def read(self) -> Array:
        """(T, C) values; some may be not finite."""
        self._check_size()
        try:
            numbers = parse_numbers(self.data, self.start)
        except BadNumberError as error:
            problem = f"{quote(error.token)} is not a number."
            raise self._fault(error.start, error.index, problem) from None
        rows, left = divmod(len(numbers.values), self.channels)
        self._check_rows(numbers, rows, left)
        return numbers.values[: rows * self.channels].reshape(rows, self.channels)

    def _check_size(self) -> None:
        if not self.channels:
            raise fault_at(self.data, self.start, "There is motion, but no joint has CHANNELS.")
        # Each value takes two bytes at least, and each line of a wrapped frame holds one.
        most = (len(self.data) - self.start) // (2 * self.channels)
        if most <= self.limits.frames:
            return
        lines = self.data.count(b"\n", self.start)
        if lines > self.limits.frames * self.channels:
            raise fault_at(
                self.data, self.start, f"More than {self.limits.frames} frames are not read."
            )

    def _check_rows(self, numbers: Numbers, rows: int, left: int) -> None:
        if rows > self.limits.frames:
            problem = f"{rows} frames; more than {self.limits.frames} are not read. Cut the motion."
            raise fault_at(self.data, self.start, problem)
        counts = np.diff(numbers.line_ends, prepend=0, append=len(numbers.values))
        filled = counts[counts > 0]
        if (filled[:-1] == self.channels).all() and filled[-1:] <= self.channels:
            pass
        elif self._rows_begin_lines(numbers, rows):
            self.notes.append(
                Note("Frames that run over several lines were joined", self.first_line)
            )
        elif np.count_nonzero(filled == self.channels) * 2 > len(filled):
            self._refuse_row(numbers, counts)
        else:
            text = "Lines do not tell frames apart; frames were counted off by their values"
            self.notes.append(Note(text, self.first_line, f"line {self.first_line} ff."))
        if left:
            line = self._line_of(numbers, rows * self.channels)
            text = f"The last frame has {left} of {self.channels} values and was left out"
            self.notes.append(Note(text, line, f"line {line}"))

    def _rows_begin_lines(self, numbers: Numbers, rows: int) -> bool:
        frame_ends = np.arange(1, rows + 1) * self.channels
        ends = np.append(numbers.line_ends, len(numbers.values))
        return bool(np.isin(frame_ends, ends).all())

    def _refuse_row(self, numbers: Numbers, counts: NDArray[np.intp]) -> None:
        lines = np.flatnonzero((counts > 0) & (counts != self.channels))
        offset = self._offset_of_line(int(lines[0]))
        frame = int(numbers.line_ends[lines[0] - 1] // self.channels) + 1 if lines[0] else 1
        problem = (
            f"This frame has {counts[lines[0]]} values; the channels ask for {self.channels}. "
            "Add what is missing or take the line out."
        )
        raise fault_at(self.data, offset, problem, Fault(frame=frame))

    def _line_of(self, numbers: Numbers, index: int) -> int:
        """1-based line of the value with this index."""
        skipped = int(np.searchsorted(numbers.line_ends, index, side="right"))
        return place(self.data, self.start)[0] + skipped

    def _offset_of_line(self, skipped: int) -> int:
        """Where the line after ``skipped`` line breaks behind the start begins."""
        if not skipped:
            return self.start
        breaks = np.flatnonzero(np.frombuffer(self.data, np.uint8, offset=self.start) == ord("\n"))
        return self.start + int(breaks[skipped - 1]) + 1

    def _fault(
        self, offset: int, index: int, problem: str, offer: str | None = None
    ) -> BvhSyntaxError:
        frame, column = divmod(index, self.channels)
        joint, channel = describe_channel(self.joints, column)
        fault = Fault(frame + 1, joint, channel, offer=offer)
        problem = f"frame {frame + 1}, {joint}, {channel}: {problem}"
        return fault_at(self.data, offset, problem, fault)

    def refuse_gaps(self, values: Array) -> None:
        """Raise at the first value that is no usable number."""
        # False with a NaN among them. Two passes without memory of their own: most files end here.
        if values.min(initial=0.0) >= -LARGEST and values.max(initial=0.0) <= LARGEST:
            return
        index = int(np.flatnonzero(_gaps(values))[0])
        match = next(
            match
            for count, match in enumerate(_NUMBER.finditer(self.data, self.start))
            if count == index
        )
        problem = (
            f"{quote(match.group())} is not a finite number of usable size. Import with gaps "
            "filled, or mend the value in the program that wrote it."
        )
        raise self._fault(match.start(), index, problem, "fill_gaps")

    def fill(self, values: Array) -> None:
        """Replace what is no usable number by interpolation in time, in place.

        Raises:
            BvhSyntaxError: if a channel has no usable value at all.
        """
        gaps = _gaps(values)
        frames = np.arange(len(values))
        for column in np.flatnonzero(gaps.any(axis=0)):
            joint, channel = describe_channel(self.joints, int(column))
            known = frames[~gaps[:, column]]
            if not len(known):
                raise fault_at(self.data, self.start, f"{joint}, {channel}: no value is a number.")
            series = values[known, column]
            if channel.endswith("rotation"):
                series = np.unwrap(series, period=360.0)
            values[:, column] = np.interp(frames, known, series)
            missing = np.flatnonzero(gaps[:, column])
            spread = f"frame {missing[0] + 1}" + (" ff." if len(missing) > 1 else "")
            what = counted(len(missing), "missing value")
            text = f"{what} of {joint}, {channel} filled by interpolation"
            self.notes.append(Note(text, where=spread))


def _gaps(values: Array) -> NDArray[np.bool_]:
    """Which values (T, C) are missing, infinite or too large to compute with."""
    return ~(np.abs(values) <= LARGEST)
