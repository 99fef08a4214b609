"""An R script and a Python notebook that repeat the results page from the long table.

Their texts are templates/analysis/; what they must know of the study is put in at the top, so that
they need nothing but the table.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any, NamedTuple

from app.services.export_columns import named_measures
from app.services.exports import Exported
from app.services.measures import Measure
from app.services.result_axes import NEEDED
from app.services.result_choices import no_figure
from app.services.versions import Pooled, parts_of, pooled
from app.settings import PROJECT

FOLDER = PROJECT / "templates" / "analysis"
PLACE = "# The study\n"  # where the study's own lines go


class Asked(NamedTuple):
    """What the scripts must know: the parts, and their values under their columns' names."""

    parts: list[Pooled]
    measures: list[tuple[str, Measure]]

    @classmethod
    def of(cls, found: Exported) -> Asked:
        """What a study asks about clips."""
        parts = [pooled(found.versions, name) for name in parts_of(found.versions)]
        named = [one for one in named_measures(found.listed) if one[1].of_clips]
        return cls(parts, named)

    def having(self, *ids: str) -> list[tuple[str, Measure]]:
        """The values of these ids."""
        return [one for one in self.measures if one[1].id in ids and not one[1].numeric]

    @property
    def numbers(self) -> list[tuple[str, Measure]]:
        """The values that have means."""
        return [one for one in self.measures if one[1].numeric]

    @property
    def bipolar(self) -> list[str]:
        """The columns of scales between opposite words."""
        return [name for name, one in self.numbers if one.trial_type == "semantic_differential"]

    def without(self, part: str) -> str:
        """What choosing none of the figures is called in a part; empty where it is not allowed."""
        return no_figure(next(one for one in self.parts if one.part == part)) or ""


def answers_file(found: Exported) -> str:
    """The name under which the long table is downloaded."""
    return f"{found.study.slug}-{'' if found.kind == 'participant' else 'simulated-'}responses.csv"


def r_script(found: Exported) -> str:
    """The script for R."""
    text = (FOLDER / "analysis.R").read_text(encoding="utf-8")
    return text.replace(PLACE, PLACE + _for_r(found))


def notebook(found: Exported) -> dict[str, Any]:
    """The notebook (nbformat 4.5), without outputs."""
    text = (FOLDER / "notebook.md").read_text(encoding="utf-8")
    study = _for_python(found)
    # Odd parts stand between fences: code. Split first: the study's words may hold anything.
    parts = re.split(r"^```(?:python)?\n", text, flags=re.MULTILINE)
    cells = [_cell(index, part, study) for index, part in enumerate(parts) if part.strip()]
    return {
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {
            "kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"},
            "language_info": {"name": "python"},
        },
        "cells": cells,
    }


def _cell(index: int, text: str, study: str) -> dict[str, Any]:
    known = {"id": f"part-{index}", "metadata": {}}
    if index % 2 == 0:
        return {"cell_type": "markdown", **known, "source": text.strip()}
    source = text.replace(PLACE, PLACE + study).strip()
    return {
        "cell_type": "code", **known, "source": source, "outputs": [], "execution_count": None
    }  # fmt: skip


def _for_python(found: Exported) -> str:
    asked = Asked.of(found)
    parts = [
        line
        for one in asked.parts
        for line in (
            f"    {quoted(one.part)}: {{",
            *(f"        {quoted(a)}: ({quoted(b)}, {quoted(c)})," for a, b, c in _clips(one)),
            "    },",
        )
    ]
    numbers = [
        f"    {quoted(name)}: ({_row((one.part, one.left, one.right))}),"
        for name, one in asked.numbers
    ]
    choices = [
        f"    {quoted(name)}: ({_row((one.part, asked.without(one.part)))}),"
        for name, one in asked.having("choice")
        if one.trial_type != "abx"
    ]
    correct = [f"    {quoted(name)}: {quoted(one.part)}," for name, one in asked.having("correct")]
    versions = [f"    {quoted(one.part)}: {sorted(one.numbers)}," for one in asked.parts]
    return "\n".join([
        f"ANSWERS = {quoted(answers_file(found))}",
        f"NEEDED = {NEEDED}  # participants, below which nothing is computed",
        "CLIPS = {  # part: id of each clip to its label and body, in the study's order", *parts,
        "}",
        "VERSIONS = {  # part: versions that asked alike, taken together", *versions, "}",
        "NUMBERS = {  # column: part, and the words at the ends", *numbers, "}",
        f"BIPOLAR = [{_row(asked.bipolar)}]  # columns between opposite words",
        "CHOICES = {  # column: part, and what choosing no clip is called", *choices, "}",
        "CORRECT = {  # column: part, of which of two a third one was", *correct, "}", "",
    ])  # fmt: skip


def _for_r(found: Exported) -> str:
    asked = Asked.of(found)
    clips = [f"{quoted(one.part)} = data.frame({_joined(_r_clips(one), 4)})" for one in asked.parts]
    versions = [
        f"{quoted(one.part)} = c({', '.join(map(str, sorted(one.numbers)))})" for one in asked.parts
    ]
    numbers = [
        f"{quoted(name)} = c({_row((one.part, one.left, one.right))})"
        for name, one in asked.numbers
    ]
    choices = [
        f"{quoted(name)} = c({_row((one.part, asked.without(one.part)))})"
        for name, one in asked.having("choice")
        if one.trial_type != "abx"
    ]
    correct = [f"{quoted(name)} = {quoted(one.part)}" for name, one in asked.having("correct")]
    return "\n".join([
        f"answers_file <- {quoted(answers_file(found))}",
        f"needed <- {NEEDED}  # participants, below which nothing is computed",
        f"clips <- list({_joined(clips, 2)})  # of each part, in the study's order",
        f"versions <- list({_joined(versions, 2)})  # that asked alike, taken together",
        f"numbers <- list({_joined(numbers, 2)})  # column: part, and the words at the ends",
        f"bipolar <- c({_row(asked.bipolar)})  # columns between opposite words",
        f"choices <- list({_joined(choices, 2)})  # column: part, what no clip is called",
        f"correct <- list({_joined(correct, 2)})  # column: part, of which of two a third one was",
        "",
    ])  # fmt: skip


def _clips(part: Pooled) -> list[tuple[str, str, str]]:
    """Id, label and body of each clip."""
    return [
        (one.clip or "", str(one.label or one.name or ""), one.body or "") for one in part.stimuli
    ]


def _r_clips(part: Pooled) -> list[str]:
    columns = zip(*_clips(part), strict=True)
    return [
        f"{name} = c({_joined([quoted(value) for value in values], 6)})"
        for name, values in zip(("hash", "label", "body"), columns, strict=True)
    ]


def _row(values: Iterable[str]) -> str:
    return ", ".join(map(quoted, values))


def _joined(parts: list[str], indent: int) -> str:
    before = "\n" + " " * indent
    return before + f",{before}".join(parts) if parts else ""


def quoted(text: str) -> str:
    """Text as a string of both Python and R: one line, and nothing in it that is not seen."""
    return '"' + "".join(_character(one) for one in text if one != "\0") + '"'


def _character(one: str) -> str:
    if one in '"\\':
        return f"\\{one}"
    return one if one.isprintable() else f"\\U{ord(one):08x}"
