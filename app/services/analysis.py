"""An R script and a Python notebook that repeat the results page from the long table.

Their texts are templates/analysis/; what they must know of the study is put in at the top, so that
they need nothing but the table.
"""

from __future__ import annotations

import re
from typing import Any

from app.schemas.study import StudyDefinition
from app.services.export_columns import about_scales
from app.services.results import NEEDED
from app.settings import PROJECT

FOLDER = PROJECT / "templates" / "analysis"
PLACE = "# The study\n"  # where the study's own lines go


def answers_file(definition: StudyDefinition) -> str:
    """The name under which the long table is downloaded."""
    return f"{definition.slug}-responses.csv"


def r_script(definition: StudyDefinition) -> str:
    """The script for R."""
    text = (FOLDER / "analysis.R").read_text(encoding="utf-8")
    return text.replace(PLACE, PLACE + _for_r(definition))


def notebook(definition: StudyDefinition) -> dict[str, Any]:
    """The notebook (nbformat 4.5), without outputs."""
    text = (FOLDER / "notebook.md").read_text(encoding="utf-8")
    # Odd parts stand between fences: code. Split first: the study's words may hold anything.
    parts = re.split(r"^```(?:python)?\n", text, flags=re.MULTILINE)
    cells = [_cell(index, part, definition) for index, part in enumerate(parts) if part.strip()]
    return {
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {
            "kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"},
            "language_info": {"name": "python"},
        },
        "cells": cells,
    }


def _cell(index: int, text: str, definition: StudyDefinition) -> dict[str, Any]:
    known = {"id": f"part-{index}", "metadata": {}}
    if index % 2 == 0:
        return {"cell_type": "markdown", **known, "source": text.strip()}
    source = text.replace(PLACE, PLACE + _for_python(definition)).strip()
    return {
        "cell_type": "code", **known, "source": source, "outputs": [], "execution_count": None
    }  # fmt: skip


def _for_python(definition: StudyDefinition) -> str:
    scales = [
        f"    {quoted(name)}: ({quoted(scale.left)}, {quoted(scale.right)}),"
        for name, scale in about_scales(definition)
    ]
    clips = [
        f"    {quoted(shown.clip)}: ({quoted(shown.label)}, {quoted(shown.body)}),"
        for shown in definition.stimuli
    ]
    return "\n".join([
        f"ANSWERS = {quoted(answers_file(definition))}",
        f"NEEDED = {NEEDED}  # participants, below which nothing is computed",
        "SCALES = {  # column: left and right pole", *scales, "}",
        "CLIPS = {  # content hash: label and body, in the study's order", *clips, "}", "",
    ])  # fmt: skip


def _for_r(definition: StudyDefinition) -> str:
    scales = [
        f"{quoted(name)} = c({quoted(scale.left)}, {quoted(scale.right)})"
        for name, scale in about_scales(definition)
    ]
    stimuli = definition.stimuli
    clips = [
        f"{name} = c({_joined([quoted(value) for value in values], 4)})"
        for name, values in (
            ("hash", [shown.clip for shown in stimuli]),
            ("label", [shown.label for shown in stimuli]),
            ("body", [shown.body for shown in stimuli]),
        )
    ]
    return "\n".join([
        f"answers_file <- {quoted(answers_file(definition))}",
        f"needed <- {NEEDED}  # participants, below which nothing is computed",
        f"scales <- list({_joined(scales, 2)})  # column: left and right pole",
        f"clips <- data.frame({_joined(clips, 2)})  # in the study's order", "",
    ])  # fmt: skip


def _joined(parts: list[str], indent: int) -> str:
    before = "\n" + " " * indent
    return before + f",{before}".join(parts)


def quoted(text: str) -> str:
    """Text as a string of both Python and R: one line, and nothing in it that is not seen."""
    return '"' + "".join(_character(one) for one in text if one != "\0") + '"'


def _character(one: str) -> str:
    if one in '"\\':
        return f"\\{one}"
    return one if one.isprintable() else f"\\U{ord(one):08x}"
