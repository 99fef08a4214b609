"""Is a pole of a scale seen at all? Its best clip against the other clips (Förger, figure 31)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.statistics.intervals import Effect, Samples, cohens_d
from app.statistics.tests import TTest, paired, welch

Against = Literal["others", "all"]


@dataclass(frozen=True)
class BestClip:
    """The clip that was seen nearest to a pole, and how it differs from the rest of its body.

    `mean` and `rest_mean` count toward the pole. A test is None where it is undefined.
    """

    clip: int
    mean: float
    rest_mean: float
    welch: TTest | None
    effect: Effect | None
    paired: TTest | None


def best_clip(
    toward: Samples, bodies: Sequence[str], against: Against = "others"
) -> BestClip | None:
    """Test the clip with the highest mean against the clips that the same body plays.

    The clip is the best of all bodies' clips; the first in the study's order wins a tie.

    Args:
        toward: (participants, clips) answers on one axis, counted toward the pole; NaN missing.
        bodies: which body each clip shows, one a clip.
        against: "others" leaves the best clip out of its comparison group, so that the two
            groups are independent as Welch's test asks; "all" keeps it in, as the thesis does.

    Returns:
        None where there is no answer, or the body has no other clip.
    """
    if toward.size == 0 or np.isnan(toward).all():
        return None
    means = np.array([_mean(column) for column in toward.T])
    best = int(np.nanargmax(means))
    rest = _comparison(best, bodies, against)
    if not rest.any() or np.isnan(toward[:, rest]).all():
        return None
    chosen, others = toward[:, best], toward[:, rest]
    return BestClip(
        clip=best,
        mean=float(means[best]),
        rest_mean=_mean(others),
        welch=welch(chosen, others),
        effect=cohens_d(chosen, others),
        paired=paired(chosen, np.array([_mean(row) for row in others])),
    )


def _comparison(best: int, bodies: Sequence[str], against: Against) -> NDArray[np.bool_]:
    """Which clips the best one is compared with, as a mask (clips,)."""
    same = np.array([body == bodies[best] for body in bodies])
    if against == "others":
        same[best] = False
    return same


def _mean(values: Samples) -> float:
    """Mean of what is there; NaN where nothing is (without NumPy's warning)."""
    there = values[~np.isnan(values)]
    return float(there.mean()) if there.size else float("nan")
