"""What a researcher sees of a study, over HTTP."""

import csv
import io
import json
import re
import xml.etree.ElementTree as ET

import pytest

from app.studies import emotion
from tests.support.simulate import add_study, simulate

PAGE = f"/research/studies/{emotion.SLUG}"
API = f"/api/v1/studies/{emotion.SLUG}/results"


@pytest.fixture
def study(database):
    with database.writing() as db:
        add_study(db)


@pytest.fixture
def answered(client, study):
    simulate(client.app.state.writer.write, 6)


@pytest.mark.parametrize(
    "address",
    [
        "/research",
        PAGE,
        f"{PAGE}/counts",
        f"{PAGE}/responses.csv",
        f"{PAGE}/figures/means-sad_happy.svg",
    ],
)
def test_without_signing_in_there_is_only_the_way_to_sign_in(client, study, address):
    answer = client.get(address)
    assert answer.status_code == 303
    assert answer.headers["location"].startswith("/research/sign-in?next=")


def test_without_signing_in_the_numbers_are_refused(client, study):
    assert client.get(API).status_code == 401


def test_the_list_leads_to_the_study(signed_in, study):
    assert PAGE in signed_in.get("/research").text
    assert signed_in.get("/research/results").headers["location"] == PAGE


def test_the_page_shows_each_number_of_the_table(signed_in, answered):
    page = signed_in.get(PAGE)
    assert page.status_code == 200
    for row in signed_in.get(API).json()["poles"]:
        assert row["clip"]["label"] in page.text
        assert f"{abs(row['t']):.2f}" in page.text
        assert f"{abs(row['difference']):.2f}" in page.text


def test_the_page_carries_two_charts_an_axis_in_two_modes(signed_in, answered):
    text = signed_in.get(PAGE).text
    (charts,) = re.findall(r'<script type="application/json" id="charts">(.*?)</script>', text)
    charts = json.loads(charts)
    axes = [scale["id"] for scale in emotion.SCALES]
    assert set(charts) == {f"{kind}-{axis}" for kind in ("shares", "means") for axis in axes}
    assert all(set(modes) == {"light", "dark"} for modes in charts.values())


def test_too_few_answers_are_said_to_be_too_few(signed_in, client, study):
    simulate(client.app.state.writer.write, 2)
    page = signed_in.get(PAGE)
    assert page.status_code == 200
    assert "need 5 complete participants" in page.text
    figure = signed_in.get(f"{PAGE}/figures/means-sad_happy.svg")
    assert figure.status_code == 404
    assert "needs five" in figure.text


def test_the_counts_are_a_fragment_of_their_own(signed_in, answered):
    text = signed_in.get(f"{PAGE}/counts").text
    assert "<html" not in text
    assert re.search(r"Complete</dt>\s*<dd>6", text)


def test_the_thesis_comparison_is_one_question_away(signed_in, answered):
    others, everything = signed_in.get(API).json(), signed_in.get(f"{API}?against=all").json()
    assert (others["against"], everything["against"]) == ("others", "all")
    for one, other in zip(others["poles"], everything["poles"], strict=True):
        # Ten clips a body: with the best one in the group the difference shrinks by a tenth.
        assert other["difference"] == pytest.approx(0.9 * one["difference"])
    assert signed_in.get(f"{API}?against=nobody").status_code == 422


def test_the_raw_answers_come_as_a_file(signed_in, answered):
    answer = signed_in.get(f"{PAGE}/responses.csv")
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    assert "attachment" in answer.headers["content-disposition"]
    rows = list(csv.DictReader(io.StringIO(answer.text)))
    assert len(rows) == 6 * 22


@pytest.mark.parametrize("mode", ["light", "dark"])
@pytest.mark.parametrize("name", ["shares-sad_happy", "means-masculine_feminine"])
def test_every_chart_can_be_printed(signed_in, answered, name, mode):
    answer = signed_in.get(f"{PAGE}/figures/{name}.svg?mode={mode}")
    assert answer.headers["content-type"].startswith("image/svg+xml")
    drawing = ET.fromstring(answer.text)
    words = "".join(drawing.itertext())
    assert "sad, female" in words
    assert "tired, male" in words


@pytest.mark.parametrize("name", ["shares-mood", "pie-sad_happy", "shares", "x"])
def test_a_chart_that_is_not_there_is_an_error_page(signed_in, answered, name):
    answer = signed_in.get(f"{PAGE}/figures/{name}.svg")
    assert answer.status_code == 404
    assert "no chart" in answer.text


@pytest.mark.parametrize("part", ["", "/counts", "/responses.csv", "/figures/x.svg"])
def test_an_unknown_study_is_an_error_page(signed_in, part):
    answer = signed_in.get(f"/research/studies/nothing{part}")
    assert answer.status_code == 404
    assert "no study" in answer.text
