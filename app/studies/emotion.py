"""The demonstration study: Förger's questionnaire on the emotional content of walks.

Source: K. Förger's master's thesis on the emotional content of captured motion, chapter 4.3.
"""

from collections.abc import Iterable

from app.schemas.study import (
    Comment,
    Consent,
    Scale,
    Stimulus,
    StudyDefinition,
    Term,
    Thanks,
    Welcome,
)

SLUG = "emotion-in-walking"
SAMPLE_SET = "acted"
EXAMPLE_SET = "A"
THANKS_SET = "gesture"
PRACTICE = 2

SCALES = (
    Scale(id="sad_happy", left="sad", right="happy", left_more="sadder", right_more="happier"),
    Scale(
        id="tired_excited",
        left="tired",
        right="excited",
        left_more="more tired",
        right_more="more excited",
    ),
    Scale(
        id="angry_relaxed",
        left="angry",
        right="relaxed",
        left_more="angrier",
        right_more="more relaxed",
    ),
    Scale(id="weak_strong", left="weak", right="strong", left_more="weaker", right_more="stronger"),
    Scale(
        id="afraid_confident",
        left="afraid",
        right="confident",
        left_more="more afraid",
        right_more="more confident",
    ),
    Scale(
        id="masculine_feminine",
        left="masculine",
        right="feminine",
        left_more="more masculine",
        right_more="more feminine",
    ),
)

CONSENT = Consent(
    version="1",
    heading="Before you begin",
    terms=(
        Term(
            term="What is kept",
            text="Your answers and how long they took. No name and no internet address.",
        ),
        Term(term="How long", text="Until whoever runs this server deletes the demonstration."),
        Term(
            term="Your right",
            text="Stop at any time. A personal link lets you delete your answers later.",
        ),
        Term(
            term="Who asks",
            text="Whoever runs this server. It is a demonstration, not a registered study.",
        ),
    ),
    statement="I am 18 or older, I have read this, and I agree to take part.",
)


def demonstration(stimuli: Iterable[Stimulus], example: str | None = None) -> StudyDefinition:
    """The study on the given clips, which every participant sees all of.

    Args:
        stimuli: the clips to judge.
        example: content hash of the clip that moves on the welcome page.
    """
    clips = tuple(stimuli)
    return StudyDefinition(
        slug=SLUG,
        title="Emotion in walking",
        welcome=Welcome(
            heading="How does a movement feel?",
            lead=(
                "You will watch short clips of a moving figure and say what you see in it. There "
                "are no right answers; your first impression is the one we need."
            ),
            facts=(
                f"{PRACTICE + len(clips)} short clips",
                "about 10 minutes",
                "any device, no sound",
            ),
            example=example,
        ),
        consent=CONSENT,
        question="How does this person seem to you?",
        hint="Choose the nearest. The middle means neither, or not sure.",
        scales=SCALES,
        steps=("very", "rather", "neither", "rather", "very"),
        comment=Comment(
            label="Anything else you noticed?",
            placeholder="For example: seems to be looking for something",
        ),
        practice=PRACTICE,
        stimuli=clips,
        thanks=Thanks(
            heading="Thank you.",
            text=(
                "You judged {clips} movements. Together with the other answers they show which "
                "parts of a movement carry a feeling."
            ),
        ),
    )
