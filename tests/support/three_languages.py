"""A small study in three languages, and how tests put it onto a server."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from app.schemas.study import StudyDefinition

SLUG = "three-languages"
HEADINGS = {"en": "How does a walk feel?", "fi": "Miltä kävely tuntuu?", "ja": "歩き方の印象"}
THANKS = {"en": "Thank you very much.", "fi": "Suurkiitos.", "ja": "お疲れさまでした。"}


def _words(en: str, fi: str, ja: str) -> dict[str, str]:
    return {"en": en, "fi": fi, "ja": ja}


def three_languages(clips: Sequence[str], slug: str = SLUG) -> StudyDefinition:
    """A form that may screen out, then the clips (by id) on one scale, each in three languages."""
    option_yes = {"id": "yes", "label": _words("Yes", "Kyllä", "はい")}
    option_no = {"id": "no", "label": _words("No", "En", "いいえ"), "screens_out": True}
    sees = {
        "id": "sees", "label": _words("Do you see it well?", "Näetkö hyvin?", "よく見えますか？"),
        "type": "choice", "options": [option_yes, option_no],
    }  # fmt: skip
    form = {
        "kind": "form", "id": "you", "heading": _words("About you", "Sinusta", "あなたについて"),
        "fields": [sees],
    }  # fmt: skip
    very, rather = _words("very", "hyvin", "とても"), _words("rather", "melko", "やや")
    neither = _words("neither", "ei kumpikaan", "どちらでもない")
    scale = {
        "id": "sad_happy", "left": _words("sad", "surullinen", "悲しい"),
        "right": _words("happy", "iloinen", "うれしい"),
    }  # fmt: skip
    task = {
        "kind": "semantic_differential",
        "question": _words("How does it seem?", "Miltä se näyttää?", "どう見えますか？"),
        "scales": [scale], "steps": [very, rather, neither, rather, very],
    }  # fmt: skip
    stimuli = [
        {"clip": clip, "name": f"clip_{i}", "label": f"clip {i}", "body": "b", "style": "s"}
        for i, clip in enumerate(clips)
    ]
    facts = [
        _words("few clips", "muutama liike", "短い動き"),
        _words("two minutes", "kaksi minuuttia", "約2分"),
        _words("any device", "mikä tahansa laite", "どの端末でも"),
    ]
    kept = {
        "term": _words("What is kept", "Mitä tallennetaan", "保存されるもの"),
        "text": _words("Your answers.", "Vastauksesi.", "あなたの回答です。"),
    }
    document: dict[str, Any] = {
        "slug": slug, "title": HEADINGS["en"], "languages": ["en", "fi", "ja"],
        "welcome": {
            "heading": HEADINGS, "lead": _words("Look and say.", "Katso ja kerro.", "見て答える。"),
            "facts": facts,
        },
        "consent": {
            "version": "1", "heading": _words("Before", "Ensin", "始める前に"), "terms": [kept],
            "statement": _words("I agree.", "Suostun.", "同意します。"),
        },
        "parts": [form, {"kind": "trials", "id": "walks", "task": task, "stimuli": stimuli}],
        "thanks": {"heading": THANKS, "text": _words("{clips} done.", "{clips} on.", "{clips}")},
        "contact": "walks@example.org",
    }  # fmt: skip
    return StudyDefinition.model_validate(document)
