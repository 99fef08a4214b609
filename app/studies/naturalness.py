"""Which movement looks natural: the best of ten levels, pairs, several rated on one page.

Sources: B. Bodenheimer et al. on noise in running: choose the most natural of ten levels, and the
comparison in pairs that they propose; rating side by side as in HEMVIP.
"""

from __future__ import annotations

from math import isfinite

from app.errors import InvalidError
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

SOURCE = "set_a_neutral"
LEVELS = 10
PAIR_LEVELS = ("0.2", "0.6", "1", "1.4", "1.8")
RATED = ("excitement", "pleasure", "contentment", "depression", "distress", "neutral")
SPEEDS = ("slow", "normal", "fast")


def levels(
    source: str = SOURCE,
    operation: str = "path_length@1",
    parameter: str = "gain",
    first: str = "0.2",
    last: str = "2",
) -> list[Document]:
    """Ten stimuli that differ in one parameter of a recipe, in even steps.

    Args:
        source: the clip that all are made from.
        operation: such as `path_length@1`.
        parameter: a number among the operation's.
        first: the parameter's lowest value.
        last: the highest one.

    Raises:
        InvalidError: first or last is no number.
    """
    low, high = _number("from", first), _number("to", last)
    values = [round(low + (high - low) * step / (LEVELS - 1), 6) for step in range(LEVELS)]
    return [_level(source, operation, parameter, value) for value in values]


def _level(source: str, operation: str, parameter: str, value: float) -> Document:
    steps = [{"operation": operation, "parameters": {parameter: value}}]
    name = f"{parameter} {value:g}"
    return {"made": {"source": source, "operations": steps}, "name": name, "style": name}


def _number(name: str, given: str) -> float:
    try:
        value = float(given)
    except ValueError:
        value = float("nan")
    if not isfinite(value):
        raise InvalidError(f"“{given}” is no number.", where={"option": name}, mend="Write 0.5.")
    return value


def _choose(**options: str) -> Document:
    names = {"from": "first", "to": "last"}
    stimuli = levels(**{names.get(name, name): value for name, value in options.items()})
    part: Document = {
        "kind": "trials",
        "id": "most_natural",
        "task": {
            "kind": "choose",
            "question": text(
                "Which of these walks looks the most natural?",
                "Mikä näistä kävelyistä näyttää luonnollisimmalta?",
                "最も自然に見える歩き方はどれですか。",
            ),
            "hint": text(
                "All ten walk in step. Turn one and all turn. Look as often as you like.",
                "Kaikki kymmenen kävelevät samassa tahdissa. Kun käännät yhtä, kaikki kääntyvät. "
                "Katso niin monta kertaa kuin haluat.",
                "10人は同じタイミングで歩きます。一人を回すと全員が回ります。何度見ても構いません。",
            ),
        },
        "stimuli": stimuli,
    }
    return _study(
        "most-natural-of-ten",
        "The most natural of ten",
        text("ten walks side by side", "kymmenen kävelyä rinnakkain", "並んだ10の歩き方"),
        3,
        part,
        _MADE,
    )


def _pairs() -> Document:
    stimuli = [_level(SOURCE, "path_length@1", "gain", float(level)) for level in PAIR_LEVELS]
    part: Document = {
        "kind": "trials",
        "id": "more_natural",
        "task": {
            "kind": "ab",
            "question": text(
                "Which of the two walks looks more natural?",
                "Kumpi kävelyistä näyttää luonnollisemmalta?",
                "どちらの歩き方がより自然に見えますか。",
            ),
            "hint": text(
                "If you see no difference, say so.",
                "Jos et näe eroa, kerro se.",
                "違いが分からなければ、そう答えてください。",
            ),
            "allow_same": True,
        },
        "stimuli": stimuli,
        "checks": [{"kind": "repeated", "id": "again", "count": 1, "within": 0}],
    }
    return _study(
        "more-natural-of-two",
        "The more natural of two",
        text("11 pairs of walks", "11 kävelyparia", "歩き方の組み合わせ11組"),
        4,
        part,
        _MADE,
    )


def _parallel() -> Document:
    part: Document = {
        "kind": "trials",
        "id": "pleasantness",
        "task": {
            "kind": "parallel",
            "question": text(
                "How pleasant is each walk to look at?",
                "Kuinka miellyttävä kutakin kävelyä on katsoa?",
                "それぞれの歩き方は、見ていてどのくらい快いですか。",
            ),
            "hint": text(
                "Compare them with each other; ties are fine.",
                "Vertaa niitä toisiinsa; ne voivat myös olla tasoissa.",
                "互いに比べて評価してください。同じ評価でも構いません。",
            ),
            "low": text("unpleasant", "epämiellyttävä", "不快"),
            "high": text("pleasant", "miellyttävä", "快い"),
        },
        "stimuli": [f"set_b_{emotion}_{speed}" for speed in SPEEDS for emotion in RATED],
        "sets": [[f"set_b_{emotion}_{speed}" for emotion in RATED] for speed in SPEEDS],
    }
    return _study(
        "walks-side-by-side",
        "Walks rated side by side",
        text("3 pages of 6 walks", "3 sivua, kullakin 6 kävelyä", "6つの歩き方を3ページ分"),
        6,
        part,
        text(
            "When several movements stand side by side, people judge finer and faster than one "
            "after the other. The figures were animated by a program; some walks are meant to "
            "look excited, others sad or calm.",
            "Kun useita liikkeitä on rinnakkain, ihmiset arvioivat tarkemmin ja nopeammin kuin "
            "yksi kerrallaan. Hahmot animoi tietokoneohjelma; jotkin kävelyt on tehty näyttämään "
            "innostuneilta, toiset surullisilta tai rauhallisilta.",
            "複数の動きを並べると、一つずつ見るよりも細かく、早く評価できます。人物の動きはプログラムで"
            "作られたもので、興奮した歩き方、悲しい歩き方、落ち着いた歩き方などがあります。",
        ),
    )


_MADE = text(
    "The walks were one walk, changed by a program more or less. Your choice tells how far a "
    "movement can be changed before it looks made.",
    "Kävelyt olivat yksi ja sama kävely, jota ohjelma muutti enemmän tai vähemmän. Valintasi "
    "kertoo, kuinka paljon liikettä voi muuttaa ennen kuin se näyttää tehdyltä.",
    "どれも同じ一つの歩き方を、プログラムで程度を変えて加工したものです。あなたの回答から、動きをどこまで"
    "変えると不自然に見えるかが分かります。",
)


def _study(
    slug: str, title: str, doing: Text, minutes: int, part: Document, about: Text
) -> Document:
    return {
        "manner": 1,
        "slug": slug,
        "title": title,
        "languages": LANGUAGES,
        "welcome": {
            "heading": text(
                "How does a person walk?", "Miten ihminen kävelee?", "人はどのように歩くでしょう。"
            ),
            "lead": text(
                "You will see figures walk side by side and say how they look to you. There are "
                "no right answers; trust your eyes.",
                "Näet hahmojen kävelevän rinnakkain ja kerrot, miltä ne sinusta näyttävät. "
                "Oikeita vastauksia ei ole; luota silmiisi.",
                "並んで歩く人物を見て、どう見えるかを答えていただきます。正解はありません。"
                "見たままを答えてください。",
            ),
            "facts": facts(doing, minutes),
            "example": EXAMPLE,
        },
        "consent": consent(),
        "parts": [about_you(), _how_it_works(), part, last_words(), debriefing(about)],
        "thanks": thanks(compared=True),
    }


def _how_it_works() -> Document:
    return instructions(
        text(
            "The figures move by themselves, over and over. Drag on one to look at it from "
            "another side; all turn together.\n\n"
            "Take your time, but not too much: the first impression counts.",
            "Hahmot liikkuvat itsestään yhä uudelleen. Vedä yhtä katsoaksesi sitä toisesta "
            "suunnasta; kaikki kääntyvät yhdessä.\n\n"
            "Katso rauhassa, mutta älä liian kauan: ensivaikutelma ratkaisee.",
            "人物は自動で繰り返し動きます。一人をドラッグすると別の方向から見られ、全員が一緒に回ります。\n\n"
            "ゆっくり見て構いませんが、考えすぎず、第一印象で答えてください。",
        ),
        {EXAMPLE: text("Drag to look around", "Vedä katsoaksesi ympäri", "ドラッグで回転")},
    )


_NOTES = "Have a native reader check the Finnish and the Japanese texts; they are ours."

TEMPLATES = (
    Template(
        "most-natural",
        "The most natural of ten",
        "One change in ten strengths, all ten in step on one page; one is chosen. Here the motion "
        "paths are longer and shorter.",
        3,
        _NOTES,
        _choose,
        {
            "source": "the clip that all ten are made from",
            "operation": "the recipe's operation, such as path_length@1",
            "parameter": "the parameter that differs",
            "from": "its lowest value",
            "to": "its highest value",
        },
    ),
    Template(
        "more-natural",
        "The more natural of two",
        "Five levels of longer and shorter motion paths, every two beside each other; no "
        "difference can be chosen.",
        4,
        _NOTES,
        _pairs,
    ),
    Template(
        "side-by-side",
        "Walks rated side by side",
        "Six walks on a page, a slider below each; three pages.",
        6,
        _NOTES,
        _parallel,
    ),
)
