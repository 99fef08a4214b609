"""What a participant's page and the server tell each other."""

from datetime import datetime
from typing import Annotated, Any, Literal

from pydantic import AwareDatetime, BaseModel, BeforeValidator, ConfigDict, Field

from app.schemas.study import Interface

SessionState = Literal["active", "complete", "screened_out", "failed_attention", "withdrawn"]
StepKind = Literal[
    "semantic_differential", "unipolar", "likert", "analogue", "choose", "ab", "abx", "parallel",
    "ranking", "free_text", "match", "form", "instructions", "break", "comment", "debriefing",
]  # fmt: skip
Milliseconds = Annotated[float, Field(ge=0, le=1e10, allow_inf_nan=False)]
Count = Annotated[int, Field(ge=0, le=10**9)]
Position = Annotated[float, Field(ge=0, le=100, allow_inf_nan=False)]
Identifier = Annotated[str, Field(max_length=64, pattern=r"^[a-z0-9_]*$")]


def storable(text: object) -> object:
    """Text without what no database stores: NUL and halves of surrogate pairs."""
    if not isinstance(text, str):
        return text
    return text.replace("\0", "").encode("utf-8", "replace").decode()


class Message(BaseModel):
    """A message; members that the other side does not know are refused, not passed over."""

    model_config = ConfigDict(extra="forbid")


class LanguageView(Message):
    """A language that the study can be taken in, in its own words."""

    id: str
    name: str


class StudyView(Message):
    """What a participant's page shows of the study as a whole."""

    title: str
    language: str
    languages: list[LanguageView]
    back: bool
    preview: bool = False


class FigureView(Message):
    """A moving figure. Addresses are content hashes: they do not give the clip's name away."""

    glb_url: str
    figure_url: str | None
    cyclic: bool
    caption: str | None = None


class StepView(Message):
    """One step of the way: a trial about figures, or a page.

    Attributes:
        part: the part of the study that it belongs to.
        figures: those to be judged, as they stand on the page; in `abx` the third is X.
        reference: the figure to compare with, in red.
        instruction: what an attention check says to answer.
        scales: the ids of the scales in the order in which they stand; null: as in the part.
        interface, seen: of `match`, which sliders make the motion, and whether it is seen; a guess
            has no clock.
    """

    index: int
    part: str
    kind: StepKind
    figures: list[FigureView]
    reference: FigureView | None = None
    instruction: str | None = None
    scales: list[str] | None = None
    interface: Interface | None = None
    seen: bool | None = None


class ResponseView(Message):
    """The newest stored answer of a step."""

    revision: int
    answers: dict[str, Any]
    touched: list[str]
    comment: str


class SessionView(Message):
    """A session as its page needs it; `next` is the first step without an answer, or their number.

    The steps of a withdrawn session are gone with its answers.

    Attributes:
        parts: part to what it asks or says: a trial's task, or a page, texts in one language.
    """

    study: StudyView
    state: SessionState
    parts: dict[str, dict[str, Any]]
    steps: list[StepView]
    responses: dict[int, ResponseView]
    next: int


Degrees = Annotated[float, Field(ge=-360, le=360, allow_inf_nan=False)]
Zoom = Annotated[float, Field(gt=0, le=100, allow_inf_nan=False)]
Sight = tuple[Milliseconds, Degrees, Degrees, Zoom]
Move = tuple[Milliseconds, Identifier, Annotated[float, Field(ge=0, le=1)]]


class Viewport(Message):
    """Size of the page in CSS pixels."""

    width: Annotated[int, Field(ge=0, le=100_000)]
    height: Annotated[int, Field(ge=0, le=100_000)]
    pixel_ratio: Annotated[float, Field(gt=0, le=100, allow_inf_nan=False)]


class ViewingRecord(Message):
    """How the figures were watched. Times in ms; what a browser cannot tell is left out.

    Attributes:
        figure_ms: of several figures, how long each was in view and moving.
        camera: how the view was turned, as [ms since the figures came, azimuth and elevation in
            degrees, zoom]; left out where it stayed as it was.
        start: sliders that showed a position before they were touched, and which.
        path: every move of a slider, as [ms since the figures came, slider, position 0 … 1].
    """

    plays: Count | None = None
    viewing_ms: Milliseconds | None = None
    camera_moves: Count | None = None
    hidden_ms: Milliseconds | None = None
    blur_count: Count | None = None
    dropped_frames: Count | None = None
    tier: Annotated[str, Field(max_length=40), BeforeValidator(storable)] | None = None
    viewport: Viewport | None = None
    figure_ms: Annotated[list[Milliseconds], Field(max_length=1000)] | None = None
    camera: Annotated[list[Sight], Field(max_length=200)] | None = None
    start: Annotated[dict[Identifier, Position], Field(max_length=200)] | None = None
    path: Annotated[list[Move], Field(max_length=20_000)] | None = None


ShortText = Annotated[str, Field(max_length=5000), BeforeValidator(storable)]
Value = (
    Annotated[int, Field(ge=-(10**9), le=10**9, strict=True)]
    | Annotated[float, Field(ge=-1e12, le=1e12, allow_inf_nan=False)]
    | ShortText
    | Annotated[list[ShortText], Field(max_length=100)]
)


class Answer(Message):
    """The answer to one step, as the page sends it; a page without a question sends none.

    Attributes:
        revision: 1 for the first answer, one more for each change after going back.
        answers: what was chosen; `app.schemas.study.tasks` says what for each kind of trial. A form
            sends each field's text, number, option or list of options.
        touched: what was set by hand; the others kept what was preselected.
        rt_ms: from the trial's start to the answer; time_elapsed_ms: from the session page's.
        client_time: the browser's clock.
    """

    trial_index: Annotated[int, Field(ge=0, le=100_000)]
    revision: Annotated[int, Field(ge=1, le=100_000)]
    answers: Annotated[dict[Annotated[str, Field(max_length=64)], Value], Field(max_length=1000)]
    touched: Annotated[list[Annotated[str, Field(max_length=64)]], Field(max_length=1000)]
    comment: ShortText = ""
    rt_ms: Milliseconds
    time_elapsed_ms: Milliseconds
    client_time: AwareDatetime
    record: ViewingRecord


class Moved(Message):
    """Where the sliders of a match stand."""

    values: Annotated[
        dict[Identifier, Annotated[float, Field(ge=0, le=1)]],
        Field(min_length=1, max_length=100),
    ]


class AnswerReceipt(Message):
    """The answer is durably stored.

    Attributes:
        state: no longer `active` where the answer has ended the study: the page goes to its thanks.
    """

    trial_index: int
    revision: int
    received_at: datetime
    state: SessionState = "active"


class Completion(Message):
    """Every answer has arrived."""

    state: Literal["complete"] = "complete"
    completion_code: str
    answers: int
