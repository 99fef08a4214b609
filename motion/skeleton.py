"""The hierarchy of joints that a clip moves."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from motion.errors import MotionError


@dataclass(frozen=True)
class EndSite:
    """The tip of a chain, such as a toe's end: a point fixed to a joint.

    Attributes:
        joint: index of the joint that carries the tip.
        offset: (x, y, z) in the joint's frame, metres.
    """

    joint: int
    offset: tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Joints in an order where every parent comes before its children.

    Attributes:
        names: unique name of each of the J joints.
        parents: (J,) index of each joint's parent, -1 for the one root, which comes first.
        offsets: (J, 3) position of each joint in its parent's frame, metres. The root's is unused
            while a clip moves it.
        end_sites: tips of the chains, where the source gave them.
        roles: body role (see ``motion.body.ROLES``) to joint index; may be incomplete.

    Raises:
        MotionError: if the arrays disagree, a name is used twice or a parent follows its child.
    """

    names: tuple[str, ...]
    parents: NDArray[np.intp]
    offsets: NDArray[np.float64]
    end_sites: tuple[EndSite, ...] = ()
    roles: Mapping[str, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        count = len(self.names)
        if count == 0:
            raise MotionError("A skeleton needs at least one joint.")
        if self.parents.shape != (count,) or self.offsets.shape != (count, 3):
            raise MotionError(
                f"{count} joint names need parents ({count},) and offsets ({count}, 3); "
                f"got {self.parents.shape} and {self.offsets.shape}."
            )
        if len(set(self.names)) != count:
            raise MotionError("Joint names must be unique.")
        if self.parents[0] != -1 or np.any(self.parents[1:] < 0):
            raise MotionError("The first joint, and no other, must be the root (parent -1).")
        if np.any(self.parents[1:] >= np.arange(1, count)):
            raise MotionError("Every parent must come before its children.")
        if not np.all(np.isfinite(self.offsets)):
            raise MotionError("Joint offsets must be finite numbers.")
        for array in (self.parents, self.offsets):
            array.setflags(write=False)

    def __len__(self) -> int:
        return len(self.names)

    @cached_property
    def content_hash(self) -> str:
        """SHA-256 of everything that defines the skeleton: equal hashes mean equal skeletons."""
        description = json.dumps(
            [self.names, sorted(self.roles.items()), [[s.joint, s.offset] for s in self.end_sites]]
        )
        digest = hashlib.sha256(description.encode())
        digest.update(np.asarray(self.parents, "<i8").tobytes())
        digest.update(np.asarray(self.offsets, "<f8").tobytes())
        return digest.hexdigest()

    def hangs_from(self, joint: int, ancestor: int) -> bool:
        """Whether ``joint`` is ``ancestor`` or moves with it, at any distance."""
        while joint > ancestor:
            joint = int(self.parents[joint])
        return joint == ancestor

    def with_roles(self, roles: Mapping[str, int]) -> Skeleton:
        """The same joints with other body roles."""
        return replace(self, roles=dict(roles))
