"""The binary glTF container: a JSON description and one buffer of numbers."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

ARRAY_BUFFER = 34962
ELEMENT_ARRAY_BUFFER = 34963

_COMPONENT = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
_SHAPE = {(): "SCALAR", (2,): "VEC2", (3,): "VEC3", (4,): "VEC4", (4, 4): "MAT4"}

Numbers = NDArray[Any]


class GltfWriter:
    """Collects accessors and writes the GLB file (glTF 2.0, section 4.4).

    Attributes:
        document: the JSON of the file; callers add nodes, meshes, skins and animations to it.
    """

    def __init__(self) -> None:
        self.document: dict[str, Any] = {"asset": {"version": "2.0", "generator": "Manner"}}
        self._chunks: list[bytes] = []
        self._length = 0
        self._views: list[dict[str, Any]] = []
        self._accessors: list[dict[str, Any]] = []

    def view(self, data: Numbers, *, target: int | None = None, stride: int | None = None) -> int:
        """Store an array's bytes as a buffer view and return the view's index."""
        content = data.tobytes()
        entry: dict[str, Any] = {
            "buffer": 0,
            "byteOffset": self._length,
            "byteLength": len(content),
        }
        if target is not None:
            entry["target"] = target
        if stride is not None:
            entry["byteStride"] = stride
        self._views.append(entry)
        padding = -len(content) % 4
        self._chunks += [content, bytes(padding)]
        self._length += len(content) + padding
        return len(self._views) - 1

    def accessor(
        self,
        data: Numbers,
        *,
        view: int | None = None,
        offset: int = 0,
        normalized: bool = False,
        bounds: bool = False,
    ) -> int:
        """Describe an array (N, ...) to glTF and return the accessor's index.

        Args:
            data: the elements; their trailing shape gives the glTF type.
            view: the buffer view that already holds the bytes; None stores them in a new one.
            offset: bytes from the view's start.
            normalized: integers stand for fractions.
            bounds: write min and max, which glTF demands of positions and times.
        """
        entry: dict[str, Any] = {
            "bufferView": self.view(data) if view is None else view,
            "componentType": _COMPONENT[data.dtype.str[1:]],
            "count": len(data),
            "type": _SHAPE[data.shape[1:]],
        }
        if offset:
            entry["byteOffset"] = offset
        if normalized:
            entry["normalized"] = True
        if bounds:
            entry["min"] = np.atleast_1d(data.min(axis=0)).tolist()
            entry["max"] = np.atleast_1d(data.max(axis=0)).tolist()
        self._accessors.append(entry)
        return len(self._accessors) - 1

    def attribute(self, data: Numbers, *, normalized: bool = False, bounds: bool = False) -> int:
        """Store a vertex attribute (N, ...), each element padded to a multiple of four bytes."""
        count = len(data)
        row = data.reshape(count, -1)
        size = row.shape[1] * data.itemsize
        stride = size + -size % 4
        padded = np.zeros((count, stride), np.uint8)
        padded[:, :size] = np.ascontiguousarray(row).view(np.uint8).reshape(count, size)
        view = self.view(padded, target=ARRAY_BUFFER, stride=stride)
        return self.accessor(data, view=view, normalized=normalized, bounds=bounds)

    def to_bytes(self) -> bytes:
        """The finished GLB file."""
        document = dict(self.document)
        if self._accessors:
            document |= {"accessors": self._accessors, "bufferViews": self._views}
            document["buffers"] = [{"byteLength": self._length}]
        text = json.dumps(document, separators=(",", ":"), ensure_ascii=False).encode()
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + (8 + self._length if self._length else 0)
        parts = [struct.pack("<4sIIII", b"glTF", 2, total, len(text), 0x4E4F534A), text]
        if self._length:
            parts += [struct.pack("<II", self._length, 0x004E4942), *self._chunks]
        return b"".join(parts)
