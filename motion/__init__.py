"""Human motion as data: skeletons, clips, rotations, kinematics, files and sample motion.

Conventions, said once and converted only where a file format or a library wants others:

* lengths in metres, times in seconds, angles in radians;
* right-handed axes, y up; a character faces +z, so its left side is at +x;
* quaternions are unit, ordered ``wxyz``; a rotation maps child coordinates to parent coordinates;
* arrays lead with time, then joint: positions ``(T, J, 3)``, local rotations ``(T, J, 4)``;
* a cyclic clip carries its closing frame: the last frame is the first, moved by the cycle's travel.
"""

from motion.clip import Clip
from motion.errors import MotionError
from motion.skeleton import EndSite, Skeleton

__all__ = ["Clip", "EndSite", "MotionError", "Skeleton"]
