"""The 51 motion features: which they are, and what each means.

Their selection and their four groups are those of Oshita et al., tables 4 and 5. Two rows there are
printed twice: the second step length is read as the longest step, the second spread of the left
foot to the sides as its spread to the front and back.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

FEATURE_GROUPS: Mapping[str, str] = {
    "lateral_swing": "Lateral swing of the upper body",
    "limb_swing": "Front–back swing of the arms and legs",
    "bending": "Bending angle of the upper body",
    "step_length": "Step length",
}
"""Id and title of the paper's four groups of features."""


_LEAST = {"°": 0.5, "m": 0.005, "m/s": 0.01, "s": 0.02}


@dataclass(frozen=True)
class Feature:
    """One number about a clip.

    Attributes:
        id: for programs, such as "left_thigh_front_back_spread".
        title: on screen.
        group: one of FEATURE_GROUPS.
        unit: °, m, m/s or s.
        definition: what is measured.
        positive: what a greater value means.
    """

    id: str
    title: str
    group: str
    unit: str
    definition: str
    positive: str

    @property
    def least(self) -> float:
        """The least difference that means anything: what is lost between frame rates and steps."""
        return _LEAST[self.unit]

    @property
    def description(self) -> str:
        """Definition and direction, in sentences."""
        return f"{self.definition} {self.positive}"


@dataclass(frozen=True)
class _Signal:
    """What is measured in every frame: the words of its features.

    Attributes:
        titles: of its mean and its spread.
        unit: °, m or m/s.
        definition: in words that fit behind "Mean over time of".
        positive: what a greater mean means.
    """

    titles: tuple[str, str]
    unit: str
    definition: str
    positive: str


MEAN, SPREAD = "mean", "spread"
FRONT_BACK, LEFT_RIGHT = "front_back", "left_right"
_SEGMENTS = {
    "torso": "the line from the middle of the hip joints to the middle of the shoulders",
    "head": "the head’s upright axis",
    "upper_arm": "the line from shoulder to elbow",
    "forearm": "the line from elbow to wrist",
    "thigh": "the line from hip to knee",
    "shin": "the line from knee to ankle",
    "foot": "the line from ankle to ball",
}
_AT_ZERO = {"torso": "upright", "head": "upright", "foot": "level"}


def _segment(name: str, direction: str) -> _Signal:
    side, _, part = name.partition("_") if name not in _SEGMENTS else ("", "", name)
    line = f"{_SEGMENTS[part]} on the {side}" if side else _SEGMENTS[part]
    way = direction.replace("_", "–")
    title = name.replace("_", " ").capitalize()
    titles = (f"{title}: angle {way}", f"{title}: swing {way}")
    if direction == LEFT_RIGHT:
        what = f"the angle by which {line} points to the side"
        return _Signal(titles, "°", what, "Positive: to the left.")
    what = f"the angle of {line} to {_AT_ZERO.get(part, 'hanging straight down')}"
    positive = "Positive: toes up." if part == "foot" else "Positive: forward."
    return _Signal(titles, "°", f"{what}, seen from the side", positive)


def _centre(title: str, unit: str, definition: str, positive: str) -> _Signal:
    titles = (f"Centre of mass: {title}", f"Centre of mass: changes of {title}")
    return _Signal(titles, unit, f"the {definition}", positive)


_CENTRES = {
    "com_left_right": _centre(
        "place left–right",
        "m",
        "distance of the centre of mass to the side of its straight, even travel",
        "Positive: to the left.",
    ),
    "com_position_vertical": _centre(
        "height", "m", "height of the centre of mass above the floor", "Positive: higher."
    ),
    "com_velocity_vertical": _centre(
        "velocity up–down", "m/s", "vertical velocity of the centre of mass", "Positive: up."
    ),
    "com_velocity_front_back": _centre(
        "velocity front–back",
        "m/s",
        "velocity of the centre of mass along the heading",
        "Positive: forward.",
    ),
    "com_velocity_left_right": _centre(
        "velocity left–right",
        "m/s",
        "velocity of the centre of mass across the heading",
        "Positive: to the left.",
    ),
}
STEP_WIDTH, STEP_LENGTH, LONGEST_STEP, DURATION = (
    "step_width",
    "step_length",
    "longest_step",
    "motion_duration",
)
_VALUES = {
    STEP_WIDTH: (
        "Step length left–right: step width",
        "m",
        "How far to its own side a foot is set down beside the other one; mean of the left and the "
        "right steps’ means, 0 without a step.",
        "Greater: a wider track; negative: the feet cross.",
    ),
    STEP_LENGTH: (
        "Step length front–back",
        "m",
        "How far along the heading a foot is set down before the other one; mean over the clip’s "
        "steps, 0 without a step.",
        "Greater: longer steps; negative: backward.",
    ),
    LONGEST_STEP: (
        "Step length front–back: longest step",
        "m",
        "The longest single step along the heading; 0 without a step.",
        "Greater: a longer step.",
    ),
    DURATION: (
        "Duration",
        "s",
        "How long the clip lasts; one cycle of a cyclic clip.",
        "Greater: slower.",
    ),
}

# In the paper's order. Left and right follow each other.
_ARMS = [f"{side}_{part}" for part in ("upper_arm", "forearm") for side in ("left", "right")]
_THIGHS, _SHINS, _FEET = (
    [f"{side}_{part}" for side in ("left", "right")] for part in ("thigh", "shin", "foot")
)


def _rows(statistic: str, direction: str, *names: str) -> list[tuple[str, str]]:
    return [(f"{name}_{direction}", statistic) for name in names]


_GROUPS: Mapping[str, list[tuple[str, str]]] = {
    "lateral_swing": [
        *_rows(SPREAD, LEFT_RIGHT, "torso", "head", "com"),
        *_rows(SPREAD, FRONT_BACK, "torso", "head"),
    ],
    "limb_swing": [
        *_rows(SPREAD, FRONT_BACK, *_ARMS, *_THIGHS),
        ("com_position_vertical", SPREAD),
        ("com_velocity_vertical", SPREAD),
        *_rows(SPREAD, LEFT_RIGHT, *_THIGHS, *_ARMS[:2]),
    ],
    "bending": [
        *_rows(MEAN, FRONT_BACK, "torso", "head", *_ARMS, *_THIGHS),
        *_rows(MEAN, LEFT_RIGHT, "torso", "head", *_ARMS[:2], "left_thigh", "right_foot"),
        ("com_velocity_left_right", MEAN),
        (STEP_WIDTH, ""),
        (STEP_LENGTH, ""),
    ],
    "step_length": [
        (LONGEST_STEP, ""),
        ("com_velocity_front_back", MEAN),
        ("com_velocity_front_back", SPREAD),
        ("com_position_vertical", MEAN),
        (DURATION, ""),
        *_rows(MEAN, LEFT_RIGHT, "right_thigh"),
        *_rows(MEAN, FRONT_BACK, *_SHINS, *_FEET),
        *_rows(MEAN, LEFT_RIGHT, "left_foot"),
        *_rows(SPREAD, FRONT_BACK, *_SHINS, *_FEET),
        *_rows(SPREAD, LEFT_RIGHT, *_FEET),
    ],
}


def _features() -> Iterator[Feature]:
    for group, rows in _GROUPS.items():
        for name, statistic in rows:
            if not statistic:
                title, unit, definition, positive = _VALUES[name]
                yield Feature(name, title, group, unit, definition, positive)
                continue
            signal = _CENTRES.get(name) or _segment(*_split(name))
            title = signal.titles[statistic == SPREAD]
            definition, positive = f"Mean over time of {signal.definition}.", signal.positive
            if statistic == SPREAD:
                definition = f"Standard deviation over time of {signal.definition}."
                positive = "Greater: it moves more."
            yield Feature(f"{name}_{statistic}", title, group, signal.unit, definition, positive)


def _split(name: str) -> tuple[str, str]:
    direction = FRONT_BACK if name.endswith(FRONT_BACK) else LEFT_RIGHT
    return name.removesuffix(f"_{direction}"), direction


FEATURES: tuple[Feature, ...] = tuple(_features())
"""The 51, in the order in which ``features`` measures them."""
