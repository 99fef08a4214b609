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
from app.schemas.study import StudyDefinition
from app.services import analysis, answers, exports, psych_ds, results, sessions
from app.services.versions import Version
from app.studies import emotion
from tests.support.simulate import add_study, answer_with, directly, simulate, take_part

NEUTRAL = dict.fromkeys((scale["id"] for scale in emotion.SCALES), 0)
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
def found(database):
    return exports.exported(database, emotion.SLUG)


@pytest.fixture
def shown(database):
    """What the results page shows."""

    def shown(against="others"):
        with database.reading() as db:
            return results.results(db, emotion.SLUG, against)

    return shown


@pytest.fixture
def folder(database, found, tmp_path):
    """The long table, as it is downloaded, and nothing else."""
    text = "".join(exports.responses_csv(found))
    (tmp_path / analysis.answers_file(found)).write_text(text, "utf-8", newline="")
    return tmp_path


def code_of(notebook):
    return "\n".join(cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code")


def run_notebook(notebook, folder):
    """All code cells in a process of their own; the tables that they made."""
    tables = ", ".join(f'"{one}": {one}.to_dict("records")' for one in ("means", "shares", "poles"))
    tell = f"import json\nprint(json.dumps({{{tables}}}))"
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
def test_the_notebook_finds_the_pages_numbers(found, folder, shown, against):
    notebook = analysis.notebook(found)
    for cell in notebook["cells"]:
        cell["source"] = cell["source"].replace('AGAINST = "others"', f'AGAINST = "{against}"')
    assert f'AGAINST = "{against}"' in code_of(notebook)
    hold_against_page(run_notebook(notebook, folder), shown(against))


@pytest.mark.parametrize("against", ["others", "all"])
def test_the_r_script_finds_the_pages_numbers(found, folder, shown, against):
    if not shutil.which("Rscript"):
        pytest.skip("R is not installed here; the script's form is tested all the same")
    script = analysis.r_script(found).replace('against <- "others"', f'against <- "{against}"')
    hold_against_page(run_r(script, folder), shown(against))


def test_in_the_dataset_both_read_the_participants_files(database, found, shown, tmp_path):
    archive = tmp_path / "dataset.zip"
    archive.write_bytes(b"".join(psych_ds.dataset_zip(found)))
    with zipfile.ZipFile(archive) as opened:
        opened.extractall(tmp_path)
    folder = tmp_path / emotion.SLUG / "analysis"
    notebook = json.loads((folder / "analysis.ipynb").read_text("utf-8"))
    hold_against_page(run_notebook(notebook, folder), shown())
    if shutil.which("Rscript"):
        hold_against_page(run_r((folder / "analysis.R").read_text("utf-8"), folder), shown())


def test_everybody_answering_the_middle_stops_neither(found, folder):
    table = folder / analysis.answers_file(found)
    with table.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    with table.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(row | dict.fromkeys(NEUTRAL, 0) for row in rows)
    made = [run_notebook(analysis.notebook(found), folder)]
    if shutil.which("Rscript"):
        made.append(run_r(analysis.r_script(found), folder))
    for tables in made:
        assert {float(row["difference"]) for row in tables["poles"]} == {0.0}
        assert {str(row["p_holm"]).lower() for row in tables["poles"]} <= {"nan", "na"}


def test_pandas_opens_the_table_without_options(database, found, folder):
    read = pd.read_csv(folder / analysis.answers_file(found))
    written = [json.loads(line) for line in lines_of(database)]
    assert len(read) == len(written)
    for column in exports.codebook(found).columns:
        if column.type in ("integer", "number"):
            assert pd.api.types.is_numeric_dtype(read[column.name]), column.name
            given = [np.nan if row[column.name] is None else row[column.name] for row in written]
            assert np.array_equal(read[column.name], np.array(given, float), equal_nan=True)
    assert set(COMMENTS) - {"", "NA"} == {
        comment.removeprefix("'") if comment != "'" else comment
        for comment in read["comment"].dropna()
    }


def lines_of(database):
    return b"".join(exports.responses_jsonl(exports.exported(database, emotion.SLUG))).splitlines()


def test_the_notebook_is_a_valid_one_without_outputs(found):
    text = json.dumps(analysis.notebook(found))
    notebook = nbformat.reads(text, as_version=nbformat.NO_CONVERT)
    nbformat.validate(notebook)
    kinds = [cell.cell_type for cell in notebook.cells]
    assert kinds == ["markdown", "code"] * 5
    assert all(cell.outputs == [] for cell in notebook.cells if cell.cell_type == "code")


def test_the_r_scripts_brackets_and_strings_are_closed(found):
    script = analysis.r_script(found)
    bare = re.sub(r'"(?:[^"\\\n]|\\.)*"', "", script)  # without its strings
    bare = "\n".join(line.partition("#")[0] for line in bare.splitlines())
    assert '"' not in bare
    for opening, closing in ("()", "{}", "[]"):
        assert bare.count(opening) == bare.count(closing) > 0
    (part,) = found.newest.definition.trials
    for scale in part.task.scales:
        assert f'"{scale.id}" = c("emotions", "{scale.left}", "{scale.right}")' in script
    assert all(f'"{clip.clip}"' in script for clip in part.stimuli)


HOSTILE = (
    'x"); system("touch harmed") #',
    "line\n__import__('os').system('touch harmed')\n# The study\n",
    "\u202ereversed\u2028 \U0001f6b6 \\ '' ``` \x00 end",
    "```\n\nimport os\nos.system('touch harmed')\n```python\n",
)


def test_no_word_of_a_study_becomes_code(found, folder):
    told = found.newest.definition.model_dump(mode="json")
    told["title"] = HOSTILE[1]
    (part,) = told["parts"]
    for scale, clip, text in zip(part["task"]["scales"], part["stimuli"], HOSTILE, strict=False):
        scale["left"] = clip["label"] = clip["body"] = text
    version = Version.of(1, "0" * 64, StudyDefinition.model_validate(told), {})
    odd = found._replace(versions={1: version})
    tables = run_notebook(analysis.notebook(odd), folder)
    seen = [text.replace("\0", "").strip() for text in HOSTILE]
    assert [row["pole"] for row in tables["poles"][:8:2]] == seen
    assert [row["clip"] for row in tables["means"][:4]] == seen
    script = analysis.r_script(odd)
    assert len(script.splitlines()) == len(analysis.r_script(found).splitlines())
    if shutil.which("Rscript"):
        run_r(script, folder)
    assert not (folder / "harmed").exists()
