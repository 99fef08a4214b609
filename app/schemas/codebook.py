"""The codebook of an exported table: what each column means."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict

Kind = Literal["text", "category", "integer", "number", "time"]
Table = Literal["long", "wide"]


class Entry(BaseModel):
    """A part of the codebook."""

    model_config = ConfigDict(frozen=True)


class Level(Entry):
    """A value that a column may hold, and what it stands for."""

    value: int | str
    label: str


class Column(Entry):
    """One column; `levels` are all its values where they can be counted."""

    name: str
    meaning: str
    type: Kind
    unit: str | None = None
    levels: tuple[Level, ...] = ()


class Codebook(Entry):
    """All columns of one table, in its order."""

    study: str
    study_hash: str
    title: str
    table: Table
    columns: tuple[Column, ...]
