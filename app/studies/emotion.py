"""The demonstration study: Förger's questionnaire on the emotional content of walks.

Source: K. Förger's master's thesis on the emotional content of captured motion, chapter 4.3.
"""

from collections.abc import Iterable
from typing import Any

from app.schemas.study import Stimulus, StudyDefinition

SLUG = "emotion-in-walking"
SAMPLE_SET = "acted"
EXAMPLE_SET = "A"
THANKS_SET = "gesture"
PRACTICE = 2

# Each axis with its poles' comparatives.
POLES = (
    ("sad", "happy", "sadder", "happier"),
    ("tired", "excited", "more tired", "more excited"),
    ("angry", "relaxed", "angrier", "more relaxed"),
    ("weak", "strong", "weaker", "stronger"),
    ("afraid", "confident", "more afraid", "more confident"),
    ("masculine", "feminine", "more masculine", "more feminine"),
)
SCALES = [
    {
        "id": f"{left}_{right}", "left": left, "right": right,
        "left_more": left_more, "right_more": right_more,
    }
    for left, right, left_more, right_more in POLES
]  # fmt: skip

CONSENT = {
    "version": "1",
    "heading": "Before you begin",
    "terms": [
        {
            "term": "What is kept",
            "text": "Your answers and how long they took. No name and no internet address.",
        },
        {
            "term": "How long",
            "text": "Until whoever runs this server deletes the demonstration.",
        },
        {
            "term": "Your right",
            "text": "Stop at any time. A personal link lets you delete your answers later.",
        },
        {
            "term": "Who asks",
            "text": "Whoever runs this server. It is a demonstration, not a registered study.",
        },
    ],
    "statement": "I am 18 or older, I have read this, and I agree to take part.",
}


def demonstration(stimuli: Iterable[Stimulus], example: str | None = None) -> StudyDefinition:
    """The study on the given clips, which every participant sees all of.

    Args:
        stimuli: the clips to judge.
        example: content hash of the clip that moves on the welcome page.
    """
    clips = [stimulus.model_dump(mode="json") for stimulus in stimuli]
    return StudyDefinition.model_validate(
        {
            "slug": SLUG,
            "title": "Emotion in walking",
            "welcome": _welcome(len(clips), example),
            "consent": CONSENT,
            "parts": [
                {
                    "kind": "trials",
                    "id": "emotions",
                    "task": TASK,
                    "practice": min(PRACTICE, len(clips)),
                    "stimuli": clips,
                }
            ],
            "thanks": {
                "heading": "Thank you.",
                "text": (
                    "You judged {clips} movements. Together with the other answers they show "
                    "which parts of a movement carry a feeling."
                ),
            },
        }
    )


TASK = {
    "kind": "semantic_differential",
    "question": "How does this person seem to you?",
    "hint": "Choose the nearest. The middle means neither, or not sure.",
    "scales": SCALES,
    "steps": ["very", "rather", "neither", "rather", "very"],
    "comment": {
        "label": "Anything else you noticed?",
        "placeholder": "For example: seems to be looking for something",
    },
}


def _welcome(clips: int, example: str | None) -> dict[str, Any]:
    return {
        "heading": "How does a movement feel?",
        "lead": (
            "You will watch short clips of a moving figure and say what you see in it. There are "
            "no right answers; your first impression is the one we need."
        ),
        "facts": [f"{PRACTICE + clips} short clips", "about 10 minutes", "any device, no sound"],
        "example": example,
    }
