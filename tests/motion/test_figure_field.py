"""Distance fields, and the surfaces grown from them, agree with geometry in closed form."""

import numpy as np
import pytest

from motion.figure.field import (
    Above,
    EllipsoidShape,
    Frame,
    Loft,
    RoundCone,
    Union,
    foot_loft,
    gradient,
    smooth_min,
)
from motion.figure.profile import FOOT, FOOT_EXPONENT, SOLE_EDGE, Ring
from motion.figure.surface_nets import sample, surface_nets
from tests.support.figure_cases import edges, volume

WORLD = Frame(np.zeros(3), np.eye(3))


def points_near(rng, reach, count=4000):
    return rng.uniform(-reach, reach, (count, 3))


def ball(radius):
    return EllipsoidShape(WORLD, np.zeros(3), np.full(3, radius))


def net_of(shape, reach, steps=40):
    axis = np.linspace(-reach, reach, steps + 1)
    places, quads = surface_nets(sample(shape.distance, (axis, axis, axis)), (axis, axis, axis))
    return places, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def test_within_blending_reach_a_balls_field_is_its_distance():
    points = points_near(np.random.default_rng(1), 0.09)
    distance = np.linalg.norm(points, axis=1) - 0.1
    assert np.allclose(ball(0.1).distance(points), distance, atol=1e-6)


def test_a_straight_round_loft_is_a_capsules_side():
    rings = [Ring(at, 0.05, 0.05, 0.05) for at in (0.0, 0.1, 0.25, 0.3)]
    loft = Loft(WORLD, rings, (0.05, 0.05), soften=0.01)
    capsule = RoundCone(np.zeros(3), np.array([0.0, 0.3, 0.0]), (0.05, 0.05))
    points = points_near(np.random.default_rng(2), 0.1) + np.array([0.0, 0.15, 0.0])
    assert np.allclose(loft.distance(points), capsule.distance(points), atol=1e-6)


@pytest.mark.parametrize("exponent", [2.0, 2.2, 2.5])
def test_near_a_loft_the_value_is_the_distance_to_first_order(exponent):
    rings = [Ring(0.0, 0.05, 0.06, 0.04, n=exponent), Ring(0.3, 0.03, 0.02, 0.05, n=exponent)]
    loft = Loft(WORLD, rings, (0.03, 0.02), soften=0.01)
    points = points_near(np.random.default_rng(3), 0.1) + np.array([0.0, 0.15, 0.0])
    points = points[np.abs(loft.distance(points)) < 0.004]
    assert len(points) > 50
    slope = np.linalg.norm(gradient(loft, points), axis=1)
    assert np.abs(slope - 1.0).max() < 0.25


def test_a_field_continues_into_its_boxes_distance_without_a_step():
    shape = Union(ball(0.08), (EllipsoidShape(WORLD, np.zeros(3), np.array([0.2, 0.03, 0.05])), 0))
    way = np.linspace(0.0, 0.6, 6000)[:, None] * np.array([0.48, 0.6, 0.64])
    values = shape.distance(way)
    assert np.abs(np.diff(values)).max() < 4 * 1e-4


def test_a_smooth_union_lies_below_both_and_at_most_a_quarter_of_its_radius():
    a, b = np.random.default_rng(4).normal(scale=0.1, size=(2, 5000))
    joined = smooth_min(a, b, 0.08)
    sharp = np.minimum(a, b)
    assert np.all(joined <= sharp)
    assert np.all(joined >= sharp - 0.08 / 4 - 1e-12)
    assert np.array_equal(joined[np.abs(a - b) >= 0.08], sharp[np.abs(a - b) >= 0.08])


def test_a_sole_is_flat_where_it_stands():
    foot = Above(foot_loft(WORLD, FOOT, FOOT_EXPONENT, SOLE_EDGE), WORLD, SOLE_EDGE)
    x, z = np.meshgrid(np.linspace(-0.015, 0.015, 7), np.linspace(-0.03, 0.15, 30))
    sole = np.stack([x.ravel(), np.zeros(x.size), z.ravel()], axis=1)
    assert np.abs(foot.distance(sole)).max() < 1e-6


def test_surface_nets_of_a_ball_have_its_area_and_volume():
    places, triangles = net_of(ball(0.1), 0.13)
    a, b, c = (places[triangles[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2.0
    assert volume(places, triangles) == pytest.approx(4.0 / 3.0 * np.pi * 0.1**3, rel=0.02)
    assert area == pytest.approx(4.0 * np.pi * 0.1**2, rel=0.02)


@pytest.mark.parametrize("gap", np.linspace(0.0, 0.02, 9))
def test_surfaces_that_nearly_touch_stay_closed_manifolds(gap):
    apart = np.array([0.06 + gap / 2.0, 0.003, 0.001])
    pair = Union(
        EllipsoidShape(WORLD, apart, np.full(3, 0.06)),
        (EllipsoidShape(WORLD, -apart, np.full(3, 0.06)), 0.0),
    )
    _, triangles = net_of(pair, 0.16, steps=32)
    directed = edges(triangles)
    assert len(np.unique(directed, axis=0)) == len(directed)
    assert set(map(tuple, directed)) == set(map(tuple, directed[:, ::-1]))


def test_skipping_the_air_far_from_the_surface_changes_nothing():
    shape = Union(ball(0.05), (RoundCone(np.zeros(3), np.full(3, 0.09), (0.02, 0.01)), 0.03))
    axis = np.linspace(-0.2, 0.2, 49)
    points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)
    everywhere = shape.distance(points).reshape(49, 49, 49)
    axes = (axis, axis, axis)
    sparse, quads = surface_nets(sample(shape.distance, axes), axes)
    dense, dense_quads = surface_nets(everywhere, axes)
    assert np.array_equal(sparse, dense)
    assert np.array_equal(quads, dense_quads)
