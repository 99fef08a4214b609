"""Motions computed from stored clips: bytes in, bytes out, no database.

Everything here is done in a process of ``app.workers`` or of ``app.jobs``, which keeps the last
clips parsed. What is wrong with a recipe or a clip comes back as an error that names the place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np
import orjson

from app.errors import InvalidError
from app.schemas.retargets import CycleCut
from app.services.clip_files import ClipFiles, make_files, measure_stature
from motion import Clip, MotionError
from motion.bvh_write import write_bvh
from motion.editing.cycle_cut import cut_cycle
from motion.editing.posture import capture_pose
from motion.errors import RecipeError
from motion.figure import FigureMesh, build_figure
from motion.glb import write_clip_glb
from motion.keytimes import find_keytimes, standing_times
from motion.recipe import Materials, Recipe, check_recipe, ease_off_recipe
from motion.retargeting import retarget
from motion.storage import clip_from_bytes

CLIPS_KEPT = 4  # parsed; a clip of 100 s at 100 fps takes 7 MB
FIGURES_KEPT = 16
JSON_NUMBERS = 4_000_000  # the most that a motion written as JSON may hold: about 80 MB

Steps = Sequence[Mapping[str, Any]]


@dataclass(frozen=True)
class Supplies:
    """What a recipe refers to, as it is stored.

    Attributes:
        poses: pose id to body role to rotation (w, x, y, z).
        clips: clip id to the clip's bytes.
    """

    poses: Mapping[str, Mapping[str, list[float]]] = field(default_factory=dict)
    clips: Mapping[str, bytes] = field(default_factory=dict)


def render(source: bytes, operations: Steps, supplies: Supplies, stature: float) -> ClipFiles:
    """The edited clip with all its files; ``stature`` is the source's, in metres.

    On another body it is that of the clip which lends the body.

    Raises:
        InvalidError: the recipe is wrong, or the clip does not lend itself to it.
    """
    with _told():
        clip = _clip(source)
        edited = Recipe.parse(operations).apply(clip, _materials(supplies))
        if edited.skeleton.content_hash == clip.skeleton.content_hash:
            return make_files(edited, stature)
        lent = (_clip(one) for one in supplies.clips.values())
        wanted = edited.skeleton.content_hash
        body = next((one for one in lent if one.skeleton.content_hash == wanted), edited)
        return make_files(edited, measure_stature(body))


def preview(source: bytes, operations: Steps, supplies: Supplies) -> bytes:
    """The edited clip as GLB without a figure.

    Raises:
        InvalidError: as ``render``.
    """
    with _told():
        edited = Recipe.parse(operations).apply(_clip(source), _materials(supplies))
        return write_clip_glb(edited)


def check(source: bytes, operations: Steps, supplies: Supplies) -> dict[str, Any]:
    """What the edit broke, when the feet stand, duration in seconds and number of frames.

    Raises:
        InvalidError: as ``render``.
    """
    with _told():
        recipe, clip, materials = Recipe.parse(operations), _clip(source), _materials(supplies)
        edited = recipe.apply(clip, materials)
        report = check_recipe(clip, recipe, materials, edited)
        return {
            "report": report.to_dict(),
            "contacts": _contacts(edited),
            "duration": edited.duration,
            "frames": edited.frames,
        }


def eased(source: bytes, operations: Steps, supplies: Supplies) -> dict[str, Any]:
    """The recipe lowered until its report is clean: operations, share and report.

    Raises:
        InvalidError: as ``render``.
    """
    with _told():
        recipe, clip, materials = Recipe.parse(operations), _clip(source), _materials(supplies)
        lowered, share, report = ease_off_recipe(clip, recipe, materials)
        return {"operations": lowered.to_list(), "share": share, "report": report.to_dict()}


def pose(clip: bytes, frame: int) -> dict[str, list[float]]:
    """The pose of a frame, counted from 0: body role to rotation (w, x, y, z).

    Raises:
        InvalidError: the clip has no such frame, or its skeleton no body roles.
    """
    with _told():
        known = _clip(clip)
        if not 0 <= frame < known.frames:
            raise InvalidError(
                f"The clip has no frame {frame}.",
                where={"field": "frame"},
                mend=f"Give one from 0 to {known.frames - 1}.",
            )
        captured = capture_pose(known, frame)
    if not captured:
        raise InvalidError(
            "No body role of this clip's skeleton is known, so it has no pose.",
            mend="Set the roles in the report of its import.",
        )
    return {role: [float(value) for value in turn] for role, turn in sorted(captured.items())}


def keytimes(clip: bytes) -> dict[str, float]:
    """Event of a cyclic clip's feet to its time in seconds; empty where none steps."""
    with _told():
        return find_keytimes(_clip(clip))


def retarget_error(source: bytes, onto: bytes, cycle: CycleCut = "none") -> dict[str, Any]:
    """How well a motion would fit another clip's skeleton, once a cycle is cut as wanted.

    Numbers as in ``motion.retargeting``; besides them, which joints would rest.

    Raises:
        InvalidError: a body role is missing that a human body needs, or no cycle can be cut.
    """
    with _told():
        clip, body = _clip(source), _clip(onto)
        if cycle == "found":
            clip = cut_cycle(clip)
        elif cycle == "whole":
            clip = cut_cycle(clip, 0.0, clip.duration)
        roles = body.skeleton.roles.items()
        led = {joint for role, joint in roles if role in clip.skeleton.roles}
        resting = [name for joint, name in enumerate(body.skeleton.names) if joint not in led]
        return {**asdict(retarget(clip, body).error), "resting": resting}


def as_bvh(clip: bytes) -> bytes:
    """BVH text, in centimetres."""
    with _told():
        return write_bvh(_clip(clip))


def as_glb(clip: bytes, with_figure: bool) -> bytes:
    """GLB, with the figure if it is wanted and the skeleton can have one."""
    with _told():
        known = _clip(clip)
        return write_clip_glb(known, figure=_figure(known) if with_figure else None)


def as_json(clip: bytes) -> bytes:
    """The motion as a JSON object: metres, seconds, quaternions w, x, y, z.

    Raises:
        InvalidError: it is too long for JSON.
    """
    known = _clip(clip)
    if known.rotations.size > JSON_NUMBERS:
        raise InvalidError(
            f"A motion of {known.frames} frames is too long for JSON.",
            code="too_long_for_json",
            mend="Take the GLB or BVH file, or add ?motion=false for all but the motion.",
        )
    motion = {
        "names": known.skeleton.names,
        "parents": known.skeleton.parents.tolist(),
        "offsets": np.ascontiguousarray(known.skeleton.offsets),
        "frame_time": known.frame_time,
        "root_positions": np.ascontiguousarray(known.root_positions),
        "rotations": np.ascontiguousarray(known.rotations),
    }
    return orjson.dumps(motion, option=orjson.OPT_SERIALIZE_NUMPY)


_clip: Callable[[bytes], Clip] = lru_cache(maxsize=CLIPS_KEPT)(clip_from_bytes)


def _materials(supplies: Supplies) -> Materials:
    poses = {
        name: {role: np.array(turn) for role, turn in rotations.items()}
        for name, rotations in supplies.poses.items()
    }
    return Materials(poses, {name: _clip(data) for name, data in supplies.clips.items()})


def _contacts(clip: Clip) -> dict[str, list[tuple[float, float]]]:
    """Foot to the stretches of time, in seconds, in which it stands."""
    try:
        return standing_times(clip)
    except MotionError:  # a skeleton without legs stands on nothing
        return {"left": [], "right": []}


def _figure(clip: Clip) -> FigureMesh | None:
    """The mannequin of the clip's skeleton; the last ones are kept, since each takes a second."""
    skeleton = clip.skeleton.content_hash
    if skeleton not in _figures:
        try:
            _figures[skeleton] = build_figure(clip)
        except MotionError:  # a skeleton without a human's parts
            _figures[skeleton] = None
        for oldest in list(_figures)[:-FIGURES_KEPT]:
            _figures.pop(oldest, None)
    return _figures[skeleton]


_figures: dict[str, FigureMesh | None] = {}


@contextmanager
def _told() -> Iterator[None]:
    """What a recipe or a clip makes impossible is the request's fault, not ours."""
    try:
        yield
    except RecipeError as error:
        raise recipe_fault(error) from error
    except MotionError as error:
        raise InvalidError(str(error), code="motion_unusable") from error
    except (ArithmeticError, np.linalg.LinAlgError, MemoryError) as error:
        raise InvalidError(
            "This recipe cannot be computed on this clip.",
            code="recipe_fails",
            mend="Lower its amounts, or take steps out.",
        ) from error


def recipe_fault(error: RecipeError) -> InvalidError:
    """The error with its place: step counted from 1, parameter, and the path in the request."""
    where: dict[str, Any] = {"path": ["operations", *error.where]}
    if error.where:
        where["step"] = int(error.where[0]) + 1
    if "parameters" in error.where:
        where["parameter"] = ".".join(str(part) for part in error.where[2:])
    return InvalidError(error.message, code="recipe_invalid", where=where, mend=error.mend or None)
