"""What a participant is told of an error, by its code, in the participant's own language.

In English the error speaks for itself: it knows the place. In other languages these stand in.
"""

from __future__ import annotations

from collections.abc import Iterator

from app import i18n
from app.schemas.study import Language

_KEPT = "What you have answered is kept."
_RELOAD = "Load the page again; what you have answered is kept."
_AS_GOT = "Open the link exactly as you got it."
_LATER = "Try again in a moment. What you have answered is kept."

# Code to what is wrong and what to do about it.
TEXTS: dict[str, tuple[str, str]] = {
    "study_not_found": (
        "There is no such study on this server.",
        "Check the link that you were given.",
    ),
    "study_not_published": (
        "There is no such study on this server.",
        "Check the link that you were given.",
    ),
    "study_closed": (
        "This study takes nobody new now.",
        "If you had begun already, your own link still works.",
    ),
    "study_full": ("This study is full.", "Nothing was kept. You can try again later."),
    "session_expired": (
        "This personal link is too old.",
        "What you answered is kept. Write to the researchers if you want to go on.",
    ),
    "session_not_found": ("This personal link is not known here.", _AS_GOT),
    "invitation_invalid": (
        "This personal link is not complete, or belongs to another study.",
        _AS_GOT,
    ),
    "consent_changed": (
        "The text that you agreed to has changed since you opened the page.",
        "Please read the new text and agree again.",
    ),
    "session_withdrawn": (
        "You have withdrawn from this study, and your answers are deleted.",
        "There is nothing more to do.",
    ),
    "session_ended": (
        "The study has ended for you.",
        "There is nothing more to do. Load the page again to see why.",
    ),
    "session_complete": (
        "The study is complete; its answers can no longer be changed.",
        "All that you answered before is stored.",
    ),
    "already_answered": (
        "Another answer is stored here already, perhaps from a second tab.",
        "Load the page again: it shows what is stored.",
    ),
    "answer_invalid": ("The answer does not fit the study.", "Load the page and answer again."),
    "trial_unknown": ("The study has no such page.", _RELOAD),
    "slider_unknown": ("The study has no such slider.", _RELOAD),
    "too_early": ("An earlier page is not answered yet.", _LATER),
    "unseen": ("The motion of a guess is not shown.", _RELOAD),
    "answers_missing": ("Some answers are still missing.", "Answer what is missing. " + _KEPT),
    "invalid_request": ("The server did not understand the page.", _RELOAD),
    "csrf_token_invalid": ("The page was open for too long.", _RELOAD),
    "busy": ("The server is busy.", _LATER),
    "too_many_attempts": ("That was too often in a short time.", _LATER),
    "not_found": ("There is nothing at this address.", "Check the link that you were given."),
}
OTHERWISE = ("Something went wrong on our side.", _LATER)


def told(code: str, message: str, mend: str | None, language: Language) -> tuple[str, str | None]:
    """What is wrong and what to do about it, in the participant's language."""
    if language == i18n.SOURCE:
        return message, mend
    wrong, advice = TEXTS.get(code, OTHERWISE)
    phrases = i18n.phrases(language)
    return str(phrases.text(wrong)), str(phrases.text(advice)) if advice else None


def all_texts() -> Iterator[str]:
    """Every text once, for the catalogs."""
    yield from dict.fromkeys(text for pair in (*TEXTS.values(), OTHERWISE) for text in pair if text)
