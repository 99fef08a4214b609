"""What recipes are made of: operations, presets, poses."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, NotFoundError
from app.persistence import clips, jobs, poses
from app.persistence.engine import Database
from app.persistence.models import PoseRecord
from app.schemas.edits import (
    OperationList,
    OperationView,
    PoseList,
    PoseRequest,
    PoseView,
    PresetList,
    PresetView,
)
from app.schemas.library import Step
from app.services import library
from app.workers import Workers

# The motion library is imported where it is used: it brings SciPy, for which the server's start
# shall not wait.


def operations() -> OperationList:
    """All operations, each with the JSON Schema of its parameters."""
    from motion.recipe import OPERATIONS

    return OperationList(operations=[_operation(key) for key in OPERATIONS])


def operation(name: str) -> OperationView:
    """The operation of that name and version, such as ``grid@1``.

    Raises:
        NotFoundError: there is none; names like it are offered.
    """
    from motion.recipe import OPERATIONS
    from motion.recipe.parameters import offer

    if name not in OPERATIONS:
        raise NotFoundError(
            "There is no such operation.",
            code="operation_not_found",
            mend=offer(name, tuple(OPERATIONS)),
        )
    return _operation(name)


def presets() -> PresetList:
    """The recipes that come with the server."""
    from motion.recipe import PRESETS

    views = [
        PresetView.model_validate(
            {
                **{field: getattr(preset, field) for field in PresetView.model_fields},
                "operations": preset.operations.to_list(),
            }
        )
        for preset in PRESETS.values()
    ]
    return PresetList(presets=views)


def in_words(db: Session, recipe: Sequence[Step]) -> list[tuple[str, list[str]]]:
    """Title of each step and what it was given, as people read it: clips by their names."""
    from motion.recipe import OPERATIONS

    names = {
        clip.id: clip.name
        for clip in clips.named(db, set(_ids([step.parameters for step in recipe])))
    }
    told = []
    for step in recipe:
        operation = OPERATIONS.get(step.operation)
        if operation is None:  # of an engine that knew it
            told.append((step.operation, [f"{n} {v}" for n, v in step.parameters.items()]))
        else:
            schema = dict(operation.to_schema())
            told.append((operation.title, list(_members(schema, step.parameters, names))))
    return told


def listed_poses(db: Session) -> PoseList:
    """The stances that come with the server, then the captured poses by name."""
    from motion.procedural.stances import STANCES, stance

    stances = [
        PoseView(
            id=name, name=name.replace("_", " ").capitalize(), stance=True, clip=None, frame=None,
            created_at=None, rotations={role: turn.tolist() for role, turn in stance(name).items()},
        )
        for name in STANCES
    ]  # fmt: skip
    return PoseList(poses=[*stances, *(_view(pose) for pose in poses.listed(db))])


def capture_pose(database: Database, workers: Workers, request: PoseRequest) -> PoseView:
    """Keep the pose of a clip's frame. The same pose again is stored once, under its newer name.

    Raises:
        InvalidError: the clip has no such frame, or no body roles.
    """
    from app.services import rendering

    with database.reading() as db:
        clip = library.find(db, request.clip, signed_in=True)
        content = library.content(db, clip)
    rotations = workers.run(clip.id, rendering.pose, content, request.frame)
    text = json.dumps(rotations, sort_keys=True, separators=(",", ":"))
    with database.writing() as db:
        pose = poses.put(
            db,
            PoseRecord(
                id=hashlib.sha256(text.encode()).hexdigest(),
                name=request.name,
                rotations=rotations,
                clip_id=library.find(db, clip.id, signed_in=True).id,
                frame=request.frame,
            ),
        )
        db.commit()
        return _view(pose)


def delete_pose(db: Session, pose_id: str) -> None:
    """Delete a captured pose.

    Raises:
        NotFoundError: there is none.
        ConflictError: clips were made with it, which could not be made again, or shall be.
    """
    pose = poses.by_id(db, pose_id)
    if pose is None:
        raise NotFoundError(
            "There is no such captured pose.",
            code="pose_not_found",
            mend="Choose one of the listed poses; those that come with the server stay.",
        )
    if used := poses.used_by(db, pose_id):
        raise ConflictError(
            f"{used} {'clip was' if used == 1 else 'clips were'} made with this pose.",
            code="pose_in_use",
            mend="Delete what was made with it first.",
            extra={"edits": used},
        )
    if jobs.refer_to(db, pose_id):
        raise ConflictError(
            "A job that is not done yet needs this pose.",
            code="pose_in_use",
            mend="Wait for the job, or cancel it.",
        )
    poses.delete(db, pose)
    db.commit()


def _members(
    schema: Mapping[str, Any], values: Mapping[str, Any], names: Mapping[str, str]
) -> Iterator[str]:
    for name, value in values.items():
        about = schema["properties"].get(name, {"title": name})
        if isinstance(value, list) and value and isinstance(value[0], dict):
            for entry in value:
                yield ", ".join(_members(about["items"], entry, names))
        elif isinstance(value, dict) and "properties" in about:
            yield f"{about['title']}: {', '.join(_members(about, value, names))}"
        elif value is not None and value != []:
            yield f"{about['title']}: {_value(value, about.get('unit', ''), names)}"


def _value(value: object, unit: str, names: Mapping[str, str]) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        number = f"{value:.3g}".replace("-", "−")
        return number if not unit else f"{number}{'' if unit == '°' else ' '}{unit}"
    if isinstance(value, list):
        return ", ".join(_value(one, "", names) for one in value)
    text = str(value)
    if text in names:
        return names[text]
    return f"{text[:8]}…" if len(text) == 64 else text.replace("_", " ")


def _ids(value: object) -> Iterator[str]:
    """Every text in a recipe that may be a clip's id."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        for one in value:
            yield from _ids(one)
    elif isinstance(value, str) and len(value) == 64:
        yield value


def _operation(key: str) -> OperationView:
    from motion.recipe import OPERATIONS

    found = OPERATIONS[key]
    return OperationView(
        name=key, title=found.title, summary=found.summary, parameters=dict(found.to_schema())
    )


def _view(pose: PoseRecord) -> PoseView:
    return PoseView(
        id=pose.id, name=pose.name, stance=False, clip=pose.clip_id, frame=pose.frame,
        created_at=pose.created_at, rotations=pose.rotations,
    )  # fmt: skip
