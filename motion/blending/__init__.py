"""Blends of example motions: weights from parameters, warped time, and feet that stand."""

from motion.blending.blender import Blender
from motion.blending.distance import matching_distance
from motion.blending.hull import outside_hull
from motion.blending.weights import WeightMap

__all__ = ["Blender", "WeightMap", "matching_distance", "outside_hull"]
