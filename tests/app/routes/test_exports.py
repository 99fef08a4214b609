"""The downloads of a study, over HTTP."""

import csv
import io
import json
import re
import zipfile

import pytest

from app.services import exports
from app.studies import emotion
from tests.support.simulate import add_study, simulate

PAGE = f"/research/studies/{emotion.SLUG}"
FILES = {
    "responses.csv": ("text/csv; charset=utf-8", "responses.csv"),
    "wide.csv": ("text/csv; charset=utf-8", "wide.csv"),
    "responses.jsonl": ("application/jsonl", "responses.jsonl"),
    "codebook.csv": ("text/csv; charset=utf-8", "codebook.csv"),
    "codebook.json": ("application/json", "codebook.json"),
    "analysis.R": ("text/plain; charset=utf-8", "analysis.R"),
    "analysis.ipynb": ("application/x-ipynb+json", "analysis.ipynb"),
    "psych-ds.zip": ("application/zip", "psych-ds.zip"),
}


@pytest.fixture
def study(client, database):
    with database.writing() as db:
        add_study(db)
    simulate(client.app.state.writer.write, 2)


@pytest.mark.parametrize("file", FILES)
def test_a_download_is_a_file_with_a_name_and_a_type(signed_in, study, file):
    answer = signed_in.get(f"{PAGE}/{file}")
    kind, name = FILES[file]
    assert answer.status_code == 200
    assert answer.headers["content-type"] == kind
    assert answer.headers["content-disposition"] == f'attachment; filename="{emotion.SLUG}-{name}"'
    assert len(answer.content) > 500


@pytest.mark.parametrize("file", FILES)
def test_only_a_researcher_gets_it(client, study, file):
    answer = client.get(f"{PAGE}/{file}")
    assert answer.status_code == 303
    assert answer.headers["location"].startswith("/research/sign-in?next=")


@pytest.mark.parametrize("file", FILES)
def test_a_study_that_is_not_there_is_an_error_page(signed_in, study, file):
    answer = signed_in.get(f"/research/studies/nothing/{file}")
    assert answer.status_code == 404
    assert "There is no study" in answer.text


def test_the_page_leads_to_every_download_and_says_what_it_is_for(signed_in, study):
    text = signed_in.get(PAGE).text
    (menu,) = re.findall(r'<details class="downloads">.*?</details>', text, re.DOTALL)
    links = re.findall(r'<a href="([^"]+)" download>.*?class="purpose">([^<]+)<', menu)
    # The codebook for programs is in the dataset's description; the menu has the one for people.
    assert {link for link, _ in links} == {
        f"{PAGE}/{file}" for file in FILES if file != "codebook.json"
    } | {f"{PAGE}/recruiting.csv"}
    assert len({purpose for _, purpose in links}) == len(links)


def test_the_downloads_are_of_one_study(signed_in, study):
    rows = list(csv.DictReader(io.StringIO(signed_in.get(f"{PAGE}/responses.csv").text)))
    lines = signed_in.get(f"{PAGE}/responses.jsonl").text.splitlines()
    wide = list(csv.DictReader(io.StringIO(signed_in.get(f"{PAGE}/wide.csv").text)))
    assert len(rows) == len(lines) == 2 * 22
    assert [row["session"] for row in wide] == list(dict.fromkeys(r["session"] for r in rows))
    assert [json.loads(line)["trial_index"] for line in lines] == [
        int(row["trial_index"]) for row in rows
    ]
    with zipfile.ZipFile(io.BytesIO(signed_in.get(f"{PAGE}/psych-ds.zip").content)) as archive:
        assert sum("/data/" in name for name in archive.namelist()) == 2


@pytest.mark.parametrize("table", ["long", "wide"])
def test_either_table_has_its_codebook(signed_in, study, table):
    book = signed_in.get(f"{PAGE}/codebook.json?table={table}").json()
    rows = csv.DictReader(io.StringIO(signed_in.get(f"{PAGE}/codebook.csv?table={table}").text))
    file = "wide.csv" if table == "wide" else "responses.csv"
    heads = signed_in.get(f"{PAGE}/{file}").text.splitlines()[0].split(",")
    assert [row["column"] for row in rows] == heads
    assert [column["name"] for column in book["columns"]] == heads
    assert (book["study"], book["table"]) == (emotion.SLUG, table)


def test_a_spreadsheet_is_told_no_formula_by_the_codebook(signed_in, study):
    rows = csv.reader(io.StringIO(signed_in.get(f"{PAGE}/codebook.csv").text))
    assert not any(cell.startswith(exports.DANGEROUS) for row in rows for cell in row)
