"""The dataset against the rules of Psych-DS 1.5.1, each named as its validator names it.

The official validator is a program of its own; `docs/results.md` says how to run it. The rules here
were written from the published schema, not from the exporting code.
"""

import csv
import io
import json
import re
import zipfile
from datetime import UTC, datetime

import numpy as np
import pytest

from app.persistence.engine import Database
from app.schemas.study import StudyDefinition
from app.services import answers, exports, psych_ds, sessions
from app.studies import emotion
from tests.support.simulate import add_study, answer_with, begin, directly, simulate, take_part

NEUTRAL = dict.fromkeys((scale["id"] for scale in emotion.SCALES), 0)
DATAFILE = re.compile(r"([a-z]+-[a-zA-Z0-9]+)(_[a-z]+-[a-zA-Z0-9]+)*_data\.csv")
KEYWORDS = {
    "study", "site", "subject", "session", "task", "condition", "trial", "stimulus", "description",
}  # fmt: skip
# Properties that schema.org knows of each type, as far as a dataset of ours may use them.
SCHEMA_ORG = {
    "Dataset": {
        "name", "description", "schemaVersion", "version", "dateCreated", "variableMeasured",
        "author", "citation", "license", "funder", "url", "identifier", "keywords",
    },
    "PropertyValue": {
        "name", "description", "unitText", "minValue", "maxValue", "value", "valueReference",
    },
}  # fmt: skip


@pytest.fixture
def database(db):
    add_study(db)
    return Database(db.connection())


@pytest.fixture
def withdrawn(db, database):
    """Complete, unfinished and withdrawn participants; the last one's pseudonym."""
    write, generator = directly(db), np.random.default_rng(2)
    simulate(write, 3)
    take_part(write, generator, answered=4)
    token = begin(write, user_agent="Mobile")
    answers.record(db, token, answer_with(NEUTRAL, 0, comment='=1+1,"\r\n'))
    gone = take_part(write, generator)
    pseudonym = str(sessions.open_session(db, gone).id)
    sessions.withdraw(db, gone)
    return pseudonym


def archive_of(database):
    return zipfile.ZipFile(
        io.BytesIO(b"".join(psych_ds.dataset_zip(exports.exported(database, emotion.SLUG))))
    )


def dataset(database):
    """Every file's bytes by its path from the dataset's root."""
    with archive_of(database) as archive:
        assert archive.testzip() is None
        roots = {name.partition("/")[0] for name in archive.namelist()}
        assert roots == {emotion.SLUG}
        return {name.partition("/")[2]: archive.read(name) for name in archive.namelist()}


def rows_of(content):
    return list(csv.DictReader(io.StringIO(content.decode(), newline="")))


def heads(content):
    return next(csv.reader(io.StringIO(content.decode(), newline="")))


def data_files(files):
    return {name: content for name, content in files.items() if name.startswith("data/")}


def faults(node, path="dataset"):
    """What is not schema.org's: types that are not there, properties that a type has not."""
    kind = node.get("@type")
    if kind not in SCHEMA_ORG:
        yield f"OBJECT_TYPE_MISSING {path}"
        return
    for name, value in node.items():
        if name.startswith("@"):
            continue
        if name not in SCHEMA_ORG[kind]:
            yield f"INVALID_SCHEMAORG_PROPERTY {path}.{name}"
        for part in value if isinstance(value, list) else [value]:
            if isinstance(part, dict):
                yield from faults(part, f"{path}.{name}")


def hold_to_the_rules(files):
    assert "dataset_description.json" in files, "MISSING_DATASET_DESCRIPTION"
    described = json.loads(files["dataset_description.json"])
    assert described["@context"] == "https://schema.org/", "INVALID_JSONLD_FORMATTING"
    assert described["@type"] == "Dataset", "INCORRECT_DATASET_TYPE"
    assert {"name", "description", "variableMeasured"} <= set(described), "JSON_KEY_REQUIRED"
    assert list(faults(described)) == []
    assert {"README.md", "CHANGES.md", ".psychdsignore"} <= set(files)
    assert all(files.values()), "FILE_EMPTY"
    variables = [variable["name"] for variable in described["variableMeasured"]]
    assert len(set(variables)) == len(variables)
    assert data_files(files), "MISSING_DATAFILE"
    for name, content in data_files(files).items():
        stem = name.removeprefix("data/")
        assert DATAFILE.fullmatch(stem), "FILENAME_KEYWORD_FORMATTING_ERROR"
        words = {word.partition("-")[0] for word in stem.split("_")[:-1]}
        assert words <= KEYWORDS, "FILENAME_UNOFFICIAL_KEYWORD_WARNING"
        table = list(csv.reader(io.StringIO(content.decode(), newline="")))
        assert table[0], "CSV_HEADER_MISSING"
        assert set(table[0]) <= set(variables), "CSV_COLUMN_MISSING_FROM_METADATA"
        assert {len(row) for row in table} == {len(table[0])}, "CSV_HEADER_LENGTH_MISMATCH"
    assert {head for content in data_files(files).values() for head in heads(content)} == set(
        variables
    )
    ignored = files[".psychdsignore"].decode().split()
    known = ("data/", "dataset_description.json", "README.md", "CHANGES.md", ".psychdsignore")
    for name in files:
        assert name.startswith((*known, *ignored)), "FILE_NOT_CHECKED"


def test_the_dataset_keeps_the_rules(db, database, withdrawn):
    hold_to_the_rules(dataset(database))


def test_a_dataset_that_nobody_answered_yet_keeps_them_too(db, database):
    files = dataset(database)
    hold_to_the_rules(files)
    assert list(data_files(files)) == ["data/study-emotioninwalking_data.csv"]


def test_the_participants_files_together_are_the_long_table(db, database, withdrawn):
    rows = rows_of(
        "".join(exports.responses_csv(exports.exported(database, emotion.SLUG))).encode()
    )
    files = data_files(dataset(database))
    assert len(files) == 5
    for name, content in files.items():
        person = re.search(r"subject-([0-9a-f]+)_", name).group(1)
        own = [row for row in rows if row["session"].replace("-", "") == person]
        assert rows_of(content) == own != []
    assert sum(len(rows_of(content)) for content in files.values()) == len(rows)


def test_who_withdrew_is_nowhere_in_it(db, database, withdrawn):
    files = dataset(database)
    for told in (withdrawn, withdrawn.replace("-", "")):
        assert not any(told in name or told.encode() in files[name] for name in files)


def test_its_codebook_and_description_tell_the_same(db, database, withdrawn):
    files = dataset(database)
    told = rows_of(files["documentation/codebook.csv"])
    described = json.loads(files["dataset_description.json"])["variableMeasured"]
    assert [(one["name"], one["description"]) for one in described] == [
        (row["column"], row["meaning"]) for row in told
    ]
    (scale,) = (one for one in described if one["name"] == "sad_happy")
    assert (scale["minValue"], scale["maxValue"]) == (-2, 2)
    assert [(level["value"], level["name"]) for level in scale["valueReference"]] == [
        (-2, "very sad"), (-1, "rather sad"), (0, "neither"),
        (1, "rather happy"), (2, "very happy"),
    ]  # fmt: skip


def test_the_study_in_it_is_the_one_that_was_run(db, database):
    files = dataset(database)
    run = exports.exported(database, emotion.SLUG).newest
    told = StudyDefinition.model_validate_json(files["materials/study-version-1.json"])
    assert told == run.definition
    described = json.loads(files["dataset_description.json"])
    assert described["version"] == run.hash == told.content_hash
    assert told.content_hash.encode() in files["README.md"]


def test_it_is_sent_while_it_is_made(db, database, monkeypatch):
    simulate(directly(db), 12)
    read = []

    def rows_counted(self, rows=exports.Exported.rows):
        for row in rows(self):
            read.append(row)
            yield row

    monkeypatch.setattr(exports.Exported, "rows", rows_counted)
    monkeypatch.setattr(psych_ds, "PIECE", 4_000)
    pieces, seen = [], []
    for piece in psych_ds.dataset_zip(exports.exported(database, emotion.SLUG)):
        pieces.append(piece)
        seen.append(len(read))
    assert len(pieces) > 5
    assert seen[1] < 12 * 22 == seen[-1]
    assert max(map(len, pieces)) < 20_000
    assert zipfile.ZipFile(io.BytesIO(b"".join(pieces))).testzip() is None


def test_the_days_of_its_files_are_the_day_of_the_export(db, database):
    before = datetime.now(UTC)
    with archive_of(database) as archive:
        for entry in archive.infolist():
            made = datetime(*entry.date_time, tzinfo=UTC)
            assert abs((made - before).total_seconds()) < 3600
