"""A recipe: an ordered list of operations, read from JSON, with one canonical form and its hash."""

from __future__ import annotations

import copy
import hashlib
import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

from motion.clip import Clip
from motion.errors import MotionError, RecipeError
from motion.recipe.operation import Context, Materials, Operation
from motion.recipe.operations import OPERATIONS
from motion.recipe.parameters import Value, Where, offer, shown

MAX_STEPS = 32
_NO_MATERIALS = Materials()


@dataclass(frozen=True, eq=False)
class Step:
    """One operation with its parameters, canonical; not to be changed."""

    operation: Operation
    parameters: Mapping[str, Any]

    @classmethod
    def parse(cls, document: object, place: int) -> Step:
        """A step from JSON; ``place`` is its index in the recipe."""
        where: Where = (place,)
        if not isinstance(document, dict):
            problem = f"Step {place + 1} is {shown(document)}, not an object."
            raise RecipeError(problem, where, "Give an object with operation and parameters.")
        for name in document:
            if name not in ("operation", "parameters"):
                problem = f"Step {place + 1} has an unknown {shown(name)}."
                raise RecipeError(problem, where, "It takes operation and parameters only.")
        key = document.get("operation")
        if not isinstance(key, str) or key not in OPERATIONS:
            what = "names no operation" if key is None else f"asks for {shown(key)}, no operation"
            problem = f"Step {place + 1} {what}."
            raise RecipeError(problem, (place, "operation"), offer(key, tuple(OPERATIONS)))
        group = OPERATIONS[key].parameters
        given = document.get("parameters", {})
        return cls(OPERATIONS[key], group.read_members(given, (place, "parameters")))

    def to_dict(self) -> dict[str, Value]:
        """As JSON; a copy."""
        return {
            "operation": self.operation.key,
            "parameters": copy.deepcopy(dict(self.parameters)),
        }

    def eased(self, share: float) -> Step:
        """The step with its numbers ``share`` of the way from where they do nothing."""
        values = self.operation.parameters.eased(dict(self.parameters), share)
        assert isinstance(values, dict)  # noqa: S101  a group gives back what it was given
        return Step(self.operation, values)


@dataclass(frozen=True, eq=False)
class Recipe:
    """Steps that are done one after the other."""

    steps: tuple[Step, ...] = ()

    @classmethod
    def parse(cls, document: object) -> Recipe:
        """A recipe from its JSON, a list of ``{"operation": "grid@1", "parameters": {…}}``.

        Raises:
            RecipeError: naming the place and the mend.
        """
        if not isinstance(document, list | tuple):
            problem = f"A recipe is a list of steps; this is {shown(document)}."
            raise RecipeError(problem, (), "Give a list of operations.")
        if len(document) > MAX_STEPS:
            problem = f"A recipe of {len(document)} steps is too long."
            raise RecipeError(problem, (), f"Give at most {MAX_STEPS} steps.")
        return cls(tuple(Step.parse(step, place) for place, step in enumerate(document)))

    def to_list(self) -> list[dict[str, Value]]:
        """As JSON with all defaults filled in; a copy."""
        return [step.to_dict() for step in self.steps]

    @cached_property
    def canonical_json(self) -> str:
        """Sorted keys, no spaces: the same text for the same recipe."""
        return json.dumps(self.to_list(), sort_keys=True, separators=(",", ":"), ensure_ascii=False)

    @cached_property
    def hash(self) -> str:
        """SHA-256 of the canonical text."""
        return hashlib.sha256(self.canonical_json.encode()).hexdigest()

    @cached_property
    def poses(self) -> frozenset[str]:
        """Ids of the poses that must be supplied."""
        return self._referred("pose")

    @cached_property
    def clips(self) -> frozenset[str]:
        """Ids of the clips that must be supplied."""
        return self._referred("clip")

    def eased(self, share: float) -> Recipe:
        """Every amount ``share`` of the way from nothing (0) to its value (1).

        Settings, such as edges, rates and the ends of a cut, are no amounts and stay.
        """
        return Recipe(tuple(step.eased(share) for step in self.steps))

    def apply(self, source: Clip, materials: Materials = _NO_MATERIALS) -> Clip:
        """The edited clip; the same bits for the same recipe, source and materials.

        Raises:
            RecipeError: if a pose or clip is missing, or the source does not lend itself to a step.
        """
        self._check_supplied(materials)
        clip = body = source
        for place, step in enumerate(self.steps):
            before = Recipe(self.steps[:place])
            context = Context(materials, body, partial(before.unedited, source, materials))
            with _told_where(place, step):
                clip = step.operation.apply(clip, step.parameters, context)
            if clip.skeleton.content_hash != body.skeleton.content_hash:
                body = clip
        return clip

    def unedited(self, source: Clip, materials: Materials = _NO_MATERIALS) -> Clip:
        """What the edited clip is to be judged against: the source with the recipe's time only.

        Raises:
            RecipeError: as ``apply``.
        """
        self._check_supplied(materials)
        context = Context(materials, source, lambda: source)
        clip = source
        for place, step in enumerate(self.steps):
            if step.operation.follow is not None:
                with _told_where(place, step):
                    clip = step.operation.follow(clip, context, **step.parameters)
        return clip

    def _references(self) -> Iterator[tuple[int, str, str]]:
        """Step, kind and name of everything referred to."""
        for place, step in enumerate(self.steps):
            group = step.operation.parameters
            for kind, name in group.references(dict(step.parameters)):
                yield place, kind, name

    def _referred(self, wanted: str) -> frozenset[str]:
        return frozenset(name for _, kind, name in self._references() if kind == wanted)

    def _check_supplied(self, materials: Materials) -> None:
        for place, kind, name in self._references():
            if name not in (materials.poses if kind == "pose" else materials.clips):
                problem = f"Step {place + 1} refers to the {kind} {name}, which is not there."
                raise RecipeError(problem, (place, "parameters"), f"Choose another {kind}.")


@contextmanager
def _told_where(place: int, step: Step) -> Iterator[None]:
    """What goes wrong inside is told with the step's place."""
    try:
        yield
    except RecipeError:
        raise
    except MotionError as error:
        problem = f"Step {place + 1}, {step.operation.title.lower()}: {error}"
        raise RecipeError(problem, (place,)) from error
