"""Findings: what is wrong, where in time and by how much."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_closing

from motion.editing.foot_plants import runs

Array = NDArray[np.float64]

_MERGE = 0.1  # s: a fault that pauses for less is one fault
_ROUNDING = 1e-6  # of a limit, above which a difference is no rounding


@dataclass(frozen=True)
class Finding:
    """One fault.

    Attributes:
        kind: such as "foot slip".
        part: the body part in words, such as "left foot".
        start, end: s, from the first to the last frame that shows it.
        size: the worst value in that time.
        unit: of size and limit.
        limit: what would have been allowed; the original's own value where that is greater.
    """

    kind: str
    part: str
    start: float
    end: float
    size: float
    unit: str
    limit: float


@dataclass(frozen=True)
class QualityReport:
    """Everything found in an edited clip, in order of time."""

    findings: tuple[Finding, ...]

    @property
    def clean(self) -> bool:
        """Whether nothing was found."""
        return not self.findings

    def to_dict(self) -> dict[str, object]:
        """As plain values, for JSON."""
        return {"clean": self.clean, "findings": [asdict(finding) for finding in self.findings]}


@dataclass(frozen=True)
class Measure:
    """A quantity over time that must not pass its limit.

    Attributes:
        kind, part, unit: as in ``Finding``.
        values: (T,) of the edited clip.
        limit: one for all frames.
    """

    kind: str
    part: str
    unit: str
    values: Array
    limit: float

    def findings(self, frame_time: float) -> Iterator[Finding]:
        """One finding for each stretch of time above the limit."""
        above = self.values > self.limit * (1.0 + _ROUNDING) + 1e-9
        gap = 2 * round(_MERGE / frame_time / 2.0) + 1
        padded = np.pad(above, gap)
        joined = binary_closing(padded, np.ones(gap, dtype=bool))[gap:-gap] | above
        for run in runs(joined):
            yield Finding(
                self.kind,
                self.part,
                start=run.start * frame_time,
                end=(run.stop - 1) * frame_time,
                size=float(self.values[run].max()),
                unit=self.unit,
                limit=float(self.limit),
            )


def in_words(role: str) -> str:
    """A body role as people say it: "left upper arm"."""
    return role.replace("_", " ")
