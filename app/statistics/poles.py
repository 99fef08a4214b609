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


def chance_of_best(
    toward: Samples,
    bodies: Sequence[str],
    generator: np.random.Generator,
    against: Against = "others",
    draws: int = 1999,
) -> float | None:
    """Permutation test that repeats the choice of the best clip.

    A clip that was chosen for its mean would stand out even if all clips were seen alike. Here
    each participant's answers change places at random among the clips of a body, the best clip is
    chosen anew, and its distance from its body's other clips is compared with the observed one.

    Args:
        toward: as for ``best_clip``, like the next two.
        bodies: which body each clip shows.
        against: which clips the best one is compared with.
        generator: of the random places.
        draws: how often.

    Returns:
        p, one-sided and at least 1 / (draws + 1) (Phipson and Smyth 2010); None where there is
        nothing to compare.
    """
    observed = _best_differences(toward[None], bodies, against)[0]
    if np.isnan(observed):
        return None
    reached = 0
    for start in range(0, draws, _AT_ONCE):
        shape = (min(_AT_ONCE, draws - start), *toward.shape)
        shuffled = np.broadcast_to(toward, shape).copy()
        for body in dict.fromkeys(bodies):
            own = [index for index, other in enumerate(bodies) if other == body]
            shuffled[..., own] = generator.permuted(shuffled[..., own], axis=-1)
        differences = _best_differences(shuffled, bodies, against)
        # Sums of other orders differ in the last digit: a tie counts as reached.
        reached += int(np.sum(differences >= observed - 1e-9))
    return (reached + 1) / (draws + 1)


_AT_ONCE = 100  # draws in memory together


def _best_differences(toward: Samples, bodies: Sequence[str], against: Against) -> Samples:
    """(draws,) mean of the best clip less that of its comparison group, of (draws, people, clips).

    NaN where there is no answer or nothing to compare with.
    """
    sums, counts = np.nansum(toward, axis=1), np.sum(~np.isnan(toward), axis=1)
    with np.errstate(invalid="ignore"):
        means = sums / counts
    best = np.argmax(np.where(counts > 0, means, -np.inf), axis=1)
    rest = np.array([_comparison(clip, bodies, against) for clip in range(len(bodies))])[best]
    with np.errstate(invalid="ignore"):
        others = np.sum(sums * rest, axis=1) / np.sum(counts * rest, axis=1)
    return np.asarray(means[np.arange(len(best)), best] - others)


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
