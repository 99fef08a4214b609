"""``make bench``: one table of speeds, peers beside us in the same run."""

from __future__ import annotations

import math
import sys
import tempfile
from pathlib import Path

from rich.console import Console
from rich.table import Table

from tests.bench import (
    api_rows,
    batch_rows,
    blending_rows,
    editing_rows,
    live_rows,
    motion_rows,
    space_rows,
    statistics_rows,
    web_rows,
)
from tests.bench.measure import RUNS, Row

SECTIONS = {
    "motion": motion_rows.rows,
    "editing": editing_rows.rows,
    "blending": blending_rows.rows,
    "api": api_rows.rows,
    "batch": batch_rows.rows,
    "spaces": space_rows.rows,
    "live": live_rows.rows,
    "statistics": statistics_rows.rows,
    "web": web_rows.rows,
}


def main(chosen: list[str]) -> None:
    """Run the chosen sections, or all, and print the table."""
    console = Console()
    found: list[Row] = []
    with tempfile.TemporaryDirectory() as scratch:
        for name, rows in SECTIONS.items():
            if not chosen or name in chosen:
                with console.status(f"measuring: {name}"):
                    found += rows(Path(scratch))
    console.print(table(found))


def table(rows: list[Row]) -> Table:
    """The table; a subject is named once, with its contenders under it."""
    result = Table(title=f"Medians of {RUNS} or more runs, taken in turn", title_justify="left")
    for name in ("what", "who"):
        result.add_column(name)
    for name in ("median", "unit", "min … max", "aim"):
        result.add_column(name, justify="right" if name in ("median", "min … max") else "left")
    before = ""
    for row in rows:
        spread = f"{row.spread[0]:,.1f} … {row.spread[1]:,.1f}" if row.spread else ""
        subject = row.what if row.what != before else ""
        median = "–" if math.isnan(row.value) else f"{row.value:,.1f}"
        result.add_row(subject, row.who, median, row.unit, spread, row.aim)
        before = row.what
    return result


if __name__ == "__main__":
    main(sys.argv[1:])
