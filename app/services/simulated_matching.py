"""Made-up participants who match targets by feeling their way, with nothing but the distance.

A guess is drawn at random. A match moves one slider after the other, whichever way is nearer, in
ever smaller steps, until the figures are alike, no step helps any more, or the time is up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np
from sqlalchemy.orm import Session

from app.schemas.sessions import Move
from app.schemas.spaces import START
from app.schemas.study import Match
from app.services import matching
from app.services.plans import Step

FIRST_STEP, LAST_STEP = 0.25, 0.01  # of a slider's length
MOVE_SECONDS, MOVE_SPREAD = 1.5, 0.4  # median, and the spread of its logarithm

Distance = Callable[[Mapping[str, float]], float]


@dataclass
class Hand:
    """On the sliders of one trial.

    Attributes:
        at: where they stand.
        limit: seconds after which they move no more.
        seconds: since the figures came.
        path: as it is stored.
    """

    at: dict[str, float]
    limit: float
    generator: np.random.Generator
    seconds: float = 0.0
    path: list[Move] = field(default_factory=list)

    def move(self, slider: str, position: float) -> None:
        """Move a slider, which takes a while; too late, it stays."""
        self.seconds += float(self.generator.lognormal(np.log(MOVE_SECONDS), MOVE_SPREAD))
        if self.seconds <= self.limit:
            self.at = {**self.at, slider: position}
            self.path.append((round(1000 * self.seconds), slider, position))
        self.seconds = min(self.seconds, self.limit)


def taken(db: Session, task: Match, step: Step, generator: np.random.Generator) -> Hand:
    """A guess, or a match to its end."""
    names = matching.sliders_of(matching.space_of(db, task).definition, step["interface"])
    limit = task.seconds if step["seen"] else np.inf
    hand = Hand(dict.fromkeys(names, START), limit, generator)
    if step["seen"]:
        follow(hand, matching.measure(db, task, step), task.threshold)
    else:
        for name in names:
            hand.move(name, round(float(generator.random()), 2))
    return hand


def follow(hand: Hand, distance: Distance, threshold: float) -> None:
    """Move the sliders downhill until they match; where no step helps, wait until the time is up.

    Args:
        hand: on the sliders; it moves.
        distance: metres from the target, of positions.
        threshold: metres below which they match.
    """
    nearest, step = distance(hand.at), FIRST_STEP
    while nearest >= threshold and step >= LAST_STEP:
        found = _swept(hand, distance, nearest, step, threshold)
        step = step if found < nearest else step / 2
        nearest = found
    if nearest >= threshold:
        hand.seconds = hand.limit


def _swept(hand: Hand, distance: Distance, nearest: float, step: float, threshold: float) -> float:
    """The distance after each slider was tried a step up and a step down, in a random order."""
    for slider, position in _tries(hand, step):
        if nearest < threshold or hand.seconds >= hand.limit:
            break
        stood = hand.at[slider]
        hand.move(slider, position)
        if (found := distance(hand.at)) < nearest:
            nearest = found
        else:
            hand.move(slider, stood)
    return nearest


def _tries(hand: Hand, step: float) -> Iterator[tuple[str, float]]:
    for slider in hand.generator.permutation(list(hand.at)).tolist():
        for way in (step, -step):
            position = round(min(max(hand.at[slider] + way, 0.0), 1.0), 3)
            if position != hand.at[slider]:
                yield slider, position
