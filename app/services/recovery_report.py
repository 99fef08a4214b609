"""The page and the picture that ``manner recover`` writes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import takewhile
from math import isnan
from pathlib import Path
from textwrap import fill

from app.figures import recovery as drawing
from app.figures import render
from app.services.recovery import (
    NOISES,
    PARTICIPANTS,
    RATERS,
    SETS,
    Control,
    Point,
    Setting,
    Share,
)
from app.statistics.latent_raters import PAPER_NOISE

PAGE, PICTURE = "recovery.md", "recovery.svg"
Points = Mapping[Setting, Point]
_NAMES = {
    "none": "as given",
    "answers": "answers shuffled",
    "clips": "clips shuffled",
    "motions": "motions drawn anew",
}
_TITLES = {"set_a": "Set A, table 2", "set_b": "Set B, table 3"}
_HEAD = """# Are the four qualities found again?

People rate walks on 41 pairs of adjectives; pairs that say little or divide people are dropped, and
Ward's method makes four clusters of the rest: the four sliders of an authoring space. Would that
way find qualities that are known to be there? Here {seeds} simulated studies a point answer, with
raters whose impressions follow the published clusters: table 2 of Oshita et al. for the ten walks
of set A (27 pairs kept, 14 dropped), table 3 for the 27 walks of set B (29 kept, 12 dropped).
Written by `manner recover --seeds {seeds} --seed {seed} --into docs`.

## The raters

Each size follows from the paper's two thresholds and was fixed before any result.

- **Clips** have assumed values on four qualities (`app/studies/simulated_impressions.py`).
- **A pair of the table** measures its quality. Its strongest clip lies 1.2 to 2 steps from neutral,
  at random: between what is just kept (1) and the end of the scale.
- **The other pairs**: one half, at random, says little, the strongest clip at half the threshold
  (0.5); about the other half people disagree, personal opinions having twice the spread that is
  kept (1.7).
- **Noise**: standard deviation of an answer about the common opinion, in steps; half of the
  variance is a rater's bias on the pair, half the moment's. Answers are rounded to −2 … 2.
- **The paper's noise** is √(0.85² − 1/12) = 0.80: the noisiest answers whose pair is still kept
  spread by σ = 0.85, of which 1/12 is the variance of rounding. It is the least favourable case,
  with every pair at the threshold.

How to read the tables. *Kept*: the part of the table's pairs that is kept. *Dropped*: the part of
the others that is dropped. *Rand*: adjusted Rand index of the four clusters with the table, over
its pairs that are kept (1 the same, 0 chance): mean and middle 90 % of the studies in which four
pairs or more are kept, with their number where it is not all. *No thresholds*: the same with all of
the table's pairs and no other. *Exact*: studies in which everything is as in the table.

![Curves over noise and over the number of raters](recovery.svg)
"""
_NOISE = f"{RATERS} raters; the paper's noise is {PAPER_NOISE:.2f}."
_RATERS = f"A noise of {PAPER_NOISE:.2f}; the paper has {RATERS} raters."
_BOTH = "Rand, and after the stroke the part of the table's pairs that is kept."
_CONTROLS = """The same answers with the structure taken out. *Answers shuffled*: of each pair all
answers change places among raters and clips, so that no clip differs from another. *Clips
shuffled*: of each pair the clips change places, so that as many pairs are kept as before but have
nothing in common."""
_MOTIONS = """The qualities of sets A and B were chosen so that no two go closely together. Studies
that have motions of their own, as many as the set, with values drawn evenly from −1 … 1, show that
the result is not owed to that choice."""
_MEANING = """What limits the way is the threshold on the spread, not the clustering: beyond the
paper's noise nearly all pairs are dropped, however many raters there are, while clusters of all the
table's pairs would still be right. More raters make means surer and so drop the pairs that say
little; they do not make people agree."""


def write(points: Points, folder: Path, seed: int) -> None:
    """Write the page and its picture into a folder, which is made if there is none."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / PICTURE).write_text(picture(points), "utf-8")
    (folder / PAGE).write_text(page(points, seed), "utf-8")


def page(points: Points, seed: int) -> str:
    """The page as Markdown.

    Args:
        points: those of all settings.
        seed: from which they were drawn.
    """
    seeds = next(iter(points.values())).seeds
    plain = [setting for setting in points if setting.control == "none"]
    noise = [setting for setting in plain if setting.participants == RATERS]
    raters = [setting for setting in plain if setting.noise == PAPER_NOISE]
    parts = [_HEAD.format(seeds=seeds, seed=seed), *_found(points)]
    parts += ["## Over noise", _NOISE, table(points, noise)]
    parts += ["## Over the number of raters", _RATERS, table(points, raters)]
    parts += ["## Both", _BOTH, *(_grid(points, motion_set) for motion_set in SETS)]
    parts += ["## Controls", _CONTROLS, table(points, _ends("answers") + _ends("clips"))]
    parts += ["## Other motions", _MOTIONS, table(points, _ends("motions"))]
    return "\n\n".join(part.strip() for part in parts) + "\n"


def _ends(control: Control) -> list[Setting]:
    """The control at the lowest noise and at the paper's."""
    noises = (NOISES[0], PAPER_NOISE)
    return [Setting(motion_set, noise, RATERS, control) for motion_set in SETS for noise in noises]


def table(points: Points, settings: Sequence[Setting]) -> str:
    """A line for each of the settings, as Markdown."""
    head = [
        "set",
        "answers",
        "noise",
        "raters",
        "kept",
        "dropped",
        "Rand",
        "no thresholds",
        "exact",
    ]
    rule = "|---|---" + "|--:" * (len(head) - 2) + "|"
    return "\n".join([_line(head), rule, *(_line(_cells(points[one])) for one in settings)])


def _cells(point: Point) -> list[str]:
    set_, noise, participants, control = point.setting
    return [
        _short(set_),
        _NAMES[control],
        f"{noise:.2f}",
        str(participants),
        _percent(point.kept),
        _percent(point.dropped),
        _rand(point),
        _plain(point.rand_of_all.mean),
        f"{point.exact} of {point.seeds}",
    ]


def _line(cells: Sequence[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def _found(points: Points) -> Iterator[str]:
    """What the numbers say, in words."""
    yield "## What is found"
    for motion_set in SETS:
        upward = (points[Setting(motion_set, noise)] for noise in NOISES)
        exact = [one.setting.noise for one in takewhile(lambda p: p.exact == p.seeds, upward)]
        upto = f"up to a noise of {exact[-1]:.1f}" if exact else "at no noise"
        there = points[Setting(motion_set)]
        clips = points[Setting(motion_set, control="clips")]
        answers = points[Setting(motion_set, control="answers")]
        told = (
            f"**{_TITLES[motion_set]}**: with {RATERS} raters the recovery is exact in every study "
            f"{upto}. At the paper's noise {_percent(there.kept)} of the table's pairs are kept, "
            f"{_percent(there.dropped)} of the others dropped, and the clusters agree with the "
            f"table by {_plain(there.rand.mean)} (adjusted Rand index). Where clips are shuffled "
            f"it is {_plain(clips.rand.mean)}. Where answers are shuffled, "
            f"{_percent(answers.kept)} of the table's pairs are kept; clusters of all of them "
            f"give {_plain(answers.rand_of_all.mean)}."
        )
        yield fill(told, 100)
    yield _MEANING


def _grid(points: Points, motion_set: str) -> str:
    head = " | ".join(f"{raters} raters" for raters in PARTICIPANTS)
    lines = [f"| {_short(motion_set)}, noise | {head} |", "|--:" * (len(PARTICIPANTS) + 1) + "|"]
    for noise in NOISES:
        cells = [
            f"{_plain(point.rand.mean)} / {_percent(point.kept)}"
            for point in (points[Setting(motion_set, noise, raters)] for raters in PARTICIPANTS)
        ]
        lines.append(f"| {noise:.2f} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def picture(points: Points) -> str:
    """The curves over noise and over the number of raters as SVG."""
    noise: list[drawing.Curve] = []
    raters: list[drawing.Curve] = []
    for motion_set in SETS:
        over = [Setting(motion_set, steps) for steps in NOISES]
        noise += _curves(points, NOISES, over)
        over = [Setting(motion_set, participants=number) for number in PARTICIPANTS]
        raters += _curves(points, PARTICIPANTS, over)
    of_noise = drawing.Axis(f"noise in steps, {RATERS} raters", PAPER_NOISE)
    of_raters = drawing.Axis("raters, the paper’s noise", RATERS, logarithmic=True)
    return render.svg(drawing.recovery([(of_noise, noise), (of_raters, raters)], "light"))


def _curves(
    points: Points, places: Sequence[float], settings: Sequence[Setting]
) -> Iterator[drawing.Curve]:
    plain = [points[setting] for setting in settings]
    shuffled = [points[setting._replace(control="clips")] for setting in settings]
    shares = {
        "Rand index of the clusters of kept pairs": [_often(point) for point in plain],
        "Rand index without thresholds": [point.rand_of_all for point in plain],
        "the table’s pairs that are kept": [point.kept for point in plain],
        "other pairs that are dropped": [point.dropped for point in plain],
        "Rand index where clips are shuffled": [point.rand_of_all for point in shuffled],
    }
    for name, values in shares.items():
        band = values if name.startswith("Rand") else []
        yield drawing.Curve(
            name,
            _TITLES[settings[0].motion_set],
            places,
            [value.mean for value in values],
            [value.low for value in band],
            [value.high for value in band],
        )


def _often(point: Point) -> Share:
    """The Rand index where most studies have one; a few lucky ones would tell nothing."""
    nan = float("nan")
    return point.rand if 2 * point.solved >= point.seeds else Share(nan, nan, nan)


def _short(motion_set: str) -> str:
    return motion_set.removeprefix("set_").upper()


def _percent(share: Share) -> str:
    return f"{100 * share.mean:.0f} %"


def _plain(value: float) -> str:
    return "–" if isnan(value) else f"{round(value, 2) + 0.0:.2f}".replace("-", "−")


def _rand(point: Point) -> str:
    if not point.solved:
        return "–"
    of = f" ({point.solved} studies)" if point.solved < point.seeds else ""
    mean, low, high = (
        _plain(value) for value in (point.rand.mean, point.rand.low, point.rand.high)
    )
    return f"{mean} ({low} … {high}){of}"
