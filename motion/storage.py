"""Clips as bytes for a database: lossless, the same bytes for the same clip."""

from __future__ import annotations

import json
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.skeleton import EndSite, Skeleton

_MAGIC = b"manner-clip-1\n"


def clip_to_bytes(clip: Clip) -> bytes:
    """A line that names the format, a line of JSON, then compressed little-endian numbers.

    Numbers are stored by bytes of equal weight, which compresses what changes slowly.
    """
    skeleton = clip.skeleton
    head = {
        "names": skeleton.names,
        "parents": skeleton.parents.tolist(),
        "end_sites": [[site.joint, *site.offset] for site in skeleton.end_sites],
        "roles": dict(sorted(skeleton.roles.items())),
        "frames": clip.frames,
        "frame_time": clip.frame_time,
        "cyclic": clip.cyclic,
    }
    numbers = np.concatenate(
        [skeleton.offsets.ravel(), clip.root_positions.ravel(), clip.rotations.ravel()]
    )
    planes = numbers.astype("<f8").view(np.uint8).reshape(-1, 8).T.tobytes()
    line = json.dumps(head, separators=(",", ":")).encode()
    # Most bytes of a motion are noise to a search for repetitions: without one, packing takes a
    # third of the time and a tenth more room.
    packer = zlib.compressobj(1, strategy=zlib.Z_RLE)
    return _MAGIC + line + b"\n" + packer.compress(planes) + packer.flush()


def clip_from_bytes(data: bytes) -> Clip:
    """The clip that ``clip_to_bytes`` stored.

    Raises:
        MotionError: if the bytes are no stored clip or are damaged.
    """
    if not data.startswith(_MAGIC):
        raise MotionError("These bytes are no stored clip.")
    try:
        line, _, packed = data[len(_MAGIC) :].partition(b"\n")
        head = json.loads(line)
        planes = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(8, -1)
        return _rebuild(head, planes.T.copy().view("<f8").ravel().astype(np.float64))
    except (ValueError, KeyError, TypeError, zlib.error) as error:
        raise MotionError(f"A stored clip is damaged: {error}") from error


def _rebuild(head: dict[str, Any], numbers: NDArray[np.float64]) -> Clip:
    joints, frames = len(head["names"]), int(head["frames"])
    offsets, root_positions, rotations = np.split(numbers, [3 * joints, 3 * joints + 3 * frames])
    skeleton = Skeleton(
        names=tuple(head["names"]),
        parents=np.array(head["parents"], np.intp),
        offsets=offsets.reshape(joints, 3),
        end_sites=tuple(EndSite(joint, (x, y, z)) for joint, x, y, z in head["end_sites"]),
        roles=head["roles"],
    )
    return Clip(
        skeleton,
        root_positions.reshape(frames, 3),
        rotations.reshape(frames, joints, 4),
        head["frame_time"],
        head["cyclic"],
    )
