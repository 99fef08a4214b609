"""Oshita's questionnaire: 41 pairs of adjectives for a green walk beside a red everyday one.

Source: M. Oshita et al., Generating various styles of walking by motion interpolation with
adjectives: 41 pairs, five steps, motion sets A (10 walks) and B (9 emotions at 3 speeds). The paper
prints the English words only; the Finnish and Japanese ones are ours.
"""

from __future__ import annotations

from typing import Any

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

REFERENCE = EXAMPLE
SET_A = tuple(
    f"set_a_{style}"
    for style in (
        "neutral", "energetic", "proud", "sad", "angry",
        "old", "timid", "tired", "childlike", "swaggering",
    )
)  # fmt: skip
SET_B = tuple(
    f"set_b_{emotion}_{speed}"
    for emotion in (
        "excitement", "pleasure", "contentment", "sleepiness", "depression",
        "misery", "distress", "arousal", "neutral",
    )
    for speed in ("fast", "normal", "slow")
)  # fmt: skip

# English, Finnish and Japanese, left and right pole, in the paper's order.
PAIRS = (
    ("slow", "fast", "hidas", "nopea", "遅い", "速い"),
    ("mild", "violent", "lempeä", "raju", "穏やかな", "激しい"),
    ("hard", "soft", "kova", "pehmeä", "硬い", "柔らかい"),
    ("dull", "quick", "vitkainen", "ripeä", "のろい", "素早い"),
    ("quiet", "noisy", "hiljainen", "meluisa", "静かな", "騒がしい"),
    ("angular", "circular", "kulmikas", "kaareva", "角張った", "丸みのある"),
    ("blunt", "sharp", "tylppä", "terävä", "鈍い", "鋭い"),
    ("dormant", "brisk", "uinuva", "vireä", "不活発な", "活発な"),
    ("edgy", "round", "särmikäs", "pyöreä", "とがった", "丸い"),
    ("weak", "strong", "heikko", "vahva", "弱い", "強い"),
    ("unpleasant", "pleasant", "epämiellyttävä", "miellyttävä", "不快な", "快い"),
    ("inelastic", "elastic", "joustamaton", "joustava", "弾力のない", "弾力のある"),
    ("dirty", "clean", "likainen", "puhdas", "汚い", "きれいな"),
    ("sad", "happy", "surullinen", "iloinen", "悲しい", "嬉しい"),
    ("bumpy", "smooth", "töksähtelevä", "sulava", "ぎくしゃくした", "滑らかな"),
    ("uncool", "cool", "tyylitön", "tyylikäs", "かっこ悪い", "かっこいい"),
    ("dark", "bright", "pimeä", "valoisa", "暗い", "明るい"),
    ("thin", "thick", "ohut", "paksu", "細い", "太い"),
    ("ugly", "cute", "ruma", "söpö", "醜い", "かわいい"),
    ("simple", "gaudy", "koruton", "räikeä", "地味な", "派手な"),
    ("coarse", "fine", "karkea", "hieno", "粗い", "細やかな"),
    ("old", "young", "vanha", "nuori", "年老いた", "若い"),
    ("heavy", "light", "raskas", "kevyt", "重い", "軽い"),
    ("strained", "relaxed", "jännittynyt", "rento", "緊張した", "くつろいだ"),
    ("unstable", "stable", "epävakaa", "vakaa", "不安定な", "安定した"),
    ("small", "large", "pieni", "suuri", "小さい", "大きい"),
    ("unafraid", "afraid", "peloton", "pelokas", "怖がっていない", "怖がっている"),
    ("artificial", "natural", "keinotekoinen", "luonnollinen", "人工的な", "自然な"),
    ("closed", "open", "sulkeutunut", "avoin", "閉じた", "開いた"),
    ("adult", "childish", "aikuismainen", "lapsellinen", "大人っぽい", "子どもっぽい"),
    ("vague", "distinct", "epämääräinen", "selväpiirteinen", "曖昧な", "はっきりした"),
    ("narrow", "broad", "kapea", "leveä", "狭い", "広い"),
    ("ugly", "beautiful", "ruma", "kaunis", "醜い", "美しい"),
    ("poor", "rich", "köyhä", "rikas", "貧しい", "豊かな"),
    ("tight", "free", "kireä", "vapaa", "窮屈な", "自由な"),
    ("dim", "sharp", "himmeä", "tarkka", "ぼんやりした", "くっきりした"),
    ("drab", "clear", "harmaa", "kirkas", "くすんだ", "澄んだ"),
    ("gloomy", "cheerful", "synkkä", "hilpeä", "陰気な", "陽気な"),
    ("lonely", "bustling", "yksinäinen", "vilkas", "寂しい", "にぎやかな"),
    ("calm", "excited", "rauhallinen", "kiihtynyt", "落ち着いた", "興奮した"),
    ("narrow", "wide", "ahdas", "avara", "幅の狭い", "幅の広い"),
)

# The four primary parameters, as the paper calls its clusters of pairs, with words for their ends.
PRIMARY = {
    "quickness": ("slow", "quick", "hidas", "ripeä", "遅い", "素早い"),
    "clearness": ("vague", "clear", "epämääräinen", "selkeä", "曖昧な", "明瞭な"),
    "activeness": ("inactive", "active", "passiivinen", "aktiivinen", "消極的な", "積極的な"),
    "largeness": ("small", "large", "pieni", "suuri", "小さい", "大きい"),
}

STEPS = [
    text("very", "hyvin", "とても"),
    text("rather", "melko", "やや"),
    text("as red", "sama", "同じ"),
    text("rather", "melko", "やや"),
    text("very", "hyvin", "とても"),
]


def _scale(name: str, words: tuple[str, str, str, str, str, str]) -> dict[str, Any]:
    left, right, left_fi, right_fi, left_ja, right_ja = words
    return {
        "id": name,
        "left": text(left, left_fi, left_ja),
        "right": text(right, right_fi, right_ja),
    }


SCALES = [_scale(f"{words[0]}_{words[1]}", words) for words in PAIRS]
PRIMARY_SCALES = [_scale(name, words) for name, words in PRIMARY.items()]


def _study(
    slug: str, title: str, minutes: int, clips: tuple[str, ...], scales: list[Document]
) -> Document:
    trials = _trials(clips, scales)
    pairs, number = len(scales), len(clips) + len(trials["checks"])
    return {
        "manner": 1,
        "slug": slug,
        "title": title,
        "languages": LANGUAGES,
        "welcome": {
            "heading": text(
                "What is this walk like?",
                "Millainen tämä kävely on?",
                "この歩き方はどんな感じですか。",
            ),
            "lead": text(
                "You will see a green figure walk beside a red one and say how the green walk "
                "differs. There are no right answers; your first impression is the one we need.",
                "Näet vihreän hahmon kävelevän punaisen vierellä ja kerrot, miten vihreä kävely "
                "eroaa. Oikeita vastauksia ei ole; tarvitsemme ensivaikutelmasi.",
                "赤い人物の隣を歩く緑の人物を見て、緑の歩き方がどう違うかを答えていただきます。"
                "正解はありません。第一印象で答えてください。",
            ),
            "facts": facts(
                text(
                    f"{number} walks, {pairs} pairs of words each",
                    f"{number} kävelyä, kussakin {pairs} sanaparia",
                    f"歩き方{number}種類、それぞれ{pairs}組の言葉",
                ),
                minutes,
            ),
            "example": EXAMPLE,
        },
        "consent": consent(),
        "parts": [
            about_you(),
            _how_it_works(),
            _trials(clips, scales),
            last_words(),
            _debriefing(),
        ],
        "back": True,
        "thanks": thanks(),
    }


def _how_it_works() -> Document:
    return instructions(
        text(
            "The red figure always walks the same everyday walk. Beside it a green figure walks "
            "in another way each time. Drag to look at both from any side.\n\n"
            "Between each two words choose the point that fits the green walk. The middle means "
            "that it is like the red one. Some words will seem odd for a walk: choose what comes "
            "to mind first.",
            "Punainen hahmo kävelee aina samaa arkista kävelyä. Sen vierellä vihreä hahmo "
            "kävelee joka kerta eri tavalla. Vetämällä voit katsoa molempia eri suunnista.\n\n"
            "Valitse kunkin kahden sanan väliltä kohta, joka sopii vihreään kävelyyn. Keskikohta "
            "tarkoittaa, että se on kuin punainen. Jotkin sanat voivat tuntua kävelylle oudoilta: "
            "valitse se, mikä tulee ensimmäisenä mieleen.",
            "赤い人物は、いつも同じ普段の歩き方をします。その隣で緑の人物が、毎回違う歩き方をします。"
            "ドラッグすると、いろいろな方向から見られます。\n\n"
            "二つの言葉の間で、緑の歩き方に合う位置を選んでください。中央は「赤と同じ」という意味です。"
            "歩き方には合わないように思える言葉もありますが、最初に思い浮かんだものを選んでください。",
        ),
        {REFERENCE: text("The red figure's walk", "Punaisen hahmon kävely", "赤い人物の歩き方")},
    )


def _trials(clips: tuple[str, ...], scales: list[Document]) -> Document:
    is_long = len(scales) > 20
    part: Document = {
        "kind": "trials",
        "id": "adjectives",
        "task": {
            "kind": "semantic_differential",
            "question": text("The green walk is …", "Vihreä kävely on …", "緑の歩き方は…"),
            "scales": scales,
            "steps": STEPS,
            "preselected": False,
            "reference": REFERENCE,
        },
        "stimuli": list(clips),
        "order": "shuffle",
        "checks": [] if is_long else [_instructed()],
    }
    return {**part, "break_every": 5} if is_long else part


def _instructed() -> Document:
    return {
        "kind": "instructed",
        "id": "reading",
        "text": text(
            "This one checks that you are reading: choose “very slow” and “very large”, and "
            "anything for the rest.",
            "Tällä tarkistetaan, että luet ohjeet: valitse ”hyvin hidas” ja ”hyvin suuri”, muihin "
            "mitä tahansa.",
            "これは説明を読んでいるかの確認です。「とても遅い」と「とても大きい」を選び、"
            "残りは何でも構いません。",
        ),
        "answers": {"quickness": -2, "largeness": 2},
    }


def _debriefing() -> Document:
    words: Text = text(
        "Which words belong together when people speak of walks? From many answers like yours we "
        "learn the few qualities that lie behind them, such as quickness or largeness. With them "
        "a walk can be made by words. The figures were animated by a program.",
        "Mitkä sanat kuuluvat yhteen, kun ihmiset puhuvat kävelystä? Monista vastauksista opimme "
        "ne harvat ominaisuudet, jotka ovat sanojen takana, kuten ripeys ja suuruus. Niiden "
        "avulla kävely voidaan tehdä sanoilla. Hahmot animoi tietokoneohjelma.",
        "歩き方を言い表すとき、どの言葉とどの言葉がまとまるのでしょうか。多くの方の回答から、"
        "素早さや大きさなど、言葉の背後にある少数の性質を調べます。それを使うと、言葉から歩き方を"
        "作ることができます。人物の動きはプログラムで作られたものです。",
    )
    return debriefing(words)


_NOTES = (
    "The Finnish and Japanese adjectives are ours: have a native reader check them before anybody "
    "is asked. The paper prints the English ones only."
)

TEMPLATES = (
    Template(
        "adjectives-a",
        "Adjectives for ten walks (set A)",
        "Oshita's questionnaire: each of 10 walks beside a red everyday walk, on 41 pairs of "
        "adjectives in five steps.",
        30,
        _NOTES,
        lambda: _study("adjectives-set-a", "Adjectives for walks, set A", 30, SET_A, SCALES),
    ),
    Template(
        "adjectives-b",
        "Adjectives for 27 walks (set B)",
        "The same 41 pairs of adjectives for 9 emotions, each walked fast, normally and slowly.",
        75,
        _NOTES,
        lambda: _study("adjectives-set-b", "Adjectives for walks, set B", 75, SET_B, SCALES),
    ),
    Template(
        "adjectives-short",
        "Four qualities of ten walks",
        "The short form: quickness, clearness, activeness and largeness alone, for the 10 walks "
        "of set A.",
        7,
        _NOTES,
        lambda: _study(
            "four-qualities-of-walks", "Four qualities of walks", 7, SET_A, PRIMARY_SCALES
        ),
    ),
)
