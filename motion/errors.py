"""What can be wrong with motion data. Every message names the place and the mend."""


class MotionError(ValueError):
    """Motion data that cannot be used."""


class BvhSyntaxError(MotionError):
    """A BVH file that cannot be read.

    Attributes:
        line: 1-based line of the fault.
        column: 1-based column of the fault.
        problem: what is wrong there and what would mend it, without the place.
    """

    def __init__(self, problem: str, line: int, column: int = 1) -> None:
        super().__init__(f"Line {line}, column {column}: {problem}")
        self.problem = problem
        self.line = line
        self.column = column
