"""Points of an authoring space: which weights they give its examples, and which recipe.

No clip is needed for that: a study file that makes stimuli in a space is checked at every change.
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray
from sqlalchemy.orm import Session

from app.errors import InvalidError
from app.schemas.spaces import Point, Sliders, SpaceDefinition, SpaceRecipe, Weighed
from app.schemas.study import Interface
from app.services import spaces
from motion.blending.hull import outside_hull
from motion.blending.weights import WeightMap

Array = NDArray[np.float64]
K = TypeVar("K")
V = TypeVar("V")

SPACES_KEPT = 64
MAPS_KEPT = 64  # of each space: a map is a few kilobytes
DIGITS = 6  # of weights, everywhere alike: so a recipe gives the motion that was shown


class Recent(Generic[K, V]):
    """The values last asked for; each is made once, also where many ask for it at one moment."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._slots: OrderedDict[K, _Slot[V]] = OrderedDict()
        self._gate = threading.Lock()

    def get(self, key: K, make: Callable[[], V]) -> V:
        """What is kept under the key, or is made now and then kept."""
        with self._gate:
            slot = self._slots.setdefault(key, _Slot())
            self._slots.move_to_end(key)
        with slot.gate:
            if not slot.made:
                try:
                    slot.made.append(make())
                except BaseException:
                    with self._gate:
                        self._slots.pop(key, None)
                    raise
                self._push_out()
        return slot.made[0]

    def _push_out(self) -> None:
        """Forget what was not asked for longest; only now, as what cannot be made takes no room."""
        with self._gate:
            while len(self._slots) > self._most:
                self._slots.popitem(last=False)


class _Slot(Generic[V]):
    """Room for one value; empty until it is made."""

    def __init__(self) -> None:
        self.gate = threading.Lock()
        self.made: list[V] = []


@dataclass(frozen=True, eq=False)
class _Map:
    """Weights by some of the sliders, and the examples' places (N, P) on them."""

    places: Array
    weights: WeightMap


@dataclass(frozen=True, eq=False)
class Points:
    """A space as far as weights go."""

    definition: SpaceDefinition
    _maps: Recent[tuple[Interface, tuple[str, ...]], _Map] = field(
        default_factory=lambda: Recent(MAPS_KEPT), kw_only=True
    )

    def weights(self, point: Point) -> Weighed:
        """The examples' weights at a point, in steps of a millionth; their sum is 1.

        Raises:
            InvalidError: the space has no such slider or example, or nothing weighs anything.
        """
        if point.interface == "weights":
            return Weighed(weights=self._given(point.values), outside=0.0, notes=[])
        names = tuple(sorted(point.values))
        known = self._map(point.interface, names)
        place = np.array([point.values[name] for name in names])
        return Weighed(
            weights=_rounded(known.weights.weights(place)),
            outside=round(outside_hull(known.places, place), DIGITS),
            notes=list(known.weights.notes),
        )

    def recipe(self, point: Point) -> SpaceRecipe:
        """A point as a recipe that needs no space: examples that weigh nothing are left out."""
        weighed = self.weights(point)
        examples = [
            {"clip": example.clip, "weight": weight, "keytimes": dict(example.keytimes)}
            for example, weight in zip(self.definition.examples, weighed.weights, strict=True)
            if weight
        ]
        return SpaceRecipe(
            **weighed.model_dump(),
            source=self.definition.examples[0].clip,
            operations=[{"operation": "blend@1", "parameters": {"examples": examples}}],
        )

    def notes(self, interface: Interface) -> list[str]:
        """What there is to know about the examples' places on the primary sliders."""
        sliders = self.definition.sliders(interface)
        if sliders is None or not sliders.primary:
            return []
        names = tuple(sorted(one.id for one in sliders.primary))
        return list(self._map(interface, names).weights.notes)

    def _map(self, interface: Interface, names: tuple[str, ...]) -> _Map:
        return self._maps.get((interface, names), lambda: self._fitted(interface, names))

    def _fitted(self, interface: Interface, names: tuple[str, ...]) -> _Map:
        sliders = self._sliders(interface)
        columns = {one.id: one.values for one in sliders.parameters}
        columns |= {one.id: one.values for one in sliders.primary}
        for name in names:
            if name not in columns:
                raise _unknown(f"no slider “{name[:60]}”", name, list(columns))
        places = np.array([columns[name] for name in names]).T
        return _Map(places, WeightMap.fit(places))

    def _sliders(self, interface: Interface) -> Sliders:
        sliders = self.definition.sliders(interface)
        if sliders is None:
            raise InvalidError(
                "Nobody has judged the clips of this space, so it has no adjectives.",
                code="no_adjectives",
                where={"field": "interface"},
                mend="Use features or weights.",
            )
        return sliders

    def _given(self, values: Mapping[str, float]) -> list[float]:
        known = [example.clip for example in self.definition.examples]
        for name in values:
            if name not in known:
                raise _unknown(f"no example “{name[:64]}”", name, known)
        weights = np.array([values.get(name, 0.0) for name in known])
        if not weights.any():
            raise InvalidError(
                "No example weighs anything.",
                code="nothing_weighs",
                where={"field": "values"},
                mend="Give at least one of them a weight above 0.",
            )
        return _rounded(weights / weights.max())


_points: Recent[str, Points] = Recent(SPACES_KEPT)


def points_in(db: Session, space_id: str) -> Points:
    """The points of a space; the last spaces are kept.

    Raises:
        NotFoundError: there is no such space.
    """
    return _points.get(space_id, lambda: Points(spaces.definition(db, space_id)))


def _rounded(weights: Array) -> list[float]:
    """Weights with a sum of 1 in steps of a millionth; the greatest takes the remainder."""
    rounded = np.round(weights / weights.sum(), DIGITS)
    greatest = int(np.argmax(rounded))
    rounded[greatest] = 1.0 - (rounded.sum() - rounded[greatest])
    return [float(weight) for weight in np.round(rounded, DIGITS) + 0.0]


def _unknown(what: str, name: str, known: Sequence[str]) -> InvalidError:
    near = get_close_matches(name[:64], known)
    return InvalidError(
        f"This space has {what}.",
        code="slider_unknown",
        where={"field": "values", "name": name[:64]},
        mend=f"Did you mean {', '.join(near)}?" if near else "The space lists what it has.",
    )
