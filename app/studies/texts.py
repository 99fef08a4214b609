"""Texts and pages that several templates share, in English, Finnish and Japanese."""

from __future__ import annotations

from typing import Any

Text = dict[str, str]
Page = dict[str, Any]

LANGUAGES = ["en", "fi", "ja"]
EXAMPLE = "set_a_neutral"  # an everyday walk of the sample library


def text(en: str, fi: str, ja: str) -> Text:
    """A text in the three languages."""
    return {"en": en, "fi": fi, "ja": ja}


def facts(doing: Text, minutes: int) -> list[Text]:
    """How much there is to do, how long it takes, on what devices."""
    return [
        doing,
        text(f"about {minutes} minutes", f"noin {minutes} minuuttia", f"約{minutes}分"),
        text("any device, no sound", "mikä tahansa laite, ei ääntä", "どの端末でも可、音声なし"),
    ]


def consent() -> Page:
    """What a participant agrees to."""
    return {
        "version": "1",
        "heading": text("Before you begin", "Ennen kuin aloitat", "始める前に"),
        "terms": [
            {
                "term": text("What is kept", "Mitä tallennetaan", "保存されるもの"),
                "text": text(
                    "Your answers and how long they took. No name and no internet address.",
                    "Vastauksesi ja niihin kulunut aika. Ei nimeä eikä verkko-osoitetta.",
                    "回答と、回答にかかった時間です。お名前やIPアドレスは保存しません。",
                ),
            },
            {
                "term": text("How long", "Kuinka kauan", "保存期間"),
                "text": text(
                    "Until the research that they are collected for is finished.",
                    "Kunnes tutkimus, jota varten ne kerätään, on päättynyt.",
                    "この回答を用いる研究が終わるまでです。",
                ),
            },
            {
                "term": text("Your right", "Oikeutesi", "あなたの権利"),
                "text": text(
                    "Stop at any time. A personal link lets you delete your answers later.",
                    "Voit lopettaa milloin tahansa. Henkilökohtaisen linkin kautta voit poistaa "
                    "vastauksesi myöhemmin.",
                    "いつでもやめられます。個人用リンクから、後で回答を削除することもできます。",
                ),
            },
            {
                "term": text("Who asks", "Kuka kysyy", "実施者"),
                "text": text(
                    "The researchers who sent you here.",
                    "Tutkijat, jotka kutsuivat sinut tänne.",
                    "あなたにこの調査を案内した研究者です。",
                ),
            },
        ],
        "statement": text(
            "I am 18 or older, I have read this, and I agree to take part.",
            "Olen vähintään 18-vuotias, olen lukenut tämän ja suostun osallistumaan.",
            "私は18歳以上で、以上の内容を読み、参加に同意します。",
        ),
    }


def about_you() -> Page:
    """A form about the person; nothing in it must be told."""
    return {
        "kind": "form",
        "id": "about_you",
        "heading": text("About you", "Sinusta", "あなたについて"),
        "text": text(
            "Leave out whatever you would rather not say.",
            "Voit jättää vastaamatta siihen, mitä et halua kertoa.",
            "答えたくない項目は空欄のままで構いません。",
        ),
        "fields": [
            {
                "id": "age",
                "label": text("Your age", "Ikäsi", "年齢"),
                "type": "number",
                "required": False,
                "minimum": 18,
                "maximum": 120,
                "unit": text("years", "vuotta", "歳"),
            },
            {
                "id": "gender",
                "label": text("Your gender", "Sukupuolesi", "性別"),
                "type": "choice",
                "required": False,
                "options": [
                    {"id": "woman", "label": text("Woman", "Nainen", "女性")},
                    {"id": "man", "label": text("Man", "Mies", "男性")},
                    {"id": "other", "label": text("Another", "Muu", "その他")},
                ],
            },
            {
                "id": "experience",
                "label": text(
                    "How much do you have to do with animation, dance or acting?",
                    "Kuinka paljon olet tekemisissä animaation, tanssin tai näyttelemisen kanssa?",
                    "アニメーション制作、ダンス、演技などにどのくらい関わっていますか。",
                ),
                "type": "choice",
                "required": False,
                "options": [
                    {"id": "none", "label": text("Nothing", "En lainkaan", "まったくない")},
                    {"id": "hobby", "label": text("As a hobby", "Harrastuksena", "趣味として")},
                    {"id": "work", "label": text("As my work", "Työkseni", "仕事として")},
                ],
            },
        ],
    }


def instructions(words: Text, figures: dict[str, Text]) -> Page:
    """A page to read with figures that move, by the clip's name."""
    return {
        "kind": "instructions",
        "id": "how_it_works",
        "heading": text("How it works", "Näin se toimii", "進め方"),
        "text": words,
        "figures": [{"clip": clip, "caption": caption} for clip, caption in figures.items()],
    }


def last_words() -> Page:
    """A comment on the whole."""
    return {
        "kind": "comment",
        "id": "last_words",
        "question": text(
            "Is there anything you would like to tell us?",
            "Haluaisitko kertoa meille vielä jotakin?",
            "何か伝えたいことはありますか。",
        ),
        "placeholder": text(
            "For example: what was difficult, or what you noticed",
            "Esimerkiksi: mikä oli vaikeaa tai mitä huomasit",
            "例：難しかったこと、気づいたこと",
        ),
    }


def debriefing(words: Text) -> Page:
    """What it was about."""
    return {
        "kind": "debriefing",
        "id": "what_it_was_about",
        "heading": text("What this was about", "Mistä oli kyse", "この調査について"),
        "text": words,
    }


def thanks(*, compared: bool = False) -> Page:
    """The last page, with the number of clips judged; without it where clips were compared."""
    judged = text(
        "You judged {clips} movements. Together with the other answers they show what people "
        "see in a movement.",
        "Arvioit {clips} liikettä. Yhdessä muiden vastausten kanssa ne kertovat, mitä ihmiset "
        "näkevät liikkeessä.",
        "{clips}個の動きを評価していただきました。他の方の回答とあわせて、人が動きから何を感じ取るかが分かります。",
    )
    together = text(
        "Together with the other answers yours show what people see in a movement.",
        "Yhdessä muiden vastausten kanssa sinun vastauksesi kertovat, mitä ihmiset näkevät "
        "liikkeessä.",
        "他の方の回答とあわせて、人が動きから何を感じ取るかが分かります。",
    )
    return {
        "heading": text("Thank you.", "Kiitos.", "ありがとうございました。"),
        "text": together if compared else judged,
    }
