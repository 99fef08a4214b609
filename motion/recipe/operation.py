"""An operation: a named, versioned edit with parameters, and what it needs from outside."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from motion.clip import Clip
from motion.editing.posture import Pose
from motion.errors import MotionError
from motion.procedural.stances import STANCES, stance
from motion.recipe.parameters import Group, Parameter, Rule, Value

MAX_FRAMES = 200_000


@dataclass(frozen=True, eq=False)
class Materials:
    """What a recipe refers to.

    Attributes:
        poses: pose id to pose; the stances of ``motion.procedural.stances`` need not be in it.
        clips: clip id to clip.
    """

    poses: Mapping[str, Pose] = field(default_factory=dict)
    clips: Mapping[str, Clip] = field(default_factory=dict)

    def pose(self, name: str) -> Pose:
        """The stance or captured pose of that name."""
        return stance(name) if name in STANCES else self.poses[name]


@dataclass(frozen=True, eq=False)
class Context:
    """What an edit may look at besides the clip.

    Attributes:
        materials: poses and clips.
        source: the clip that the recipe began with, or came to when it last changed the body. It
            tells how the body stands: one that was bowed by a step before would be taken for one
            that looks straight ahead.
        unedited: the source in the time of this step.
    """

    materials: Materials
    source: Clip
    unedited: Callable[[], Clip]


Edit = Callable[..., Clip]  # (clip, context, **parameters)


@dataclass(frozen=True, eq=False)
class Operation:
    """One kind of step of a recipe.

    Attributes:
        name: without its version, such as "grid".
        version: a result that would change under the same parameters gets a new one.
        title: its name on screen.
        summary: what it does, in a sentence.
        parameters: what it takes.
        edit: (clip, context, **parameters) to the edited clip.
        follow: what the operation does to the motion that edits are judged against: nothing, or,
            where it changes which moment a frame shows, the same change of time.
        needs: body roles that the skeleton must know.
    """

    name: str
    version: int
    title: str
    summary: str
    parameters: Group
    edit: Edit
    follow: Edit | None = None
    needs: tuple[str, ...] = ()

    @property
    def key(self) -> str:
        """Name and version as recipes write them: "grid@1"."""
        return f"{self.name}@{self.version}"

    def apply(self, clip: Clip, parameters: Mapping[str, Any], context: Context) -> Clip:
        """The edited clip.

        Args:
            clip: the motion before this step.
            parameters: canonical, as the group has read them.
            context: what the edit may look at.

        Raises:
            MotionError: if the clip does not lend itself to the edit.
        """
        missing = [role for role in self.needs if role not in clip.skeleton.roles]
        if missing:
            part = missing[0].replace("_", " ")
            raise MotionError(f"No joint is the {part}: set that body role first.")
        return self.edit(clip, context, **parameters)

    def to_schema(self) -> dict[str, Value]:
        """JSON Schema (2020-12) of the parameters."""
        return {
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            **self.parameters.to_schema(),
        }


def operation(
    key: str,
    title: str,
    summary: str,
    members: Mapping[str, Parameter],
    edit: Edit,
    *,
    follow: Edit | None = None,
    needs: tuple[str, ...] = (),
    rule: Rule | None = None,
) -> Operation:
    """An operation from its key ("grid@1") and its parameters by name."""
    name, _, version = key.partition("@")
    group = Group(title=title, description=summary, members=members, rule=rule)
    return Operation(name, int(version), title, summary, group, edit, follow, needs)


def bounded(frames: float) -> None:
    """Refuses a result before it is made.

    Raises:
        MotionError: if its frames would be too many, or too few to be a motion.
    """
    if frames < 2:
        raise MotionError("Nothing would be left of the clip.")
    if frames > MAX_FRAMES:
        raise MotionError(
            f"The result would have {round(frames)} frames; at most {MAX_FRAMES} are possible."
        )
