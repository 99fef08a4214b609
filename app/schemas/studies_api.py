"""Studies as the API tells them: their list, their drafts and versions, how they are run."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, model_validator

from app.schemas.live import Role
from app.schemas.sessions import storable
from app.schemas.study import Running

State = Literal["draft", "open", "paused", "closed"]
MOST_CLIPS = 1000
ClipId = Annotated[str, Field(max_length=64), BeforeValidator(storable)]
Label = Annotated[str, Field(min_length=1, max_length=64), BeforeValidator(storable)]


class StudyCounts(BaseModel):
    """How many participants stand where; simulated ones and those left out are not among them."""

    complete: int = 0
    active: int = 0
    withdrawn: int = 0


class StudyLine(BaseModel):
    """A study in the list.

    Attributes:
        version: number of the newest version; None before the first was published.
        draft: whether there are changes that no version has yet.
    """

    slug: str
    title: str
    state: State
    role: Role
    version: int | None
    draft: bool
    counts: StudyCounts
    created_at: datetime


class StudyList(BaseModel):
    """Every study that the caller may see."""

    studies: list[StudyLine]


class Problem(BaseModel):
    """What stands in the way of publishing, where in the study file, and the mend."""

    model_config = ConfigDict(
        json_schema_extra={
            "example": {
                "where": ["parts", 0, "task", "question"],
                "message": "This is empty.",
                "mend": "Write something here.",
            }
        }
    )

    where: list[str | int]
    message: str
    mend: str | None = None


class VersionLine(BaseModel):
    """A published version: never changed, and answers belong to it.

    Attributes:
        hash: SHA-256 of its definition's canonical JSON.
        changes: what it changed against the version before, one sentence each.
        sessions: how many participants began it.
    """

    number: int
    hash: str
    published_at: datetime
    changes: list[str]
    sessions: int


class StudyDetail(BaseModel):
    """A study with everything that its makers work on.

    Attributes:
        draft: the study file as it is being edited; None where it equals the newest version.
        saved_at: when the draft was last saved or, if it never was, the study was made.
        definition: the newest version.
        problems: of the draft; none of them keeps it from being saved.
        can_be_shown: whether the preview can show it in spite of them.
    """

    slug: str
    title: str
    state: State
    role: Role
    draft: dict[str, Any] | None
    saved_at: datetime
    definition: dict[str, Any] | None
    versions: list[VersionLine]
    running: Running
    problems: list[Problem]
    can_be_shown: bool


class UploadedFile(BaseModel):
    """A study file: its text, and its name, whose ending tells YAML from JSON."""

    name: str = Field(max_length=200)
    text: str


class NewStudy(BaseModel):
    """What a new study is made from: a template, a definition, or a study file; else it is empty.

    Attributes:
        template: id of one of the templates.
        definition: a study file's content; it need not be complete.
        title: in the place of the template's own.
        clips: ids, for the first part that asks about clips, in the place of its own; an empty
            study gets such a part.
    """

    model_config = ConfigDict(extra="forbid", json_schema_extra={"example": {"title": "Gaits"}})

    template: Annotated[str, Field(max_length=100)] | None = None
    definition: dict[str, Any] | None = None
    file: UploadedFile | None = None
    title: str | None = Field(default=None, min_length=1, max_length=200)
    clips: list[ClipId] = Field(default=[], max_length=MOST_CLIPS)

    @model_validator(mode="after")
    def _says_one(self) -> Self:
        if sum(one is not None for one in (self.template, self.definition, self.file)) > 1:
            raise ValueError("give one of template, definition and file")
        return self


class SavedDraft(BaseModel):
    """A draft that was saved, what stands in the way of publishing it, and of its preview."""

    saved_at: datetime
    problems: list[Problem]
    can_be_shown: bool


class AskingPart(BaseModel):
    """A part of a study that asks about clips.

    Attributes:
        task: the kind of its question.
        clips: how many it has.
    """

    id: str
    task: str
    clips: int


class StudyDraft(BaseModel):
    """What is being edited of a study: the draft, or the newest version where there is none.

    Attributes:
        version: number of the newest version; None before the first was published.
        parts: those that ask about clips.
    """

    slug: str
    title: str
    state: State
    version: int | None
    languages: list[str]
    parts: list[AskingPart]


class DraftList(BaseModel):
    """What is being edited of every study that the caller may change."""

    drafts: list[StudyDraft]


class NewClips(BaseModel):
    """Clips for a study, by their ids.

    Attributes:
        part: that shall have them; left out, the first that asks about clips. A study without any
            gets one, with one question.
    """

    model_config = ConfigDict(
        extra="forbid", json_schema_extra={"example": {"clips": ["0f4c2b5f…"], "part": "walks"}}
    )

    clips: list[ClipId] = Field(min_length=1, max_length=MOST_CLIPS)
    part: Annotated[str, Field(max_length=60)] | None = None


class ClipsAdded(BaseModel):
    """Clips that a study has now.

    Attributes:
        title: of the study.
        part: that has them.
        added, already: ids of those that are new there, and of those that were there before.
    """

    title: str
    part: str
    added: list[str]
    already: list[str]
    draft: SavedDraft


class Changes(BaseModel):
    """What publishing would change.

    Attributes:
        number, hash: those of the version that it would make.
        same: nothing is new, and no version would be made.
    """

    number: int
    hash: str
    same: bool
    changes: list[str]


class StateChange(BaseModel):
    """Whether new participants may begin."""

    model_config = ConfigDict(extra="forbid")

    state: Literal["open", "paused", "closed"]


class TemplateLine(BaseModel):
    """A study that is ready to be taken as a beginning."""

    id: str
    title: str
    summary: str
    minutes: int


class TemplateList(BaseModel):
    """The templates that come with the server."""

    templates: list[TemplateLine]


class InvitationRequest(BaseModel):
    """For whom personal links are wanted, or how many.

    Attributes:
        labels: own names for the participants, one link each; the same name gives the same link.
        count: how many links with new names, where no labels are given.
    """

    model_config = ConfigDict(extra="forbid", json_schema_extra={"example": {"count": 20}})

    labels: list[Label] = Field(default=[], max_length=1000)
    count: int = Field(default=1, ge=1, le=1000)


class Invitation(BaseModel):
    """A personal link: one participant each."""

    label: str
    url: str


class InvitationList(BaseModel):
    """Personal links, in the order of their labels."""

    invitations: list[Invitation]
