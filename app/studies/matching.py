"""Which sliders make a walk best: adjectives, motion features or bare blending weights.

Source: Oshita et al., section 6: five targets, each guessed unseen and then matched with every
interface within 300 seconds, three practice targets before.
"""

from __future__ import annotations

from app.studies.template import Document, Template
from app.studies.texts import (
    EXAMPLE,
    LANGUAGES,
    Text,
    about_you,
    consent,
    debriefing,
    facts,
    instructions,
    last_words,
    text,
    thanks,
)

SPACE = "Walks of set B (simulated raters)"
PRIMARY = ("clearness", "activeness", "quickness", "largeness")
# Drawn in that space (seed 7), far from each other and from where the sliders of each kind begin.
TARGETS = (
    (0.059, 0.388, 0.323, 0.150),
    (0.913, 0.802, 0.878, 0.523),
    (0.014, 0.628, 0.793, 0.513),
    (0.520, 0.951, 0.251, 0.806),
    (0.370, 0.004, 0.830, 0.154),
)
PRACTICE = ((0.635, 0.184, 0.062, 0.412), (0.44, 0.24, 0.402, 0.097), (0.307, 0.961, 0.466, 0.628))
# The paper's 0.06 m is for captured walks. Two random blends of these samples lie 0.05 m from each
# other (the median), so that most would match at once.
THRESHOLD = 0.02
MINUTES = 40


def _targets(name: Text, points: tuple[tuple[float, ...], ...], space: str) -> list[Document]:
    return [
        {
            "made": {"space": space, "values": dict(zip(PRIMARY, point, strict=True))},
            "name": f"{name['en']} {number}",
            "label": {language: f"{word} {number}" for language, word in name.items()},
        }
        for number, point in enumerate(points, 1)
    ]


def _matching(space: str = SPACE) -> Document:
    return {
        "manner": 1,
        "slug": "matching-walks",
        "title": "Matching walks",
        "languages": LANGUAGES,
        "welcome": {
            "heading": text("Make a walk", "Tee kävely", "歩き方を作る"),
            "lead": text(
                "A figure walks in a certain way, and you make another one walk like it, with "
                "sliders of three kinds. There is nothing to know beforehand.",
                "Yksi hahmo kävelee tietyllä tavalla, ja sinä saat toisen kävelemään samoin "
                "kolmenlaisilla liukusäätimillä. Ennakkotietoja ei tarvita.",
                "ある歩き方をする人物を見て、3種類のスライダーで、もう一人を同じように歩かせていただきます。"
                "予備知識は必要ありません。",
            ),
            "facts": facts(
                text("39 short tasks", "39 lyhyttä tehtävää", "短い課題39問"),
                MINUTES,
            ),
            "example": EXAMPLE,
        },
        "consent": consent(),
        "parts": [
            about_you(),
            _how_it_works(),
            _targets_to_match(space),
            last_words(),
            debriefing(
                text(
                    "We compare three ways of telling a computer how somebody walks: with words, "
                    "with measures of the movement, and by mixing examples.",
                    "Vertaamme kolmea tapaa kertoa tietokoneelle, miten joku kävelee: sanoin, "
                    "liikkeen mitoin ja esimerkkejä sekoittamalla.",
                    "歩き方をコンピューターに伝える3つの方法、つまり言葉による方法、動きの測定値による方法、"
                    "例を混ぜ合わせる方法を比べる調査です。",
                )
            ),
        ],
        "thanks": thanks(compared=True),
    }


def _how_it_works() -> Document:
    return instructions(
        text(
            "Of each walk you first guess where the sliders belong, without seeing what "
            "they do. Then you see the blue figure move and have five minutes with each "
            "kind of sliders.\n\n"
            "The first three walks are for practice; there you need not guess.",
            "Kunkin kävelyn kohdalla arvaat ensin, mihin säätimet kuuluvat, näkemättä "
            "niiden vaikutusta. Sitten näet sinisen hahmon liikkuvan, ja sinulla on viisi "
            "minuuttia kullakin säädinlajilla.\n\n"
            "Kolme ensimmäistä kävelyä ovat harjoittelua varten; niitä ei tarvitse arvata.",
            "それぞれの歩き方について、まず動きを見ずにスライダーの位置を推測します。その後、"
            "青い人物の動きを見ながら、スライダーの種類ごとに5分以内で合わせます。\n\n"
            "最初の3つは練習で、推測する必要はありません。",
        ),
        {EXAMPLE: text("Drag to look around", "Vedä katsoaksesi ympäri", "ドラッグで回転")},
    )


def _targets_to_match(space: str) -> Document:
    return {
        "kind": "trials",
        "id": "matching",
        "task": {
            "kind": "match",
            "question": text(
                "Make the blue figure walk like the green one.",
                "Saa sininen hahmo kävelemään kuin vihreä.",
                "青い人物を、緑の人物と同じように歩かせてください。",
            ),
            "hint": text(
                "It need not be perfect: the page tells when it is close enough.",
                "Täydellistä ei tarvita: sivu kertoo, milloin ero on tarpeeksi pieni.",
                "完璧でなくて構いません。十分に近づくと、画面でお知らせします。",
            ),
            "space": space,
            "threshold": THRESHOLD,
            "practice_targets": _targets(text("Practice", "Harjoitus", "練習"), PRACTICE, space),
        },
        "stimuli": _targets(text("Target", "Kohde", "目標"), TARGETS, space),
        "break_every": 12,
    }


TEMPLATES = (
    Template(
        "matching",
        "Matching walks",
        "Five targets are made again with adjectives, motion features and blending weights: "
        "guessed unseen first, then within five minutes each.",
        MINUTES,
        "It uses a space whose raters were simulated, and the threshold that its walks need: name "
        "your own space, draw its targets and set the threshold (0.06 m in the paper). Have a "
        "native reader check the Finnish and the Japanese texts; they are ours.",
        _matching,
        {"space": "the authoring space, by its name or id"},
    ),
)
