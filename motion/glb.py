"""Clips and bodies as binary glTF: what the browser plays and what Blender opens.

Nodes stand in the skeleton's order and carry the joints' names, in every file. A viewer can
therefore drive a body from one file with the animation of another.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.figure.mesh import FigureMesh
from motion.gltf import ELEMENT_ARRAY_BUFFER, GltfWriter
from motion.rotations import to_matrix
from motion.skeleton import Skeleton

ANIMATION_NAME = "motion"

_INT16 = 32767
_POSITION_STEP = 4  # eighth of a millimetre: finer digits would only be noise to compress
_INT8 = 127
_UINT8 = 255
_WXYZ_TO_XYZW = [1, 2, 3, 0]


def write_clip_glb(clip: Clip, *, figure: FigureMesh | None = None) -> bytes:
    """A clip as a GLB file with one animation, and with its body if given.

    Rotations are 16-bit normalised integers, sign-continuous; the root's way is 32-bit floats.

    Raises:
        MotionError: if the clip has no frame, or the figure belongs to another skeleton.
    """
    if clip.frames == 0:
        raise MotionError("A clip without frames cannot become a GLB file; it needs at least one.")
    writer = GltfWriter()
    skeleton = clip.skeleton
    if figure is None:
        _add_nodes(writer, skeleton, clip.root_positions[0], clip.rotations[0])
        extras = _skeleton_extras(skeleton)
    else:
        if figure.skeleton.content_hash != skeleton.content_hash:
            raise MotionError(
                "The figure was built for another skeleton; build it from the clip that it carries."
            )
        extras = _add_figure(writer, figure)
    extras |= {
        "frame_time": clip.frame_time,
        "frames": clip.frames,
        "cyclic": clip.cyclic,
        "names": list(skeleton.names),
    }
    _add_animation(writer, clip)
    _describe(writer, extras)
    return writer.to_bytes()


def write_figure_glb(figure: FigureMesh) -> bytes:
    """A body in its bind pose, standing on the floor, as a skinned and quantised GLB file."""
    writer = GltfWriter()
    _describe(writer, _add_figure(writer, figure))
    return writer.to_bytes()


def _describe(writer: GltfWriter, extras: dict[str, Any]) -> None:
    """Put our own facts where loaders keep them: asset (three.js) and scene (Blender)."""
    writer.document["asset"]["extras"] = {"manner": extras}
    writer.document["scenes"][0]["extras"] = {"manner": extras}


def _skeleton_extras(skeleton: Skeleton) -> dict[str, Any]:
    roles = {role: skeleton.names[joint] for role, joint in skeleton.roles.items()}
    return {"skeleton": skeleton.content_hash, "roles": roles}


def _add_nodes(
    writer: GltfWriter,
    skeleton: Skeleton,
    root: NDArray[np.float64],
    rotations: NDArray[np.float64],
) -> None:
    places = skeleton.offsets.copy()
    places[0] = root
    turns = rotations[:, _WXYZ_TO_XYZW]
    turns = turns / np.linalg.norm(turns, axis=-1, keepdims=True)
    nodes: list[dict[str, Any]] = [
        {"name": name, "translation": place, "rotation": turn}
        for name, place, turn in zip(skeleton.names, places.tolist(), turns.tolist(), strict=True)
    ]
    for child, parent in enumerate(skeleton.parents.tolist()):
        if parent >= 0:
            nodes[parent].setdefault("children", []).append(child)
    writer.document |= {"scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes}


def _add_animation(writer: GltfWriter, clip: Clip) -> None:
    times = (np.arange(clip.frames) * clip.frame_time).astype(np.float32)
    time = writer.accessor(times, bounds=True)
    root = writer.accessor(clip.root_positions.astype(np.float32))
    turns = _quantised_rotations(clip.rotations)
    view = writer.view(turns)
    samplers = [{"input": time, "output": root, "interpolation": "LINEAR"}]
    channels = [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]
    for joint, turn in enumerate(turns):
        output = writer.accessor(turn, view=view, offset=joint * turn.nbytes, normalized=True)
        samplers.append({"input": time, "output": output, "interpolation": "LINEAR"})
        channels.append({"sampler": joint + 1, "target": {"node": joint, "path": "rotation"}})
    writer.document["animations"] = [
        {"name": ANIMATION_NAME, "samplers": samplers, "channels": channels}
    ]


def _quantised_rotations(rotations: NDArray[np.float64]) -> NDArray[np.int16]:
    """(J, T, 4) xyzw int16 of (T, J, 4) wxyz, signs chosen so that no frame takes the long arc."""
    scaled = np.empty((*rotations.shape[1::-1], 4), np.float32)
    moved = rotations.transpose(1, 0, 2)
    for component, source in enumerate(_WXYZ_TO_XYZW):
        np.multiply(moved[..., source], _INT16, out=scaled[..., component], casting="same_kind")
    dots = np.einsum("jtc,jtc->jt", scaled[:, 1:], scaled[:, :-1])
    if (dots < 0).any():
        scaled[:, 1:] *= np.cumprod(np.where(dots < 0, -1, 1), axis=1)[..., None]
    np.rint(scaled, out=scaled)
    return scaled.astype("<i2")


def _add_figure(writer: GltfWriter, figure: FigureMesh) -> dict[str, Any]:
    """Add joints, skin and mesh; return the extras."""
    skeleton = figure.skeleton
    _add_nodes(writer, skeleton, np.array([0.0, -figure.floor, 0.0]), figure.bind_local)
    scale = max(1.0, float(np.abs(figure.positions).max()))
    inverse = writer.accessor(_inverse_bind_matrices(figure, scale))
    document = writer.document
    document["extensionsUsed"] = document["extensionsRequired"] = ["KHR_mesh_quantization"]
    document["meshes"] = [{"name": "figure", "primitives": [_primitive(writer, figure, scale)]}]
    document["materials"] = [
        {
            "name": "clay",
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.701, 0.651, 0.578, 1.0],  # #DAD3C8 in linear light
                "metallicFactor": 0.0,
                "roughnessFactor": 0.86,
            },
        }
    ]
    joints = list(range(len(skeleton)))
    document["skins"] = [{"inverseBindMatrices": inverse, "joints": joints, "skeleton": 0}]
    document["nodes"].append({"name": _free_name(skeleton), "mesh": 0, "skin": 0})
    document["scenes"][0]["nodes"].append(len(joints))
    return _skeleton_extras(skeleton) | _figure_extras(figure)


def _free_name(skeleton: Skeleton) -> str:
    name = "figure"
    while name in skeleton.names:
        name += "_"
    return name


def _inverse_bind_matrices(figure: FigureMesh, scale: float) -> NDArray[np.float32]:
    """(J, 4, 4) from quantised mesh coordinates into each joint, columns first as glTF stores."""
    turns = to_matrix(figure.bind_rotations)
    matrices = np.zeros((len(turns), 4, 4))
    # Stored column by column, the inverse turn Rᵀ is written as R's rows.
    matrices[:, :3, :3] = turns * scale
    matrices[:, 3, :3] = -np.einsum("jki,jk->ji", turns, figure.bind_positions)
    matrices[:, 3, 3] = 1.0
    return matrices.astype(np.float32)


def _primitive(writer: GltfWriter, figure: FigureMesh, scale: float) -> dict[str, Any]:
    fine = np.rint(figure.positions / scale * (_INT16 // _POSITION_STEP))
    positions = (fine * _POSITION_STEP).astype("<i2")
    normals = np.rint(figure.normals * _INT8).astype("i1")
    small = len(figure.skeleton) <= _UINT8
    joints = np.where(figure.weights > 0, figure.joints, 0).astype("u1" if small else "<u2")
    attributes = {
        "POSITION": writer.attribute(positions, normalized=True, bounds=True),
        "NORMAL": writer.attribute(normals, normalized=True),
        "JOINTS_0": writer.attribute(joints),
        "WEIGHTS_0": writer.attribute(_quantised_weights(figure.weights), normalized=True),
        "_OCCLUSION": writer.attribute(
            np.rint(figure.occlusion * _UINT8).astype("u1"), normalized=True
        ),
    }
    view = writer.view(figure.triangles.astype("<u2").ravel(), target=ELEMENT_ARRAY_BUFFER)
    indices = writer.accessor(figure.triangles.astype("<u2").ravel(), view=view)
    return {"attributes": attributes, "indices": indices, "material": 0}


def _quantised_weights(weights: NDArray[np.float64]) -> NDArray[np.uint8]:
    """(V, 4) uint8 whose rows sum to exactly 255: the strongest influence takes the rounding."""
    whole = np.rint(weights * _UINT8).astype(np.int64)
    whole[:, 0] += _UINT8 - whole.sum(axis=1)
    return whole.astype(np.uint8)


def _figure_extras(figure: FigureMesh) -> dict[str, Any]:
    names = figure.skeleton.names
    return {
        "stature": round(figure.stature, 4),
        "spheres": [
            {
                "node": names[sphere.joint],
                "centre": [round(value, 4) for value in sphere.centre],
                "radius": round(sphere.radius, 4),
                "limb": sphere.limb,
            }
            for sphere in figure.spheres
        ],
        "soles": [
            {
                "node": names[sole.joint],
                "points": [[round(value, 4) for value in point] for point in sole.points],
            }
            for sole in figure.soles
        ],
        "limbs": {names[joint]: limb for joint, limb in figure.limbs.items()},
    }
