"""BVH text made for a test: a small person, or a few joints with given values."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

TWO_JOINTS = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT left knee
  {
    OFFSET 0 -45 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 -40 0
    }
  }
}
"""
"""Nine channels; the motion part is missing."""

# name, parent, offset in centimetres: a person of about 1.7 m in a T-pose, facing +z.
PERSON: tuple[tuple[str, str | None, tuple[float, float, float]], ...] = (
    ("Hips", None, (0, 0, 0)),
    ("Spine", "Hips", (0, 12, 0)),
    ("Chest", "Spine", (0, 15, 0)),
    ("Neck", "Chest", (0, 22, 0)),
    ("Head", "Neck", (0, 9, 1)),
    ("LeftShoulder", "Chest", (4, 17, 0)),
    ("LeftArm", "LeftShoulder", (13, 0, 0)),
    ("LeftForeArm", "LeftArm", (28, 0, 0)),
    ("LeftHand", "LeftForeArm", (25, 0, 0)),
    ("RightShoulder", "Chest", (-4, 17, 0)),
    ("RightArm", "RightShoulder", (-13, 0, 0)),
    ("RightForeArm", "RightArm", (-28, 0, 0)),
    ("RightHand", "RightForeArm", (-25, 0, 0)),
    ("LeftUpLeg", "Hips", (9, -3, 0)),
    ("LeftLeg", "LeftUpLeg", (0, -42, 0)),
    ("LeftFoot", "LeftLeg", (0, -41, 0)),
    ("LeftToeBase", "LeftFoot", (0, -5, 14)),
    ("RightUpLeg", "Hips", (-9, -3, 0)),
    ("RightLeg", "RightUpLeg", (0, -42, 0)),
    ("RightFoot", "RightLeg", (0, -41, 0)),
    ("RightToeBase", "RightFoot", (0, -5, 14)),
)
PERSON_HIPS_HEIGHT = 94.0  # centimetres: the balls of the feet 3 cm above the floor


def motion_text(
    rows: Sequence[str], frame_time: str = "0.0333333", declared: int | None = None
) -> str:
    """A MOTION part with the rows as they are."""
    frames = len(rows) if declared is None else declared
    return "\n".join(["MOTION", f"Frames: {frames}", f"Frame Time: {frame_time}", *rows, ""])


def two_joints(*rows: str) -> bytes:
    """Two joints and nine channels, moved by the rows."""
    return (TWO_JOINTS + motion_text(rows)).encode()


def person(
    frames: int = 3,
    *,
    names: dict[str, str] | None = None,
    turn: np.ndarray | None = None,
    scale: float = 1.0,
    bend: float = 0.0,
) -> bytes:
    """A standing person as BVH.

    Args:
        frames: how many equal frames, but for ``bend``.
        names: other names for joints.
        turn: (3, 3) rotation of everything, offsets included.
        scale: file units per centimetre.
        bend: degrees by which every frame turns each joint further about x, the root excepted.
    """
    turn = np.eye(3) if turn is None else turn
    names = names or {}
    children: dict[str | None, list[str]] = {}
    offsets = {name: turn @ np.array(offset, float) * scale for name, _, offset in PERSON}
    for name, parent, _ in PERSON:
        children.setdefault(parent, []).append(name)

    def block(name: str) -> list[str]:
        offset = " ".join(f"{value:.6g}" for value in offsets[name])
        channels = "3 Zrotation Xrotation Yrotation"
        if name == "Hips":
            channels = "6 Xposition Yposition Zposition Zrotation Xrotation Yrotation"
        word = "ROOT" if name == "Hips" else "JOINT"
        lines = [f"{word} {names.get(name, name)}", "{", f"OFFSET {offset}", f"CHANNELS {channels}"]
        for child in children.get(name, []):
            lines += block(child)
        return [*lines, "}"]

    place = turn @ np.array([5.0, PERSON_HIPS_HEIGHT, -20.0]) * scale
    rows = []
    for frame in range(frames):
        angles = [0.0, frame * bend, 0.0] * (len(PERSON) - 1)
        rows.append(" ".join(f"{value:.6f}" for value in [*place, 0, 0, 0, *angles]))
    return "\n".join(["HIERARCHY", *block("Hips"), motion_text(rows)]).encode()
