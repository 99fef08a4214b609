"""Recipes for emotions: the twelve of Förger's figure 29, and what he proposes beyond.

The thesis names the edits, not their amounts. Those here are chosen such that what an edit intends
can be measured on the sample library's neutral clips (``docs/presets.md``) and the quality report
finds little or nothing.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from motion.recipe.parameters import Value
from motion.recipe.recipe import Recipe


@dataclass(frozen=True, eq=False)
class Preset:
    """A recipe with a name.

    Attributes:
        name: for programs, such as "energetic_sadness".
        title: on screen.
        summary: what is changed, in the thesis's words.
        emotion: the intended one.
        axis: the questionnaire's axis that it lies on, such as "sad_happy".
        pole: the end of that axis, such as "sad".
        operations: the recipe.
    """

    name: str
    title: str
    summary: str
    emotion: str
    axis: str
    pole: str
    operations: Recipe


_AXES: Mapping[str, str] = {
    pole: f"{left}_{right}"
    for left, right in (
        ("sad", "happy"),
        ("tired", "excited"),
        ("angry", "relaxed"),
        ("weak", "strong"),
        ("afraid", "confident"),
        ("masculine", "feminine"),
    )
    for pole in (left, right)
}


def _grid(path: float = 1.0, timing: float = 1.0) -> dict[str, Value]:
    return {"operation": "grid@1", "parameters": {"path": path, "timing": timing}}


def _posture(**amounts: float) -> dict[str, Value]:
    offsets: Value = [{"pose": pose, "amount": amount} for pose, amount in amounts.items()]
    return {"operation": "posture@1", "parameters": {"offsets": offsets}}


def _bands(*gains: tuple[float, float]) -> dict[str, Value]:
    bands: Value = [{"frequency": frequency, "gain": gain} for frequency, gain in gains]
    return {"operation": "bands@1", "parameters": {"gains": bands}}


def _step(key: str, **parameters: Value) -> dict[str, Value]:
    return {"operation": key, "parameters": parameters}


def _preset(name: str, summary: str, pole: str, *steps: dict[str, Value]) -> Preset:
    title = name.replace("_", " ").capitalize()
    return Preset(name, title, summary, pole, _AXES[pole], pole, Recipe.parse(list(steps)))


# The opposite of elbows away brings hands closer where narrow steps leave the feet little room.
_A_LITTLE_CLOSER = _posture(hands_and_feet_closer=0.2, elbows_away=-0.2)

PRESETS: Mapping[str, Preset] = {
    preset.name: preset
    for preset in (
        _preset(
            "afraid",
            "Shorter motion paths, hands a little closer to the body and feet to each other.",
            "afraid",
            _grid(path=0.4),
            _A_LITTLE_CLOSER,
        ),
        _preset(
            "angry",
            "Longer motion paths and increased acceleration.",
            "angry",
            _grid(path=1.6),
            _step("timing@1", kind="added", amount=0.4),
        ),
        _preset(
            "energetic_sadness",
            "Longer motion paths and the head looking down.",
            "sad",
            _grid(path=1.6),
            _posture(head_down=1.0),
        ),
        _preset(
            "excited",
            "Longer motion paths and a little more acceleration.",
            "excited",
            _grid(path=1.8),
            _step("timing@1", kind="added", amount=0.2),
        ),
        _preset(
            "feminine",
            "Hands closer to the body and feet closer to each other.",
            "feminine",
            _posture(hands_and_feet_closer=0.3, elbows_away=-0.2),
        ),
        _preset("happy", "No modification.", "happy"),
        _preset(
            "masculine",
            "Hands farther from the body and feet a little more apart.",
            "masculine",
            _posture(hands_away_and_feet_apart=0.6),
        ),
        _preset(
            "relaxed",
            "Reduced acceleration.",
            "relaxed",
            _grid(timing=0.25),
            _bands((4.0, 1.0), (8.0, 0.3)),
        ),
        _preset(
            "sad",
            "Shorter motion paths and the head looking down.",
            "sad",
            _grid(path=0.4),
            _posture(head_down=1.0),
        ),
        _preset(
            "strong",
            "Longer motion paths and elbows away from the body.",
            "strong",
            _grid(path=1.6),
            _posture(elbows_away=1.0),
        ),
        _preset(
            "tired",
            "Very short motion paths and the head looking a little down.",
            "tired",
            _grid(path=0.0),
            _posture(head_a_little_down=1.0),
        ),
        _preset(
            "weak",
            "Very short motion paths, hands a little closer to the body, feet to each other.",
            "weak",
            _grid(path=0.0),
            _A_LITTLE_CLOSER,
        ),
        _preset(
            "angry_at_contacts",
            "Acceleration at contacts only, longer motion paths, a slightly sad posture.",
            "angry",
            _grid(path=1.6),
            _posture(head_a_little_down=1.0),
            _step("contacts@1", amount=0.3),
        ),
        _preset(
            "excited_faster",
            "Shorter motion paths in faster time.",
            "excited",
            _grid(path=0.6),
            _step("tempo@1", factor=1.4),
        ),
        _preset(
            "relaxed_slower",
            "Longer motion paths in slower time.",
            "relaxed",
            _step("tempo@1", factor=0.75),
            _grid(path=1.5),
        ),
        _preset(
            "nervous",
            "Path length and rhythm change at random during the motion.",
            "afraid",
            _step("vary@1", path=0.8, rhythm=0.5, seed=1),
        ),
    )
}
