"""Writes docs/features.md: the 51 motion features from the code.

Run as ``python -m tests.support.feature_page``.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from motion.features import FEATURE_GROUPS, FEATURES

PAGE = Path(__file__).parents[2] / "docs" / "features.md"

_HEAD = """# Motion features

51 numbers about a clip, after Oshita et al., *Motion interpolation using adjectives*, tables 4 and
5. Clustered like adjectives, they are a second kind of sliders, one that needs no questionnaire;
and from them the adjectives of a clip can be predicted that nobody has rated.

In Python, `motion.features.features(clip)` gives the 51 in this order; `FEATURES` says what they
are.

- **Directions** are the world's, seen from the clip's own heading: where hips and shoulders face on
  average. Forward is positive, to the left is positive. So heading and start position do not
  matter; in a mirror, left and right change places, and means to the side change their sign.
- **Angles** are those of a line through the body. Front–back is its angle seen from the side; a
  moment at which it points more than 60° to a side counts less, since little of it is seen then.
  Left–right is how far it leaves the plane that heading and vertical span.
- **Mean and spread** are over time: every moment of a cycle counts once, at any frame rate. Spread
  is the standard deviation.
- **The centre of mass** is that of the average segment masses of de Leva (1996). **Velocities** are
  those of its path without what is faster than 8 Hz.
- **Steps** come from when and where the feet stand. A clip without steps has step lengths of 0.
- **Every skeleton** whose limbs, hips and head are known has all of them. A forearm whose wrist is
  unknown goes on as the upper arm does; a foot of which only the ankle is known has angles of 0; a
  head without a tip points along the axis of its joint that is nearest to the neck's. Joints do not
  sit at the same places in all skeletons: compare clips of one skeleton.
- **Misprints.** Two rows of the paper's tables are printed twice. The second step length is read as
  the longest step, the second spread of the left foot left–right as the one front–back.
"""

_PREDICTION = """## Adjectives from features

For a clip that nobody rated, `app.statistics.prediction` learns each adjective from the rated
clips' features: ridge regression on standardised features, the penalty chosen by leaving out one
clip after the other.

- **Its error** is honest: each rated clip is predicted by a model that has not seen it, whose
  scales and penalty were found without it as well.
- **Refused** is an adjective if that error spares less than 5/N of the squared error that the mean
  of the other clips makes, N being the number of rated clips; below 8 clips every one is. Where
  the ratings are drawn by lot, an error is by chance less than the mean's for one adjective in six;
  with this margin, 1 to 4 in 100 are accepted, for 8 to 60 clips.
- **Intervals** of 95 % come from what the models without one clip say and how far off they were
  (jackknife+), and widen with the distance from the rated clips. With fewer than 19 clips they
  promise what their number allows, N/(N + 1). For a motion unlike all rated ones they span
  everything: nothing is known of it.
"""


def page() -> str:
    """The whole of docs/features.md."""
    return "\n".join([_HEAD, *_groups(), _PREDICTION])


def _groups() -> Iterator[str]:
    number = 0
    for group, title in FEATURE_GROUPS.items():
        yield f"## {title}\n"
        yield "| | id | title | unit | what is measured | direction |\n|---|---|---|---|---|---|"
        for feature in FEATURES:
            if feature.group == group:
                number += 1
                yield (
                    f"| {number} | `{feature.id}` | {feature.title} | {feature.unit} "
                    f"| {feature.definition} | {feature.positive} |"
                )
        yield ""


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
