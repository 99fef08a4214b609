"""The study file. `StudyDefinition` is the whole; `Running` says who may come and when."""

from app.schemas.study.definition import (
    Consent,
    Group,
    StudyDefinition,
    Term,
    Thanks,
    Welcome,
)
from app.schemas.study.parts import (
    AnyPart,
    Break,
    Catch,
    CommentPage,
    Debriefing,
    Example,
    Form,
    FormField,
    Instructed,
    Instructions,
    Option,
    Repeated,
    Trials,
)
from app.schemas.study.running import MTurk, Outcome, Prolific, Running, Sona
from app.schemas.study.stimuli import Authored, Interface, Made, Stimulus
from app.schemas.study.tasks import (
    AB,
    ABX,
    OF_ONE,
    OF_TWO,
    Analogue,
    Choose,
    Comment,
    FreeText,
    Item,
    Likert,
    Match,
    Parallel,
    Ranking,
    Scale,
    SemanticDifferential,
    Task,
    Unipolar,
)
from app.schemas.study.words import LANGUAGE_NAMES, LANGUAGES, ContentHash, Language, Words

__all__ = [
    "AB", "ABX", "LANGUAGES", "LANGUAGE_NAMES", "OF_ONE", "OF_TWO", "Analogue", "AnyPart",
    "Authored", "Break", "Catch", "Choose", "Comment", "CommentPage", "Consent", "ContentHash",
    "Debriefing", "Example", "Form", "FormField", "FreeText", "Group", "Instructed", "Instructions",
    "Interface", "Item", "Language", "Likert", "MTurk", "Made", "Match", "Option", "Outcome",
    "Parallel", "Prolific", "Ranking", "Repeated", "Running", "Scale", "SemanticDifferential",
    "Sona", "Stimulus", "StudyDefinition", "Task", "Term", "Thanks", "Trials", "Unipolar",
    "Welcome", "Words",
]  # fmt: skip
