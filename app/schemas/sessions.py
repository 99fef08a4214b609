"""What a participant's page and the server tell each other."""

from datetime import datetime
from typing import Annotated, Literal

from pydantic import AwareDatetime, BaseModel, BeforeValidator, ConfigDict, Field

SessionState = Literal["active", "complete", "withdrawn"]
Milliseconds = Annotated[float, Field(ge=0, le=1e10, allow_inf_nan=False)]
Count = Annotated[int, Field(ge=0, le=10**9)]


def storable(text: object) -> object:
    """Text without what no database stores: NUL and halves of surrogate pairs."""
    if not isinstance(text, str):
        return text
    return text.replace("\0", "").encode("utf-8", "replace").decode()


class Message(BaseModel):
    """A message; members that the other side does not know are refused, not passed over."""

    model_config = ConfigDict(extra="forbid")


class ScaleView(Message):
    """A bipolar axis as it is asked."""

    id: str
    left: str
    right: str


class StudyView(Message):
    """What a participant's page shows of the study."""

    title: str
    question: str
    hint: str
    scales: list[ScaleView]
    steps: list[str]
    comment_label: str
    comment_placeholder: str


class TrialView(Message):
    """One clip to judge. Addresses are content hashes: they do not give the clip's name away."""

    index: int
    glb_url: str
    figure_url: str | None
    cyclic: bool


class ResponseView(Message):
    """The newest stored answer of a trial."""

    revision: int
    answers: dict[str, int]
    touched: list[str]
    comment: str


class SessionView(Message):
    """A session as its page needs it; `next` is the first trial without an answer, or their number.

    The trials of a withdrawn session are gone with its answers.
    """

    study: StudyView
    state: SessionState
    trials: list[TrialView]
    responses: dict[int, ResponseView]
    next: int


class Viewport(Message):
    """Size of the page in CSS pixels."""

    width: Annotated[int, Field(ge=0, le=100_000)]
    height: Annotated[int, Field(ge=0, le=100_000)]
    pixel_ratio: Annotated[float, Field(gt=0, le=100, allow_inf_nan=False)]


class ViewingRecord(Message):
    """How the clip was watched. Times in ms; what a browser cannot tell is left out."""

    plays: Count | None = None
    viewing_ms: Milliseconds | None = None
    camera_moves: Count | None = None
    hidden_ms: Milliseconds | None = None
    blur_count: Count | None = None
    dropped_frames: Count | None = None
    tier: Annotated[str, Field(max_length=40), BeforeValidator(storable)] | None = None
    viewport: Viewport | None = None


class Answer(Message):
    """One judged clip, as the page sends it.

    Attributes:
        revision: 1 for the first answer, one more for each change after going back.
        answers: scale id to step, 0 in the middle.
        touched: the scales that were set by hand; the others kept the preselected middle.
        rt_ms: from the trial's start to the answer; time_elapsed_ms: from the session page's.
        client_time: the browser's clock.
    """

    trial_index: Annotated[int, Field(ge=0, le=100_000)]
    revision: Annotated[int, Field(ge=1, le=100_000)]
    answers: Annotated[dict[str, int], Field(max_length=200)]
    touched: Annotated[list[str], Field(max_length=200)]
    comment: Annotated[str, Field(max_length=5000), BeforeValidator(storable)] = ""
    rt_ms: Milliseconds
    time_elapsed_ms: Milliseconds
    client_time: AwareDatetime
    record: ViewingRecord


class AnswerReceipt(Message):
    """The answer is durably stored."""

    trial_index: int
    revision: int
    received_at: datetime


class Completion(Message):
    """Every answer has arrived."""

    state: Literal["complete"] = "complete"
    completion_code: str
    answers: int
