"""The results page of a study with several parts, kinds of trial, and simulated participants."""

import re

import numpy as np
import pytest
from sqlalchemy import select

from app.persistence.models import Researcher, StudyMember
from app.schemas.effects import Effects
from app.services import simulation, studies
from app.services.effects import tastes
from tests.support import kinds

PAGE = f"/research/studies/{kinds.SLUG}"
API = f"/api/v1/studies/{kinds.SLUG}/results"


@pytest.fixture
def study(client, database):
    """Six simulated participants of the study; nobody else took it."""
    with database.writing() as db:
        kinds.add_every_kind(db)
        definition = studies.definition_of(studies.newest(db, studies.find(db, kinds.SLUG)))
        felt = tastes(definition, Effects())
        for rater in simulation.raters(felt, Effects(), 6, np.random.default_rng(1)):
            simulation.take_part(db, kinds.SLUG, rater)
        db.commit()


def test_simulated_answers_are_shown_on_request_and_under_a_banner(signed_in, study):
    people, made = signed_in.get(PAGE).text, signed_in.get(f"{PAGE}?kind=simulated").text
    assert "No answers yet" in people
    assert "6 simulated participants are kept apart" in people
    assert "Nobody gave these answers" in made
    assert "Nobody gave these answers" not in people
    assert f"{PAGE}/responses.csv?kind=simulated" in made
    assert re.search(r"Complete</dt>\s*<dd>6", made)
    assert re.search(r"Complete</dt>\s*<dd>0", people)
    assert f'data-address="{PAGE}/counts?kind=simulated"' in made


def test_the_page_begins_with_a_choice_of_parts(signed_in, study):
    for part in ("pairs", "best", "words"):
        text = signed_in.get(f"{PAGE}?kind=simulated&part={part}").text
        (nav,) = re.findall(r'<nav class="chips part-switch".*?</nav>', text, re.DOTALL)
        assert len(re.findall("<a ", nav)) == 10
        assert re.findall(r'aria-current="true">(\w+)<', nav) == [part]
        assert f'href="?part={part}&amp;kind=simulated"' in nav


def test_choices_are_a_chart_a_sentence_and_a_table(signed_in, study):
    text = signed_in.get(f"{PAGE}?kind=simulated&part=two").text
    found = signed_in.get(f"{API}?kind=simulated&part=two").json()
    (choices,) = found["choices"]
    assert choices["sentence"] in text.replace("&#34;", '"')
    assert '<still-chart class="chart" name="chosen-choice"' in text
    for row in choices["rows"]:
        assert f'<td class="number">{row["chosen"]}</td>' in text
    assert "axis-charts" not in re.sub(r"<script.*", "", text, flags=re.DOTALL)


def test_a_chart_of_any_part_can_be_printed(signed_in, study):
    answer = signed_in.get(f"{PAGE}/figures/chosen-correct.svg?part=third&kind=simulated")
    assert answer.headers["content-type"].startswith("image/svg+xml")
    assert "all pairs" in answer.text
    assert signed_in.get(f"{PAGE}/figures/chosen-correct.svg?part=third").status_code == 404


def test_an_unknown_part_is_an_error_page(signed_in, study):
    answer = signed_in.get(f"{PAGE}?part=mood")
    assert answer.status_code == 404
    assert "no part" in answer.text
    assert signed_in.get(f"{API}?kind=preview").status_code == 422


def test_whom_to_pay_is_for_owners_alone(signed_in, study, database, researcher):
    assert signed_in.get(f"{PAGE}/recruiting.csv").text.startswith("id,submission,source")
    assert "recruiting.csv" in signed_in.get(PAGE).text
    with database.writing() as db:
        viewer = db.scalars(select(Researcher)).one()
        owner = Researcher(email="o@example.org", name="Olga", password_hash="x")
        db.add(owner)
        db.flush()
        known = studies.find(db, kinds.SLUG).id
        db.add(StudyMember(study_id=known, researcher_id=viewer.id, role="viewer"))
        db.add(StudyMember(study_id=known, researcher_id=owner.id, role="owner"))
        db.commit()
    assert signed_in.get(f"{PAGE}/recruiting.csv").status_code == 403
    assert "recruiting.csv" not in signed_in.get(PAGE).text
    assert signed_in.get(f"{PAGE}/responses.csv").status_code == 200
