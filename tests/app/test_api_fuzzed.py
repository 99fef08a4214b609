"""The whole API under drawn requests: it keeps to its own document and never fails."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import hypothesis
import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from schemathesis.checks import not_a_server_error
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_headers_conformance,
    response_schema_conformance,
    status_code_conformance,
)
from starlette.testclient import TestClient

from app.main import create_app
from app.persistence import schema as tables
from app.persistence.engine import Database
from app.persistence.models import Researcher
from app.services import keys, new_spaces, samples
from app.services.space_clips import Source
from app.services.space_making import define
from app.settings import Settings
from motion.recipe import OPERATIONS, PRESETS
from motion.storage import clip_to_bytes
from tests.support.motions import walk, walks

CHECKS = [
    not_a_server_error,
    status_code_conformance,
    content_type_conformance,
    response_headers_conformance,
    response_schema_conformance,
]
SOURCE = walk().content_hash
SPACE = define(
    "Walks", [Source(w.clip.content_hash, w.name, clip_to_bytes(w.clip)) for w in walks()], {}
)
DOCUMENT = create_app(Settings(database_url="sqlite://", secret_key="x" * 40)).openapi()
OPERATION_NAMES = [
    (method.upper(), path)
    for path, item in DOCUMENT["paths"].items()
    for method in item
    if method in ("get", "post", "put", "patch", "delete")
]
API = schemathesis.openapi.from_dict(DOCUMENT)


def bounded(examples: int) -> settings:
    """The same requests in every run, and so many of them."""
    return settings(
        max_examples=examples,
        derandomize=True,
        database=None,
        deadline=None,
        phases=(Phase.explicit, Phase.generate),  # making a fault smaller would take minutes
        # Each test's requests go to one server; what one has stored the next may find.
        suppress_health_check=list(HealthCheck),
    )


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory, built: Path) -> Iterator[TestClient]:
    """One server with the samples and a key for writing, for all requests of this module."""
    folder = tmp_path_factory.mktemp("fuzzed")
    app = create_app(Settings(data_directory=folder, log_level="error"), built)
    database: Database = app.state.database
    tables.upgrade(database.engine)
    samples.make(database, walks)
    with database.writing() as db:
        researcher = Researcher(email="rosa@example.org", name="Rosa", password_hash="")
        db.add(researcher)
        db.commit()
        app.state.key = keys.make(db, researcher.id, "fuzzing", "write").secret
        new_spaces.keep(db, SPACE, study_id=None, made_by=None)  # and nobody can delete it
        db.commit()
    with TestClient(app, raise_server_exceptions=False) as client:
        yield client


def sent(server: TestClient, case: schemathesis.Case, with_key: bool) -> Any:
    key = {"Authorization": f"Bearer {server.app.state.key}"} if with_key else {}
    request = case.as_transport_kwargs(base_url="http://testserver", headers=key)
    server.cookies = request.pop("cookies")
    if isinstance(request.get("data"), bytes | str):
        request["content"] = request.pop("data")
    if "files" in request:  # our client sends text and bytes only
        request["files"] = [(name, as_file(part)) for name, part in request["files"]]
    response = server.request(**request)
    if not isinstance(response.request.stream, bytes):
        response.request.read()  # a form's parts, which the checks want to see
    return response


def as_file(part: Any) -> Any:
    if isinstance(part, tuple):
        return (part[0], as_file(part[1]), *part[2:])
    return part if isinstance(part, bytes) else str(part)


@pytest.mark.parametrize("with_key", [True, False], ids=["key", "no key"])
@pytest.mark.parametrize(("method", "path"), OPERATION_NAMES)
def test_every_answer_is_one_that_the_document_names(
    server: TestClient, method: str, path: str, with_key: bool
) -> None:
    operation = API[path][method]
    answered = []

    @bounded(12 if with_key else 3)
    @given(case=operation.as_strategy(), real=st.booleans())
    def holds(case: schemathesis.Case, real: bool) -> None:
        if real:  # otherwise hardly a request would get further than to a clip that is not there
            point_to_what_is_there(case)
        response = sent(server, case, with_key)
        case.validate_response(response, checks=CHECKS)
        answered.append(response.status_code)

    holds()
    assert answered


def point_to_what_is_there(case: schemathesis.Case) -> None:
    if "clip_id" in case.path_parameters:
        case.path_parameters["clip_id"] = SOURCE
    if "name" in case.path_parameters:
        case.path_parameters["name"] = "grid@1"
    if "space_id" in case.path_parameters:
        case.path_parameters["space_id"] = SPACE.content_hash
    if isinstance(case.body, dict):
        if "interface" in case.body:
            case.body |= {"interface": "features", "values": {"step_length": 0.3}}
        case.body |= {name: SOURCE for name in ("source", "clip") if name in case.body}


def drawn(schema: dict[str, Any]) -> st.SearchStrategy[Any]:
    """Values that a parameter's JSON Schema allows, its ends among them."""
    if "anyOf" in schema:
        return st.one_of([drawn(one) for one in schema["anyOf"]])
    if "enum" in schema:
        return st.sampled_from(schema["enum"])
    kinds = schema["type"] if isinstance(schema["type"], list) else [schema["type"]]
    if kinds[-1] == "null":
        return st.none() | drawn({**schema, "type": kinds[0]})
    low, high = schema.get("minimum"), schema.get("maximum")
    match kinds[0]:
        case "object":
            members = {name: drawn(one) for name, one in schema["properties"].items()}
            needed = {name: members.pop(name) for name in schema.get("required", [])}
            return st.fixed_dictionaries(needed, optional=members)
        case "array":
            return st.lists(drawn(schema["items"]), max_size=3)
        case "number":
            return st.sampled_from([low, high]) | st.floats(low, high)
        case "integer":
            return st.integers(low, high)
        case "boolean":
            return st.booleans()
    return st.sampled_from([SOURCE, "0" * 64])  # a clip's or a pose's id


def steps() -> st.SearchStrategy[Any]:
    one = st.sampled_from(sorted(OPERATIONS)).flatmap(
        lambda name: st.fixed_dictionaries(
            {"operation": st.just(name), "parameters": drawn(OPERATIONS[name].to_schema())}
        )
    )
    return st.lists(one, max_size=4)


anything = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner),
    max_leaves=6,
)


def recipe_answer(server: TestClient, path: str, operations: Any) -> Any:
    # Written by hand, because httpx refuses to send infinite numbers, which others will.
    body = json.dumps({"source": SOURCE, "operations": operations})
    headers = {
        "Authorization": f"Bearer {server.app.state.key}",
        "Content-Type": "application/json",
    }
    return server.post(f"/api/v1/clips{path}", content=body, headers=headers)


@bounded(40)
@given(operations=steps(), path=st.sampled_from(["", "/preview", "/check"]))
@hypothesis.example(operations=PRESETS["sad"].operations.to_list(), path="")
def test_every_recipe_within_its_ranges_is_done_or_refused_with_a_reason(
    server: TestClient, operations: Any, path: str
) -> None:
    answer = recipe_answer(server, path, operations)
    assert answer.status_code in (200, 201, 422), answer.text
    if answer.status_code == 422:
        error = answer.json()["error"]
        assert error["code"] in ("recipe_invalid", "recipe_fails", "motion_unusable"), error
        assert error["message"]


@bounded(80)
@given(operations=anything | st.lists(anything | st.fixed_dictionaries(
    {"operation": st.sampled_from(sorted(OPERATIONS)) | anything, "parameters": anything}
), max_size=3))  # fmt: skip
def test_whatever_stands_in_the_place_of_a_recipe_is_refused_with_its_place(
    server: TestClient, operations: Any
) -> None:
    answer = recipe_answer(server, "/preview", operations)
    assert answer.status_code in (200, 400, 422), answer.text
    if answer.status_code == 422:
        assert answer.json()["error"]["where"]
