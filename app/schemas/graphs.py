"""Motion graphs and steering through them, as the API tells them."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, StringConstraints
from pydantic.config import JsonValue

_ID = "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11"
_KEY: dict[str, JsonValue] = {
    "source": "stand",
    "source_frame": 30,
    "target": "walk",
    "target_frame": 12,
}
MOST_CLIPS = 12

ClipName = Annotated[str, StringConstraints(min_length=1, max_length=200, strip_whitespace=True)]
ClipId = Annotated[str, Field(max_length=64)]
Frame = Annotated[int, Field(ge=0, le=1_000_000)]
Amount = Annotated[float, Field(ge=-2, le=2)]
Metres = Annotated[float, Field(ge=-1e9, le=1e9)]


def _example(**members: JsonValue) -> ConfigDict:
    return ConfigDict(extra="forbid", json_schema_extra={"example": members})


class TransitionKey(BaseModel):
    """What tells a transition from the others of its graph; frames are counted from 0."""

    model_config = _example(**_KEY)

    source: ClipName
    source_frame: Frame
    target: ClipName
    target_frame: Frame

    def __hash__(self) -> int:
        return hash((self.source, self.source_frame, self.target, self.target_frame))


class GraphShape(BaseModel):
    """What a graph is made of.

    Attributes:
        clips: name within the graph to the clip's id.
        threshold: metres, the greatest distance of a transition that is found by itself.
        fade: seconds that a cross-fade lasts.
        removed: transitions that were found but are left out.
        added: transitions that are there whatever their distance.
    """

    model_config = _example(clips={"walk": _ID}, threshold=0.07, fade=0.3, removed=[], added=[])

    clips: Annotated[dict[ClipName, ClipId], Field(min_length=1, max_length=MOST_CLIPS)]
    threshold: Annotated[float, Field(ge=0.005, le=0.5)] = 0.07
    fade: Annotated[float, Field(ge=0.1, le=1.0)] = 0.3
    removed: Annotated[list[TransitionKey], Field(max_length=5000)] = []
    added: Annotated[list[TransitionKey], Field(max_length=500)] = []


class GraphRequest(GraphShape):
    """A graph to be kept under a name."""

    model_config = _example(name="My walker", clips={"walk": _ID}, threshold=0.07, fade=0.3)

    name: Annotated[str, StringConstraints(min_length=1, max_length=200, strip_whitespace=True)]


class GraphView(BaseModel):
    """A graph in the list. The sample comes with the server and cannot be changed, only copied."""

    id: str
    name: str
    kind: Literal["sample", "own"]
    clips: list[str]
    page_url: str
    created_at: datetime | None


class GraphList(BaseModel):
    """All graphs, the sample first."""

    graphs: list[GraphView]


class GraphClip(BaseModel):
    """A clip of a graph; times in seconds."""

    id: str
    name: str
    frames: int
    frame_time: float
    cyclic: bool
    glb_url: str
    figure_url: str | None


class TransitionView(TransitionKey):
    """A transition; distance in metres, turn in radians about the vertical."""

    model_config = _example(**_KEY, distance=0.021, turn=0.4, added=False)

    distance: float
    turn: float
    added: bool


class GraphTransitions(BaseModel):
    """What was found between clips.

    Attributes:
        fade_frames: frames that a cross-fade lasts.
        transitions: those that can be taken for ever.
        dead_ends: how many were found but left out, because the way would end after them.
    """

    fade_frames: int
    transitions: list[TransitionView]
    dead_ends: int


class GraphDetail(GraphTransitions, GraphShape):
    """A graph with its transitions."""

    model_config = ConfigDict(extra="forbid", json_schema_extra=None)

    id: str
    name: str
    kind: Literal["sample", "own"]
    members: list[GraphClip]


class Manner(BaseModel):
    """How a character moves: path length and timing as in the grid, amounts of postures."""

    model_config = _example(path=1.4, timing=1.0, postures={"head_down": 0.5})

    path: Annotated[float, Field(ge=0, le=2)] = 1.0
    timing: Annotated[float, Field(ge=0, le=2)] = 1.0
    postures: Annotated[dict[str, Amount], Field(max_length=20)] = {}


class Place(BaseModel):
    """Where a character is: its next frame, and where on the floor that clip is played.

    Attributes:
        turn: radians about the vertical; x, z: metres.
    """

    model_config = _example(clip="stand", frame=0, turn=0, x=0, z=0, manner={})

    clip: ClipName
    frame: Frame = 0
    turn: Annotated[float, Field(ge=-1e9, le=1e9)] = 0.0
    x: Metres = 0.0
    z: Metres = 0.0
    manner: Manner = Manner()


class PlayRequest(BaseModel):
    """The next piece of motion that is wanted.

    Attributes:
        place: as the piece before has told it.
        target: the clip that is wanted.
        manner: how it shall move from now on.
        frames: at the most; a cross-fade lasts as long as it does.
        via: a transition to be taken when it comes, whatever the way.
    """

    model_config = _example(place={"clip": "stand"}, target="walk", manner={}, frames=18)

    place: Place
    target: ClipName
    manner: Manner = Manner()
    frames: Annotated[int, Field(ge=1, le=120)] = 18
    via: TransitionKey | None = None


class Piece(BaseModel):
    """A short stretch of motion, and where it leads.

    Attributes:
        frames, joints: its size.
        motion: base64 of little-endian float32: for each frame the root's x, y, z in metres, then
            for each joint the local rotation as x, y, z, w.
        after: the place after it: send it back for the next piece.
        blended: the piece is one cross-fade. Of another piece, any beginning may be shown alone:
            the place then is that of its start, so many frames on.
        taken: the transition that it is.
        ahead: the next transition on the way; wait: frames until it begins.
        reaches: frames from the piece's end until the wanted clip is reached.
    """

    model_config = _example(
        frames=1,
        joints=1,
        motion="AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAACAPw==",
        after={"clip": "stand", "frame": 1, "turn": 0, "x": 0, "z": 0, "manner": {}},
        blended=False,
        taken=None,
        ahead=_KEY,
        wait=29,
        reaches=47,
    )

    frames: int
    joints: int
    motion: str
    after: Place
    blended: bool
    taken: TransitionKey | None
    ahead: TransitionKey | None
    wait: int
    reaches: int
