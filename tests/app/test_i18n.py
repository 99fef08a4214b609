"""What participants read: every text in every language, with its places for values intact."""

import ast
import re
from collections import Counter
from datetime import UTC, datetime
from html.parser import HTMLParser

import pytest
from babel import Locale

from app import error_texts, i18n, messages
from app.settings import PROJECT

LANGUAGES = pytest.mark.parametrize("language", i18n.TRANSLATED)
TEMPLATES = sorted(
    path for pattern in messages.TEMPLATES for path in (PROJECT / "templates").glob(pattern)
)
# The sides of a phrase that only researchers see.
FOR_RESEARCHERS = {"To your studies", "To the first page", "Motion library"}
SAID_TO_PARTICIPANTS = (
    "services/sessions.py", "services/session_views.py", "services/answers.py",
    "services/answer_checks.py", "services/studies.py", "services/plans.py",
    "services/allocation.py", "services/admission.py", "services/recruiting.py",
    "routes/participant.py", "routes/sessions_api.py", "security.py",
)  # fmt: skip


def key(message):
    return message.id if isinstance(message.id, str) else message.id[0]


def forms(text):
    return (text,) if isinstance(text, str) else tuple(text or ())


def places(text):
    return Counter(re.findall(r"\{\w+\}", text))


def tags(text):
    return Counter(re.findall(r"</?[a-z][^>]*>", text))


@pytest.fixture(scope="module")
def collected():
    return {key(message): message for message in messages.collect() if message.id}


@LANGUAGES
def test_a_catalog_has_every_message_and_no_other(language, collected):
    catalog = {key(message): message for message in i18n.read_catalog(language) if message.id}
    assert sorted(collected.keys() - catalog.keys()) == [], "run `make messages` and translate"
    assert sorted(catalog.keys() - collected.keys()) == [], "run `make messages`"


@LANGUAGES
def test_every_message_is_translated_in_all_its_forms(language):
    catalog = i18n.read_catalog(language)
    poor = [key(m) for m in catalog if m.id and not (m.string and all(forms(m.string)))]
    unsure = [key(m) for m in catalog if m.id and m.fuzzy]
    short = [key(m) for m in catalog if m.pluralizable and len(m.string) != catalog.num_plurals]
    assert (poor, unsure, short) == ([], [], [])


@LANGUAGES
def test_a_translation_has_the_places_and_the_tags_of_its_message(language):
    for message in i18n.read_catalog(language):
        if not message.id:
            continue
        wanted = forms(message.id)[-1]
        for translated in forms(message.string):
            assert tags(translated) == tags(wanted), translated
            # A form for one alone may say the number in words.
            left = places(wanted) - places(translated)
            assert not places(translated) - places(wanted), translated
            assert not left or (message.pluralizable and set(left) == {"{n}"}), translated


@LANGUAGES
def test_the_scripts_get_their_texts_and_no_others(language, collected):
    texts = i18n.phrases(language).for_scripts["texts"]
    wanted = {
        one for one, message in collected.items()
        if any(path.startswith("static/") for path, _ in message.locations)
    }  # fmt: skip
    assert texts.keys() == wanted
    assert all(all(forms(text)) for text in texts.values())


@pytest.mark.parametrize("language", ["en", *i18n.TRANSLATED])
def test_plurals_follow_the_languages_own_rule(language):
    rule = Locale.parse(language).plural_form
    one = "{n} answer is kept on this device and goes out by itself."
    many = "{n} answers are kept on this device and go out by themselves."
    phrases = i18n.phrases(language)
    by_rule = {}
    for n in range(1, 200):
        text = str(phrases.plural(one, many, n)).replace(phrases.number(n), "{n}")
        by_rule.setdefault(rule(n), set()).add(text)
    assert by_rule.keys() == rule.tags | {"other"}
    assert all(len(texts) == 1 for texts in by_rule.values())
    assert len(set.union(*by_rule.values())) == len(by_rule)


class Visible(HTMLParser):
    """What a reader of the page gets to see or hear, without what Jinja puts in."""

    def __init__(self):
        super().__init__()
        self.found = []

    def handle_data(self, data):
        self.found.append(data)

    def handle_starttag(self, tag, attributes):
        told = ("aria-label", "title", "placeholder", "alt", "content")
        values = dict(attributes)
        if tag == "meta" and values.get("name") != "description":
            return
        self.found += [value or "" for name, value in attributes if name in told]


@pytest.mark.parametrize("path", TEMPLATES, ids=lambda path: path.name)
def test_a_template_says_nothing_that_is_not_translated(path):
    ours = r"\{% block body_class %\}.*?\{% endblock %\}|\{#.*?#\}|\{%.*?%\}|\{\{.*?\}\}"
    plain = re.sub(ours, "", path.read_text("utf-8"), flags=re.S)
    reader = Visible()
    reader.feed(plain)
    words = {" ".join(text.split()).strip("· ") for text in reader.found}
    said = {text for text in words if re.search(r"[^\W\d_]", text)}
    assert said - {"Manner"} - (FOR_RESEARCHERS if path.name == "error.html" else set()) == set()


def raised_codes():
    """The codes of all errors that the modules behind a participant's pages raise."""
    for name in SAID_TO_PARTICIPANTS:
        for node in ast.walk(ast.parse((PROJECT / "app" / name).read_text("utf-8"))):
            if isinstance(node, ast.keyword) and node.arg == "code":
                written = [part.value for part in ast.walk(node.value) if hasattr(part, "value")]
                yield from (one for one in written if re.fullmatch(r"[a-z]+(_[a-z]+)+", str(one)))


def test_every_error_that_a_participant_can_meet_has_its_words():
    codes = set(raised_codes())
    assert {"session_not_found", "already_answered", "consent_changed"} <= codes
    assert codes - error_texts.TEXTS.keys() == set()


def test_an_error_speaks_for_itself_in_english_and_by_its_code_elsewhere():
    message, mend = "3 of 22 clips have no answer yet.", "Answer them."
    assert error_texts.told("answers_missing", message, mend, "en") == (message, mend)
    assert error_texts.told("answers_missing", message, mend, "fi") == (
        "Joitakin vastauksia puuttuu vielä.",
        "Vastaa puuttuviin kohtiin. Antamasi vastaukset säilyvät.",
    )
    unforeseen, _ = error_texts.told("never_heard_of", message, mend, "ja")
    assert unforeseen == "サーバー側で問題が起きました。"


@pytest.mark.parametrize(
    ("asked", "accepted", "language"),
    [
        (None, None, "en"),
        (None, "fi", "fi"),
        (None, "fi-FI,fi;q=0.9,en;q=0.8", "fi"),
        (None, "en;q=0.5, ja-JP", "ja"),
        (None, "de, sv;q=0.9, ja;q=0.1", "ja"),
        (None, "de, *;q=0.5", "en"),
        (None, "fi;q=0, ja;q=0.1", "ja"),
        (None, "fi;q=nonsense, ,;;", "en"),
        ("ja", "fi", "ja"),
        ("de", "fi", "fi"),
    ],
)
def test_a_language_chosen_by_hand_comes_first_then_the_browsers_by_weight(
    asked, accepted, language
):
    assert i18n.best(("en", "fi", "ja"), i18n.wanted(asked, accepted)) == language


def test_a_study_without_the_wanted_language_is_read_in_its_own_first_one():
    assert i18n.best(("ja", "en"), i18n.wanted("fi", "fi, de")) == "ja"


def test_numbers_and_times_are_written_as_the_language_writes_them():
    english, finnish, japanese = map(i18n.phrases, ("en", "fi", "ja"))
    assert [p.number(1234.5) for p in (english, finnish, japanese)] == [
        "1,234.5", "1\xa0234,5", "1,234.5",
    ]  # fmt: skip
    when = datetime(2026, 3, 1, 18, 5, tzinfo=UTC)
    assert "March 1, 2026" in english.moment(when)
    assert "1. maaliskuuta 2026" in finnish.moment(when)
    assert "2026年3月1日" in japanese.moment(when)
    many = finnish.plural("{n} figure to go", "{n} figures to go", 1234)
    assert many == "1\xa0234 hahmoa jäljellä"


def test_values_are_escaped_and_links_of_ours_are_not():
    shown = i18n.phrases("fi").text(
        'Questions: <a href="mailto:{address}">write to the researchers</a>.',
        address='"><script>alert(1)</script>',
    )
    assert "<script>" not in shown
    assert "&lt;script&gt;" in shown
    assert shown.endswith("Kirjoita tutkijoille</a>.")


def test_messages_are_found_within_templates_of_scripts():
    source = """html`<p>${t("One")} ${open ? html`<b>${tn("{n} a", "{n} b", n)}</b>` : t(
      "Two " +
      "lines", { n },
    )}</p>`; element.at(0); split("x"); this.t("not ours");"""
    assert list(messages.in_script(source)) == ["One", ("{n} a", "{n} b"), "Two lines"]


@pytest.mark.parametrize("source", ["t(words)", "t(`hello ${name}`)", 'tn("one", many, n)'])
def test_a_message_that_does_not_stand_there_literally_is_refused(source):
    with pytest.raises(ValueError, match="line 2"):
        list(messages.in_script(f"const x = 1;\n{source};"))
