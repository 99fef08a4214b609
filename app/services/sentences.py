"""Results in words, as the American Psychological Association writes them."""

from __future__ import annotations

from typing import Literal

SIGNIFICANT = 0.05


def number(value: float, digits: int = 2) -> str:
    """A rounded number with a true minus sign; minus zero is zero."""
    return f"{round(value, digits) + 0.0:.{digits}f}".replace("-", "−")


def p_value(p: float) -> str:
    """Without the leading zero, three digits: ``= .004`` or ``< .001``."""
    if p < 0.001:
        return "< .001"
    return "= 1.000" if round(p, 3) >= 1 else f"= {p:.3f}".replace("0.", ".", 1)


def best_clip(
    *, label: str, more: str, against: Literal["others", "all"],
    t: float, df: float, p_holm: float, d: float, low: float, high: float,
) -> str:  # fmt: skip
    """One row of "Is every quality seen?". `more` is the pole's comparative, such as sadder."""
    rest = "the same body’s other clips" if against == "others" else "all clips of the same body"
    finding = (
        f"The clip “{label}” was seen as {more} than {rest}"
        if p_holm < SIGNIFICANT
        else f"No clip was reliably seen as {more} than {rest}; the nearest was “{label}”"
    )
    return (
        f"{finding}, Welch’s t({number(df, 1)}) = {number(t)}, p {p_value(p_holm)} after Holm’s "
        f"correction, d = {number(d)}, 95 % CI [{number(low)}, {number(high)}]."
    )


def extremes(left: tuple[str, str, float], right: tuple[str, str, float]) -> str:
    """Which clip lies nearest to each pole of an axis: (pole, clip's label, mean) of either."""
    (left_pole, leftmost, low), (right_pole, rightmost, high) = left, right
    return (
        f"On average “{leftmost}” was nearest to {left_pole} (M = {number(low)}) and "
        f"“{rightmost}” to {right_pole} (M = {number(high)})."
    )


def range_of(lowest: tuple[str, str, float], highest: tuple[str, str, float]) -> str:
    """The clips of lowest and highest mean: (end's word, clip's label, mean) of either."""
    (_, low_label, low), (_, high_label, high) = lowest, highest
    return (
        f"On average “{low_label}” was rated lowest (M = {number(low)}) and “{high_label}” "
        f"highest (M = {number(high)})."
    )


def recognised(right: int, shown: int, low: float, high: float) -> str:
    """How often X was recognised; low and high are Wilson's 95 % interval, in 0 ... 1."""
    return (
        f"X was recognised in {right} of {shown} trials, {100 * right / shown:.0f} % "
        f"(95 % CI {100 * low:.0f} to {100 * high:.0f} %); by guessing it would be 50 %."
    )


def most_chosen(name: str, chosen: int, shown: int, low: float, high: float) -> str:
    """What stood out among choices; low and high are Wilson's 95 % interval, in 0 ... 1."""
    return (
        f"“{name}” was chosen most often: in {chosen} of {shown} trials, "
        f"{100 * chosen / shown:.0f} % (95 % CI {100 * low:.0f} to {100 * high:.0f} %)."
    )
