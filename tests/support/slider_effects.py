"""Writes docs/sliders.md: what the primary sliders of the two sample spaces do to a walk.

Run as ``python -m tests.support.slider_effects``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.stats import spearmanr

from app.schemas.spaces import Point
from app.services.space_clips import Source
from app.services.space_making import define
from app.services.space_motion import Prepared
from app.services.space_samples import sliders
from app.studies.adjectives import PRIMARY
from app.studies.simulated_impressions import CLIPS
from motion import Clip
from motion.procedural.library import set_a, set_b
from motion.storage import clip_to_bytes
from tests.support.walk_measures import MEASURES, measure

Array = NDArray[np.float64]

PAGE = Path(__file__).parents[2] / "docs" / "sliders.md"
SLIDERS = tuple(PRIMARY)
STEPS = (0.0, 0.25, 0.5, 0.75, 1.0)
POINTS, MIXED, SEED = 60, 4, 1
SETS = {"set_a": "Set A: ten walking styles", "set_b": "Set B: nine emotions at three speeds"}
_SAMPLES = {"set_a": set_a, "set_b": set_b}
_HEAD = f"""# What the sliders do, measured

A fresh server has two authoring spaces ([what a space is](spaces.md)) with four primary sliders
each. Here every slider is moved and the motions that come out are measured. Written by `python -m
tests.support.slider_effects`; a test compares this page with what the code gives, and others ask
for each effect that is meant.

The impressions behind these sliders are those of simulated raters, who answer by what each walk was
made to be (`app/studies/simulated_impressions.py`). So this shows that a slider does with motion
what its examples say; whether people see it that way only people can tell.

- **Moved**: one slider at 0, ¼, ½, ¾ and 1, the others at the examples' mean. **Change** is the
  slope of the straight line through the five, over a whole slider; **order** is Spearman’s rank
  correlation with the five steps, 1 if every step raises the measure.
- **Within**: the change over a whole slider by linear regression on all four, over {POINTS} points,
  each between {MIXED} examples drawn at random. There the other sliders are all over the place, and
  nothing lies outside of what the examples span. **Explained** is the part of the variance over
  those points that the four sliders explain together.
- **Outside** is how far a point lies from what the examples span, in slider lengths. The ends of a
  slider are outside nearly everywhere: no example is so large and average in all else. There
  weights change little, and a measure can go back a little, as the length of steps does in the last
  quarter of *largeness*.
- **Meant** is what the slider’s adjectives are about, in bold below. Quick: many steps a minute,
  fast hands. Large: arms spread, long steps. Of the other two one measure stands for many: a
  *clear* walk holds its trunk upright, an *active* one its head, which sad and dormant ones let
  hang.
- **Double support** is the part of the time in which both feet stand; **bounce** and **sway** are
  the standard deviation of the centre of mass up and down and to the sides. The arms span from
  wrist to wrist, on average and at the widest. Hands are as fast as they move against the hips.

The paper’s set A was performed at one speed; the ten styles here have cadences of their own, from
76 to 138 steps a minute. So *quickness* raises both there, the cadence and the speed of the hands.
"""


# What each slider is meant to do: measure to the sign of its change.
MEANT: Mapping[str, Mapping[str, int]] = {
    "quickness": {"cadence": 1, "hand speed": 1},
    "clearness": {"trunk bent forward": -1},
    "activeness": {"head bowed": -1},
    "largeness": {"arm span": 1, "step length": 1},
}


@dataclass(frozen=True)
class Effects:
    """What the sliders of a space do.

    Attributes:
        places: (N, 4) of the examples on the sliders.
        moved: (4, 5, M) measures while one slider goes through ``STEPS``, the others at the
            examples' mean.
        outside: (4, 5) how far those points lie outside of what the examples span.
        slopes: (4, M) change over a whole slider, by regression over points that they span.
        explained: (M,) share of the variance over those points that the sliders explain.
    """

    places: Array
    moved: Array
    outside: Array
    slopes: Array
    explained: Array

    def change(self, slider: str, name: str) -> float:
        """Slope of the straight line through the five steps, over a whole slider."""
        return float(np.polyfit(STEPS, self.path(slider, name), 1)[0])

    def order(self, slider: str, name: str) -> float:
        """Spearman's rank correlation of a measure with the five steps."""
        path = self.path(slider, name).round(6)
        return float(spearmanr(STEPS, path).statistic) if np.ptp(path) else 0.0

    def path(self, slider: str, name: str) -> Array:
        """A measure at the five steps."""
        return self.moved[SLIDERS.index(slider), :, list(MEASURES).index(name)]

    def slope(self, slider: str, name: str) -> float:
        """Change over a whole slider among points that the examples span."""
        return float(self.slopes[SLIDERS.index(slider), list(MEASURES).index(name)])


@cache
def space(motion_set: str) -> Prepared:
    """A sample space, as a fresh server has it."""
    samples = {sample.name: clip_to_bytes(sample.clip) for sample in _SAMPLES[motion_set]()}
    sources = [Source(f"{n:064x}", name, samples[name]) for n, name in enumerate(CLIPS[motion_set])]
    defined = define(SETS[motion_set], sources, {}, sliders(motion_set))
    return Prepared.of(defined, {source.id: source.content for source in sources})


@cache
def effects(motion_set: str) -> Effects:
    """What the sliders of a set's space do."""
    places = examples(motion_set)
    moved, outside = sweep(motion_set, places.mean(axis=0))
    points = np.array([_mixture(places, n) for n in range(POINTS)])
    found = np.array([measure(_at(motion_set, point)[0]) for point in points])
    design = np.column_stack([np.ones(POINTS), points])
    fitted = np.linalg.lstsq(design, found)[0]
    left = found - design @ fitted
    return Effects(places, moved, outside, fitted[1:], 1.0 - left.var(axis=0) / found.var(axis=0))


def examples(motion_set: str) -> Array:
    """(N, 4) places of the examples on the primary sliders, in the order of ``SLIDERS``."""
    adjectives = space(motion_set).definition.adjectives
    assert adjectives is not None
    values = {primary.id: primary.values for primary in adjectives.primary}
    return np.array([values[name] for name in SLIDERS]).T


@cache
def measured_examples(motion_set: str) -> Array:
    """(N, M) measures of the examples themselves."""
    single = np.eye(len(CLIPS[motion_set])).tolist()
    return np.array([measure(space(motion_set).clip(weights)) for weights in single])


def sweep(motion_set: str, middle: Array) -> tuple[Array, Array]:
    """Measures (4, 5, M) and distances outside (4, 5) as each slider is moved from a middle."""
    moved, outside = [], []
    for place in range(len(SLIDERS)):
        for step in STEPS:
            clip, beyond = _at(motion_set, np.where(np.arange(4) == place, step, middle))
            moved.append(measure(clip))
            outside.append(beyond)
    shape = (len(SLIDERS), len(STEPS))
    return np.array(moved).reshape(*shape, -1), np.array(outside).reshape(shape)


def _at(motion_set: str, point: Array) -> tuple[Clip, float]:
    """The motion at a point of the four sliders, and how far outside it is."""
    values = dict(zip(SLIDERS, point.tolist(), strict=True))
    weighed = space(motion_set).weights(Point(interface="adjectives", values=values))
    return space(motion_set).clip(weighed.weights), weighed.outside


def _mixture(places: Array, number: int) -> Array:
    """A point between some of the examples."""
    generator = np.random.default_rng((SEED, number))
    chosen = generator.choice(len(places), MIXED, replace=False)
    return generator.dirichlet(np.ones(MIXED)) @ places[chosen]


def page() -> str:
    """The whole of docs/sliders.md."""
    return "\n".join([_HEAD, *(part for motion_set in SETS for part in _section(motion_set))])


def _section(motion_set: str) -> Iterator[str]:
    found = effects(motion_set)
    yield f"## {SETS[motion_set]}\n"
    yield "What is meant:\n"
    yield "| slider | measure | 0 | ¼ | ½ | ¾ | 1 | change | order | within |"
    yield "|---|---|" + "--:|" * (len(STEPS) + 3)
    for place, slider in enumerate(SLIDERS):
        for name in MEANT[slider]:
            yield _meant(found, slider, name)
        beyond = " | ".join(f"{distance:.2f}" for distance in found.outside[place])
        yield f"| | *outside* | {beyond} | | | |"
    titles = " | ".join(SLIDERS)
    yield "\nEverything that was measured, one slider moved: change (order).\n"
    yield f"| measure | unit | {titles} |\n|---|---|{'--:|' * len(SLIDERS)}"
    for name in MEASURES:
        yield f"{_row(name, [_moved(found, slider, name) for slider in SLIDERS])} |"
    yield "\nThe same within the examples, all four moved at once.\n"
    yield f"| measure | unit | {titles} | explained |\n|---|---|{'--:|' * (len(SLIDERS) + 1)}"
    for place, name in enumerate(MEASURES):
        row = _row(name, [_signed(found.slope(slider, name), name) for slider in SLIDERS])
        yield f"{row} | {100.0 * found.explained[place]:.0f} % |"
    yield ""


def _meant(found: Effects, slider: str, name: str) -> str:
    digits = MEASURES[name].digits
    values = found.path(slider, name).round(digits) + 0.0
    path = " | ".join(f"{value:.{digits}f}" for value in values)
    label = f"{name}, {MEASURES[name].unit}"
    cells = [slider, label, path, _signed(found.change(slider, name), name)]
    cells += [_order(found, slider, name), _signed(found.slope(slider, name), name)]
    return f"| {' | '.join(cells)} |"


def _row(name: str, cells: Sequence[str]) -> str:
    """A measure's row without its end; what is meant is bold."""
    marked = [
        f"**{cell}**" if name in MEANT[slider] else cell
        for slider, cell in zip(SLIDERS, cells, strict=True)
    ]
    return f"| {' | '.join([name, MEASURES[name].unit, *marked])}"


def _moved(found: Effects, slider: str, name: str) -> str:
    return f"{_signed(found.change(slider, name), name)} ({_order(found, slider, name)})"


def _order(found: Effects, slider: str, name: str) -> str:
    return f"{found.order(slider, name) + 0.0:.1f}".replace("-", "−")


def _signed(value: float, name: str) -> str:
    digits = MEASURES[name].digits
    return f"{round(value, digits) + 0.0:+.{digits}f}".replace("-", "−")


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
