"""The mannequin: one seamless body, grown from a skeleton and its joints' roles."""

from motion.figure.build import build_figure
from motion.figure.mesh import FigureMesh, Sole, Sphere

__all__ = ["FigureMesh", "Sole", "Sphere", "build_figure"]
