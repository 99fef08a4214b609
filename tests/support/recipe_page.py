"""Writes docs/recipes.md: what a recipe is, and every operation and preset from the code.

Run as ``python -m tests.support.recipe_page``.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from motion.procedural.stances import STANCES
from motion.recipe import OPERATIONS, PRESETS, Operation, Preset

PAGE = Path(__file__).parents[2] / "docs" / "recipes.md"

_HEAD = """# Recipes

A recipe is an edit as data: a list of operations, each with a version and its parameters, done one
after the other.

```json
[
  {"operation": "grid@1", "parameters": {"path": 0.4}},
  {"operation": "posture@1", "parameters": {"offsets": [{"pose": "head_down", "amount": 0.8}]}}
]
```

- **Reading** fills in what is left out, turns numbers into floats and refuses everything else: an
  unknown operation or parameter, a number out of its range, a list that is too long. The error
  names the place (`0, "parameters", "path"`) and what to write there.
- **One recipe, one hash.** The canonical text has all parameters, sorted keys and no spaces; its
  SHA-256 is the recipe's hash. The order of steps matters, the order of keys does not.
- **The same bits again.** A recipe on the same clip, under the same version of the engine, gives
  the same motion to the bit. Chance comes from a seed, which is a parameter.
- **Versions.** An operation whose result changes under the same parameters gets a new version; the
  old one stays what it was.
- **References.** A pose is a stance's name, which is always there, or the id of a pose captured
  from a clip. A clip is the id of one in the library.
- **Feet.** Where longer or shorter paths, a posture, key poses, limits or an emotion move the legs,
  feet stand again where they stood before the step, as far as the skeleton's legs are known.
- **Ease off.** Every amount has a neutral value, at which it does nothing. A recipe can be taken
  back to a share of the way from there; *ease off* finds the greatest share, to 1/64, that the
  quality report finds clean. Settings, such as a frame rate or the ends of a cut, stay.
- **Judged in its own time.** An edited clip is compared with the original in the recipe's time: as
  fast, cut at the same moments. So another tempo alone is no fault.
- **Limits.** At most 32 steps; a result has at most 200 000 frames.

In Python: `Recipe.parse(document).apply(clip, Materials(poses, clips))`; `check_recipe` and
`ease_off_recipe` judge it. Over HTTP: `GET /api/v1/operations` gives this page's tables as JSON
Schema, `GET /api/v1/presets` the presets, `POST /api/v1/clips` makes a clip.

## Operations

Neutral is where a number does nothing; a number without one is a setting. Stances: {stances}.
"""

_PRESETS = """## Presets

Recipes for emotions: the twelve of figure 29 of Förger's thesis and what he proposes beyond them.
What each changes, measured: [presets](presets.md).

| preset | meant as | what it does | operations |
|---|---|---|---|"""


def page() -> str:
    """The whole of docs/recipes.md."""
    operations = [line for operation in OPERATIONS.values() for line in _section(operation)]
    presets = [_preset(preset) for preset in PRESETS.values()]
    stances = ", ".join(f"`{name}`" for name in STANCES)
    return "\n".join([_HEAD.replace("{stances}", stances), *operations, _PRESETS, *presets, ""])


def _section(operation: Operation) -> Iterator[str]:
    yield f"### {operation.title}: `{operation.key}`\n"
    yield f"{operation.summary}\n"
    rows = list(_rows(operation.to_schema(), ""))
    if not rows:
        yield "No parameters.\n"
        return
    yield "| parameter | what | range | default | neutral |\n|---|---|---|---|---|"
    yield from rows
    yield ""


def _rows(schema: Mapping[str, Any], path: str) -> Iterator[str]:
    needed = schema.get("required", [])
    for name, part in schema["properties"].items():
        place = f"{path}{name}"
        what = f"{part['title']}. {part.get('description', '')}".strip()
        default = "needed" if name in needed else f"`{json.dumps(part.get('default'))}`"
        neutral = f"{part['neutral']:g}" if "neutral" in part else ""
        yield f"| `{place}` | {what} | {_range(part)} | {default} | {neutral} |"
        if part.get("items", {}).get("properties"):
            yield from _rows(part["items"], f"{place}[].")
        if part.get("properties"):
            yield from _rows(part, f"{place}.")


def _range(part: Mapping[str, Any]) -> str:
    if "enum" in part:
        return (
            ", ".join(f"`{name}`" for name in part["enum"]) if len(part["enum"]) < 8 else "a role"
        )
    if "anyOf" in part:
        return "a stance or the id of a pose"
    if "pattern" in part:
        return f"id of a {part['refers']}"
    if "minimum" in part:
        low, high = (f"{float(part[end]):.12g}" for end in ("minimum", "maximum"))
        return f"{low} … {high} {part.get('unit', '')}".strip()
    if "items" in part:
        inner = "" if "properties" in part["items"] else f" of {_range(part['items'])}"
        return f"{part['minItems']} to {part['maxItems']} entries{inner}"
    if "properties" in part:
        return f"up to {len(part['properties'])} values"
    return str(part["type"])


def _preset(preset: Preset) -> str:
    steps = ", ".join(f"`{step['operation']}`" for step in preset.operations.to_list()) or "none"
    return f"| `{preset.name}` | {preset.pole} | {preset.summary} | {steps} |"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
