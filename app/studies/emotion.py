"""Förger's questionnaire on the emotional content of motion: the demonstration and the template.

Source: K. Förger's master's thesis on the emotional content of captured motion, chapter 4.3 and
figure 29. The thesis prints the English words only; the Finnish and Japanese ones are ours.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from app.schemas.study import Stimulus, StudyDefinition
from app.studies.template import Document, Template
from app.studies.texts import (
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

SLUG = "emotion-in-walking"
SAMPLE_SET = "acted"
EXAMPLE_SET = "A"
THANKS_SET = "gesture"
PRACTICE = 2

BODIES = ("female", "male")
ACTED = (
    "afraid", "angry", "excited", "happy", "neutral",
    "relaxed", "sad", "strong", "tired", "weak",
)  # fmt: skip
# The presets by which clips were modified, each from the neutral one of its body.
MODIFIED = {
    "female": (
        "afraid", "angry", "excited", "masculine", "relaxed",
        "sad", "strong", "tired", "weak", "feminine",
    ),
    "male": (
        "afraid", "angry", "energetic_sadness", "excited", "feminine",
        "relaxed", "sad", "strong", "tired", "weak",
    ),
}  # fmt: skip


def _scale(left: tuple[Text, Text], right: tuple[Text, Text]) -> Document:
    return {
        "id": f"{left[0]['en']}_{right[0]['en']}",
        "left": left[0],
        "right": right[0],
        "left_more": left[1],
        "right_more": right[1],
    }


# Each pole with its comparative.
SCALES = [
    _scale(
        (text("sad", "surullinen", "悲しい"), text("sadder", "surullisempi", "より悲しい")),
        (text("happy", "iloinen", "嬉しい"), text("happier", "iloisempi", "より嬉しい")),
    ),
    _scale(
        (text("tired", "väsynyt", "疲れた"), text("more tired", "väsyneempi", "より疲れた")),
        (
            text("excited", "innostunut", "興奮した"),
            text("more excited", "innostuneempi", "より興奮した"),
        ),
    ),
    _scale(
        (text("angry", "vihainen", "怒った"), text("angrier", "vihaisempi", "より怒った")),
        (
            text("relaxed", "rento", "くつろいだ"),
            text("more relaxed", "rennompi", "よりくつろいだ"),
        ),
    ),
    _scale(
        (text("weak", "heikko", "弱い"), text("weaker", "heikompi", "より弱い")),
        (text("strong", "vahva", "強い"), text("stronger", "vahvempi", "より強い")),
    ),
    _scale(
        (
            text("afraid", "pelokas", "怖がっている"),
            text("more afraid", "pelokkaampi", "より怖がっている"),
        ),
        (
            text("confident", "itsevarma", "自信のある"),
            text("more confident", "itsevarmempi", "より自信のある"),
        ),
    ),
    _scale(
        (
            text("masculine", "miehekäs", "男性的な"),
            text("more masculine", "miehekkäämpi", "より男性的な"),
        ),
        (
            text("feminine", "naisellinen", "女性的な"),
            text("more feminine", "naisellisempi", "より女性的な"),
        ),
    ),
]

TASK: Document = {
    "kind": "semantic_differential",
    "question": text(
        "How does this person seem to you?",
        "Millaiselta tämä ihminen sinusta vaikuttaa?",
        "この人はどのように見えますか。",
    ),
    "hint": text(
        "Choose the nearest. The middle means neither, or not sure.",
        "Valitse lähin. Keskikohta tarkoittaa: ei kumpikaan, tai en ole varma.",
        "最も近いものを選んでください。中央は「どちらでもない」または「分からない」です。",
    ),
    "scales": SCALES,
    "steps": [
        text("very", "hyvin", "とても"),
        text("rather", "melko", "やや"),
        text("neither", "ei kumpikaan", "どちらでもない"),
        text("rather", "melko", "やや"),
        text("very", "hyvin", "とても"),
    ],
    "comment": {
        "label": text(
            "Anything else you noticed?", "Huomasitko jotakin muuta?", "他に気づいたことは？"
        ),
        "placeholder": text(
            "For example: seems to be looking for something",
            "Esimerkiksi: näyttää etsivän jotakin",
            "例：何かを探しているように見える",
        ),
    },
}


def demonstration(stimuli: Iterable[Stimulus], example: str | None = None) -> StudyDefinition:
    """The study on the given clips, which every participant sees all of.

    Args:
        stimuli: the clips to judge.
        example: content hash of the clip that moves on the welcome page.
    """
    clips = [stimulus.model_dump(mode="json") for stimulus in stimuli]
    agreed = consent()
    agreed["terms"][1]["text"] = text(
        "Until whoever runs this server deletes the demonstration.",
        "Kunnes palvelimen ylläpitäjä poistaa tämän esittelyn.",
        "このサーバーの管理者がこのデモを削除するまでです。",
    )
    agreed["terms"][3]["text"] = text(
        "Whoever runs this server. It is a demonstration, not a registered study.",
        "Palvelimen ylläpitäjä. Tämä on esittely eikä rekisteröity tutkimus.",
        "このサーバーの管理者です。登録された調査ではなく、デモです。",
    )
    return StudyDefinition.model_validate(
        {
            "slug": SLUG,
            "title": "Emotion in walking",
            "languages": LANGUAGES,
            "welcome": _welcome(PRACTICE + len(clips), 10, example),
            "consent": agreed,
            "parts": [_trials(clips, min(PRACTICE, len(clips)))],
            "thanks": thanks(),
        }
    )


def _forger() -> Document:
    clips = [*_acted(), *_modified()]
    part = _trials(clips, PRACTICE)
    part["checks"] = [_reading()]
    part["break_every"] = 21
    to_see = PRACTICE + len(clips) + len(part["checks"])
    return {
        "manner": 1,
        "slug": "emotion-acted-and-modified",
        "title": "Emotion in walking, acted and modified",
        "languages": LANGUAGES,
        "welcome": _welcome(to_see, 19, "set_a_neutral"),
        "consent": consent(),
        "parts": [about_you(), _how_it_works(), part, last_words(), _debriefing()],
        "thanks": thanks(),
    }


def _trials(clips: list[Any], practice: int) -> Document:
    return {
        "kind": "trials",
        "id": "emotions",
        "task": TASK,
        "practice": practice,
        "stimuli": clips,
    }


def _acted() -> list[str]:
    return [f"acted_{body}_{emotion}" for body in BODIES for emotion in ACTED]


def _modified() -> list[Document]:
    return [
        {"made": {"source": f"acted_{body}_neutral", "preset": preset}}
        for body in BODIES
        for preset in MODIFIED[body]
    ]


def _welcome(clips: int, minutes: int, example: str | None) -> Document:
    return {
        "heading": text(
            "How does a movement feel?", "Miltä liike tuntuu?", "動きは、どんな感じがしますか。"
        ),
        "lead": text(
            "You will watch short clips of a moving figure and say what you see in it. There are "
            "no right answers; your first impression is the one we need.",
            "Katsot lyhyitä pätkiä liikkuvasta hahmosta ja kerrot, mitä näet siinä. Oikeita "
            "vastauksia ei ole; tarvitsemme ensivaikutelmasi.",
            "動く人物の短い映像を見て、どう見えるかを答えていただきます。正解はありません。"
            "第一印象で答えてください。",
        ),
        "facts": facts(
            text(f"{clips} short clips", f"{clips} lyhyttä pätkää", f"短い映像{clips}本"), minutes
        ),
        "example": example,
    }


def _how_it_works() -> Document:
    return instructions(
        text(
            "You see a figure walk up to a door and knock. It begins again by itself, and you can "
            "drag to look at it from any side. Seeing it once is usually enough.\n\n"
            "Between each two words choose what describes the person. The nearest choice means "
            "that the word describes the person very well. The middle means neither, or that you "
            "are not sure.",
            "Näet hahmon kävelevän oven luo ja koputtavan. Liike alkaa itsestään uudelleen, ja "
            "vetämällä voit katsoa sitä eri suunnista. Yleensä yksi katselukerta riittää.\n\n"
            "Valitse kunkin kahden sanan väliltä se, mikä kuvaa ihmistä. Lähin vaihtoehto "
            "tarkoittaa, että sana kuvaa ihmistä hyvin. Keskikohta tarkoittaa, ettei kumpikaan "
            "sovi tai ettet ole varma.",
            "人物がドアまで歩き、ノックします。動きは自動で繰り返され、ドラッグするといろいろな方向から"
            "見られます。たいていは一度見れば十分です。\n\n"
            "二つの言葉の間で、その人に合う位置を選んでください。言葉に最も近い位置は、その言葉がとても"
            "よく当てはまるという意味です。中央は、どちらでもない、または分からないという意味です。",
        ),
        {
            "set_a_energetic": text("One walk", "Yksi kävely", "ある歩き方"),
            "set_a_tired": text("Another walk", "Toinen kävely", "別の歩き方"),
        },
    )


def _reading() -> Document:
    return {
        "kind": "instructed",
        "id": "reading",
        "text": text(
            "This one checks that you are reading: whatever you see, choose “very sad” and “very "
            "strong”.",
            "Tällä tarkistetaan, että luet ohjeet: valitse ”hyvin surullinen” ja ”hyvin vahva” "
            "riippumatta siitä, mitä näet.",
            "これは説明を読んでいるかの確認です。何が見えても「とても悲しい」と「とても強い」を"
            "選んでください。",
        ),
        "answers": {"sad_happy": -2, "weak_strong": 2},
    }


def _debriefing() -> Document:
    return debriefing(
        text(
            "Half of the movements were animated as a whole for an emotion. The other half was "
            "one plain movement, changed by a program: longer or shorter paths of the limbs, "
            "another rhythm, another posture. Your answers show whether such changes can carry "
            "an emotion. The figures stand for no real person.",
            "Puolet liikkeistä animoitiin kokonaan tiettyä tunnetta varten. Toinen puoli oli yksi "
            "tavallinen liike, jota ohjelma muutti: raajojen pidemmät tai lyhyemmät liikeradat, "
            "toinen rytmi, toinen asento. Vastauksesi kertovat, voivatko tällaiset muutokset "
            "välittää tunteen. Hahmot eivät esitä ketään todellista ihmistä.",
            "半分の動きは、それぞれの感情に合わせて全体を作ったものです。残りの半分は、一つの普通の動きを"
            "プログラムで変えたもので、手足の動く道のりの長さ、リズム、姿勢が違います。あなたの回答から、"
            "そのような変化で感情が伝わるかどうかが分かります。実在の人物の動きではありません。",
        )
    )


TEMPLATES = (
    Template(
        "emotion",
        "Emotion in walking, acted and modified",
        "Förger's questionnaire with all 40 clips: 20 acted and 20 modified from a neutral one, "
        "on six axes in five steps.",
        19,
        "The Finnish and Japanese adjectives are ours: have a native reader check them before "
        "anybody is asked. The 20 modified clips are made when the study is published.",
        _forger,
    ),
)
