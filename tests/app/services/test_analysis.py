"""The R script and the notebook, run as a lab would run them, against the results page."""

import csv
import json
import os
import re
import shutil
import subprocess
import sys
import zipfile

import nbformat
import numpy as np
import pandas as pd
import pytest

from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.services import analysis, answers, exports, psych_ds, results, sessions
from app.studies import emotion
from tests.support.simulate import add_study, answer_with, directly, simulate, take_part

NEUTRAL = dict.fromkeys((scale.id for scale in emotion.SCALES), 0)
COMMENTS = ('=1+1,"NA"\n#', "\r=x", "-2", "", "NA", "'", "歩く\u202e", "a;b\tc")
NUMBERS = (
    "mean", "others", "difference", "t", "df", "p", "p_holm", "d", "d_low", "d_high",
    "paired_t", "paired_df", "paired_p",
)  # fmt: skip


@pytest.fixture(scope="module")
def database(tmp_path_factory):
    """Complete participants, all that must not be analysed, and comments that attack.

    One SQLite for all tests: what the scripts are given is text, from whatever database.
    """
    path = tmp_path_factory.mktemp("answered") / "answered.sqlite3"
    found = Database(make_engine(f"sqlite:///{path}"))
    schema.upgrade(found.engine)
    with found.writing() as db:
        add_study(db)
        write, generator = directly(db), np.random.default_rng(3)
        simulate(write, 7)
        take_part(write, generator, answered=9)
        take_part(write, generator, complete=False)
        changed = take_part(write, generator, complete=False)
        for index, comment in enumerate(COMMENTS):
            again = answer_with(NEUTRAL | {"sad_happy": 2}, 6 + index, 2, comment=comment)
            answers.record(db, changed, again)
        answers.record(db, changed, answer_with(NEUTRAL, 6, revision=3))
        sessions.complete(db, changed)
        db.commit()
    yield found
    found.engine.dispose()


@pytest.fixture(scope="module")
def definition(database):
    return exports.exported(database, emotion.SLUG).definition


@pytest.fixture
def shown(database):
    """What the results page shows."""

    def shown(against="others"):
        with database.reading() as db:
            return results.results(db, emotion.SLUG, against)

    return shown


@pytest.fixture
def folder(database, definition, tmp_path):
    """The long table, as it is downloaded, and nothing else."""
    text = "".join(exports.responses_csv(database, definition.slug))
    (tmp_path / analysis.answers_file(definition)).write_text(text, "utf-8", newline="")
    return tmp_path


def code_of(notebook):
    return "\n".join(cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code")


def run_notebook(notebook, folder):
    """All code cells in a process of their own; the two tables that they made."""
    tables = '{"means": means.to_dict("records"), "poles": poles.to_dict("records")}'
    tell = f"import json\nprint(json.dumps({tables}))"
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", f"{code_of(notebook)}\n{tell}"],
        cwd=folder, env={**os.environ, "PYTHONPATH": ""},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return json.loads(done.stdout.splitlines()[-1])


def run_r(script, folder):
    tell = (
        'write.csv(means, "means.csv", row.names = FALSE)\n'
        'write.csv(poles, "poles.csv", row.names = FALSE)\n'
    )
    (folder / "run.R").write_text(script + tell, "utf-8")
    subprocess.run(["Rscript", "run.R"], cwd=folder, capture_output=True, check=True)
    return {
        name: list(csv.DictReader((folder / f"{name}.csv").read_text("utf-8").splitlines()))
        for name in ("means", "poles")
    }


def hold_against_page(found, page):
    cells = [(axis.id, cell) for axis in page.axes for cell in axis.cells]
    labels = {clip.id: clip.label for clip in page.clips}
    assert len(found["means"]) == len(cells) == 120
    for row, (scale, cell) in zip(found["means"], cells, strict=True):
        assert (row["scale"], row["clip"]) == (scale, labels[cell.clip])
        for name in ("n", "mean", "sd", "low", "high"):
            assert float(row[name]) == pytest.approx(getattr(cell, name), abs=1e-9)
    assert len(found["poles"]) == len(page.poles) == 12
    for row, expected in zip(found["poles"], page.poles, strict=True):
        names = (row["scale"], row["pole"], row["clip"])
        assert names == (expected.scale, expected.pole, expected.clip.label)
        for name in NUMBERS:
            assert float(row[name]) == pytest.approx(getattr(expected, name), rel=1e-6), name


@pytest.mark.parametrize("against", ["others", "all"])
def test_the_notebook_finds_the_pages_numbers(definition, folder, shown, against):
    notebook = analysis.notebook(definition)
    for cell in notebook["cells"]:
        cell["source"] = cell["source"].replace('AGAINST = "others"', f'AGAINST = "{against}"')
    assert f'AGAINST = "{against}"' in code_of(notebook)
    hold_against_page(run_notebook(notebook, folder), shown(against))


@pytest.mark.parametrize("against", ["others", "all"])
def test_the_r_script_finds_the_pages_numbers(definition, folder, shown, against):
    if not shutil.which("Rscript"):
        pytest.skip("R is not installed here; the script's form is tested all the same")
    script = analysis.r_script(definition).replace('against <- "others"', f'against <- "{against}"')
    hold_against_page(run_r(script, folder), shown(against))


def test_in_the_dataset_both_read_the_participants_files(database, definition, shown, tmp_path):
    archive = tmp_path / "dataset.zip"
    archive.write_bytes(b"".join(psych_ds.dataset_zip(database, definition.slug)))
    with zipfile.ZipFile(archive) as opened:
        opened.extractall(tmp_path)
    folder = tmp_path / definition.slug / "analysis"
    notebook = json.loads((folder / "analysis.ipynb").read_text("utf-8"))
    hold_against_page(run_notebook(notebook, folder), shown())
    if shutil.which("Rscript"):
        hold_against_page(run_r((folder / "analysis.R").read_text("utf-8"), folder), shown())


def test_everybody_answering_the_middle_stops_neither(definition, folder):
    table = folder / analysis.answers_file(definition)
    with table.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    with table.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(row | dict.fromkeys(NEUTRAL, 0) for row in rows)
    found = [run_notebook(analysis.notebook(definition), folder)]
    if shutil.which("Rscript"):
        found.append(run_r(analysis.r_script(definition), folder))
    for tables in found:
        assert {float(row["difference"]) for row in tables["poles"]} == {0.0}
        assert {str(row["p_holm"]).lower() for row in tables["poles"]} <= {"nan", "na"}


def test_pandas_opens_the_table_without_options(database, definition, folder):
    read = pd.read_csv(folder / analysis.answers_file(definition))
    written = [json.loads(line) for line in lines_of(database)]
    assert len(read) == len(written)
    for column in exports.codebook(database, definition.slug).columns:
        if column.type in ("integer", "number"):
            assert pd.api.types.is_numeric_dtype(read[column.name]), column.name
            assert list(read[column.name]) == [row[column.name] for row in written]
    assert set(COMMENTS) - {"", "NA"} == {
        comment.removeprefix("'") if comment != "'" else comment
        for comment in read["comment"].dropna()
    }


def lines_of(database):
    return b"".join(exports.responses_jsonl(database, emotion.SLUG)).splitlines()


def test_the_notebook_is_a_valid_one_without_outputs(definition):
    text = json.dumps(analysis.notebook(definition))
    notebook = nbformat.reads(text, as_version=nbformat.NO_CONVERT)
    nbformat.validate(notebook)
    kinds = [cell.cell_type for cell in notebook.cells]
    assert kinds == ["markdown", "code"] * 4
    assert all(cell.outputs == [] for cell in notebook.cells if cell.cell_type == "code")


def test_the_r_scripts_brackets_and_strings_are_closed(definition):
    script = analysis.r_script(definition)
    bare = re.sub(r'"(?:[^"\\\n]|\\.)*"', "", script)  # without its strings
    bare = "\n".join(line.partition("#")[0] for line in bare.splitlines())
    assert '"' not in bare
    for opening, closing in ("()", "{}", "[]"):
        assert bare.count(opening) == bare.count(closing) > 0
    for scale in definition.scales:
        assert f'"{scale.id}" = c("{scale.left}", "{scale.right}")' in script
    assert all(f'"{clip.clip}"' in script for clip in definition.stimuli)


HOSTILE = (
    'x"); system("touch harmed") #',
    "line\n__import__('os').system('touch harmed')\n# The study\n",
    "\u202ereversed\u2028 \U0001f6b6 \\ '' ``` \x00 end",
    "```\n\nimport os\nos.system('touch harmed')\n```python\n",
)


def test_no_word_of_a_study_becomes_code(definition, folder):
    scales = [
        scale.model_copy(update={"left": text})
        for scale, text in zip(definition.scales, HOSTILE, strict=False)
    ]
    clips = [
        clip.model_copy(update={"label": text, "body": text})
        for clip, text in zip(definition.stimuli, HOSTILE, strict=False)
    ]
    odd = definition.model_copy(
        update={
            "title": HOSTILE[1],
            "scales": (*scales, *definition.scales[4:]),
            "stimuli": (*clips, *definition.stimuli[4:]),
        }
    )
    found = run_notebook(analysis.notebook(odd), folder)
    told = [text.replace("\0", "") for text in HOSTILE]
    assert [row["pole"] for row in found["poles"][:8:2]] == told
    assert [row["clip"] for row in found["means"][:4]] == told
    script = analysis.r_script(odd)
    assert len(script.splitlines()) == len(analysis.r_script(definition).splitlines())
    if shutil.which("Rscript"):
        run_r(script, folder)
    assert not (folder / "harmed").exists()
