"""What can be wrong with motion data. Every message names the place and the mend."""

from __future__ import annotations

from dataclasses import dataclass


class MotionError(ValueError):
    """Motion data that cannot be used."""


@dataclass(frozen=True)
class Fault:
    """Where in a file something is wrong, in the words of who made the motion.

    Attributes:
        frame: 1-based frame, where the fault lies in the motion.
        joint: name of the joint that the faulty number moves.
        channel: name of its channel, such as ``Xrotation``.
        context: (line number, text) of the lines around the fault, cut to what is near.
        offer: name of the import option that would mend it, such as ``fill_gaps``.
    """

    frame: int | None = None
    joint: str | None = None
    channel: str | None = None
    context: tuple[tuple[int, str], ...] = ()
    offer: str | None = None


class BvhSyntaxError(MotionError):
    """A BVH file that cannot be read.

    Attributes:
        line: 1-based line of the fault.
        column: 1-based column of the fault.
        problem: what is wrong there and what would mend it, without the place.
        fault: frame, joint, channel, lines around it and an offered mend, as far as they apply.
    """

    def __init__(
        self, problem: str, line: int, column: int = 1, fault: Fault | None = None
    ) -> None:
        super().__init__(f"Line {line}, column {column}: {problem}")
        self.problem = problem
        self.line = line
        self.column = column
        self.fault = fault or Fault()


class RecipeError(MotionError):
    """A recipe that cannot be read, or cannot be applied to a clip.

    Attributes:
        message: what is wrong.
        where: the way to the place in the recipe's JSON, such as ``(0, "parameters", "path")``.
        mend: what to do about it.
    """

    def __init__(self, message: str, where: tuple[str | int, ...] = (), mend: str = "") -> None:
        super().__init__(f"{message} {mend}".rstrip())
        self.message = message
        self.where = where
        self.mend = mend
