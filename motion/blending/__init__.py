"""Blends of example motions: weights from parameters, warped time, and feet that stand."""
