"""Coming and going by personal links and recruiting services."""

from __future__ import annotations

import pytest

from app.errors import InvalidError
from app.schemas.study import Running
from app.services.recruiting import arrival, given_back, invitation, personal_token

SECRET = "s" * 40
ALL = Running.model_validate(
    {
        "prolific": {"complete": "DONE1", "screened_out": "OUT1"},
        "sona": {"credit_url": "https://lab.sona.example/credit?survey_code={id}&x=1"},
        "mturk": {},
    }
)


def coming(given: dict[str, str], running: Running = ALL):
    return arrival(given, running, "walks", SECRET)


def test_each_service_is_known_by_its_parameters_and_only_where_the_study_uses_it() -> None:
    prolific = {"PROLIFIC_PID": "p1", "STUDY_ID": "s1", "SESSION_ID": "x1", "more": "?"}
    found = coming(prolific)
    assert (found.source, found.identity) == ("prolific", "p1")
    assert found.parameters == {"PROLIFIC_PID": "p1", "STUDY_ID": "s1", "SESSION_ID": "x1"}
    assert (coming({"id": "77"}).source, coming({"id": "77"}).identity) == ("sona", "77")
    mturk = coming({"workerId": "w", "assignmentId": "a", "hitId": "h"})
    assert (mturk.source, mturk.identity, mturk.previewing) == ("mturk", "w", False)
    assert coming({"assignmentId": "ASSIGNMENT_ID_NOT_AVAILABLE", "hitId": "h"}).previewing
    assert coming({"id": "7\x007"}) == coming({"id": "77"})  # no file or database holds NUL
    assert coming({"id": "\x00"}).source == "open"
    for given in (prolific, {"id": "77"}, {"assignmentId": "a", "workerId": "w"}, {}):
        assert coming(given, Running()).source == "open"


def test_a_personal_link_says_for_whom_it_is_and_cannot_be_forged_or_moved() -> None:
    word = invitation(SECRET, "walks", "p 17 ä")
    found = coming({"invite": word})
    assert (found.source, found.identity) == ("personal", "p 17 ä")
    for wrong in (word[:-1], word + "a", "x", invitation("t" * 40, "walks", "p 17 ä")):
        with pytest.raises(InvalidError) as caught:
            coming({"invite": wrong})
        assert caught.value.code == "invitation_invalid"
    with pytest.raises(InvalidError):
        arrival({"invite": word}, ALL, "other", SECRET)


def test_the_same_person_has_the_same_secret_and_no_other_has_it() -> None:
    one = coming({"PROLIFIC_PID": "p1"})
    again = coming({"PROLIFIC_PID": "p1", "SESSION_ID": "another visit"})
    tokens = {
        personal_token(SECRET, slug, who)
        for slug in ("walks", "runs")
        for who in (one, coming({"PROLIFIC_PID": "p2"}), coming({"id": "p1"}))
    }
    assert personal_token(SECRET, "walks", one) == personal_token(SECRET, "walks", again)
    assert len(tokens) == 6
    assert personal_token("t" * 40, "walks", one) not in tokens
    assert personal_token(SECRET, "walks", coming({})) is None


@pytest.mark.parametrize(
    ("outcome", "code", "url"),
    [
        ("complete", "DONE1", "https://app.prolific.com/submissions/complete?cc=DONE1"),
        ("screened_out", "OUT1", "https://app.prolific.com/submissions/complete?cc=OUT1"),
        ("failed_attention", None, None),
    ],
)
def test_prolific_gets_the_code_of_the_outcome(outcome, code, url) -> None:
    back = given_back(ALL, "prolific", outcome, {"PROLIFIC_PID": "p"}, "MNR-1")
    assert (back.code, back.url) == (code, url)


def test_sona_gets_its_own_identity_back_written_safely_and_others_our_code() -> None:
    back = given_back(ALL, "sona", "complete", {"id": "7&y=2"}, "MNR-1")
    assert back.url == "https://lab.sona.example/credit?survey_code=7%26y%3D2&x=1"
    assert given_back(ALL, "sona", "screened_out", {"id": "7"}, "").url is None
    for source in ("mturk", "open", "personal"):
        assert given_back(ALL, source, "complete", {}, "MNR-1").code == "MNR-1"
        assert given_back(ALL, source, "screened_out", {}, "MNR-1").code is None
