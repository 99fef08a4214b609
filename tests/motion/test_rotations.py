"""Laws of rotations, and the same answers as SciPy's."""

from itertools import permutations, product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial.transform import Rotation, Slerp

from motion.errors import MotionError
from motion.rotations import (
    angle_between,
    between,
    conjugate,
    from_axis_angle,
    from_directions,
    from_euler,
    from_matrix,
    make_continuous,
    multiply,
    normalise,
    rotate,
    slerp,
    to_directions,
    to_euler,
    to_matrix,
)

EULER_ORDERS = ["".join(order) for order in permutations("XYZ")] + [
    a + b + a for a, b in product("XYZ", repeat=2) if a != b
]

angles = st.floats(-2 * np.pi, 2 * np.pi)
# Half of all angles lie at or near a quarter turn, where a middle angle locks the gimbal.
locking = angles | st.builds(
    lambda quarter, off: quarter * np.pi / 2 + off, st.integers(-2, 2), st.floats(-1e-6, 1e-6)
)


@st.composite
def quaternions(draw, count=None):
    """Unit quaternions (count, 4), or one (4,)."""
    shape = (4,) if count is None else (count, 4)
    raw = draw(hnp.arrays(float, shape, elements=st.floats(-1, 1)))
    size = np.linalg.norm(raw, axis=-1, keepdims=True)
    return np.where(size > 1e-3, raw / np.maximum(size, 1e-3), [1.0, 0.0, 0.0, 0.0])


@st.composite
def directions(draw):
    raw = draw(hnp.arrays(float, 3, elements=st.floats(-1, 1)))
    size = np.linalg.norm(raw)
    return raw / size if size > 1e-3 else np.array([0.0, 0.0, 1.0])


vectors = hnp.arrays(float, 3, elements=st.floats(-10, 10))
shares = st.floats(0, 1)


def scipy(quaternion):
    return Rotation.from_quat(quaternion, scalar_first=True)


def same(first, second, within=1e-7):
    """Whether two arrays hold the same rotations, whatever their signs."""
    return bool(np.all(angle_between(first, second) <= within))


@pytest.mark.parametrize("order", EULER_ORDERS)
@given(st.tuples(locking, locking, locking))
def test_euler_angles_round_trip_in_every_order_even_at_gimbal_lock(order, triple):
    turned = from_euler(np.array(triple), order)
    assert same(from_euler(to_euler(turned, order), order), turned, within=1e-6)


@pytest.mark.parametrize("order", EULER_ORDERS)
@given(st.tuples(locking, locking, locking))
def test_euler_angles_mean_what_scipy_means_by_intrinsic(order, triple):
    expected = Rotation.from_euler(order, triple).as_quat(scalar_first=True)
    assert same(from_euler(np.array(triple), order), expected)


@pytest.mark.parametrize("order", ["", "Y", "ZX", "ZXY"])
def test_euler_orders_may_have_fewer_letters(order):
    triple = np.array([0.3, -0.7, 1.1])[: len(order)]
    expected = np.array([1.0, 0.0, 0.0, 0.0])
    for letter, angle in zip(order, triple, strict=True):
        expected = multiply(expected, from_axis_angle(np.eye(3)["XYZ".index(letter)], angle))
    assert same(from_euler(triple, order), expected)


@given(quaternions())
def test_directions_round_trip(q):
    six = to_directions(q)
    assert same(from_directions(six), q)
    assert to_directions(from_directions(six)) == pytest.approx(six, abs=1e-12)


@given(quaternions(), st.floats(0.1, 10), st.floats(0.1, 10), st.floats(-5, 5))
def test_only_the_plane_and_first_axis_of_directions_count(q, first, second, shear):
    six = to_directions(q)
    stretched = np.concatenate([first * six[:3], second * six[3:] + shear * six[:3]])
    assert same(from_directions(stretched), q, within=1e-6)


@given(quaternions(5), st.integers(0, 4))
def test_collapsed_directions_take_the_nearest_earlier_frame_else_the_first_good_one(q, lost):
    six = to_directions(q)
    six[lost] = 0
    expected = q.copy()
    expected[lost] = q[lost - 1] if lost else q[1]
    assert same(from_directions(six), expected)


def test_directions_that_never_point_anywhere_are_refused():
    with pytest.raises(MotionError, match="without a direction"):
        from_directions(np.zeros((3, 6)))


@given(quaternions())
def test_matrices_round_trip_and_equal_scipy(q):
    assert to_matrix(q) == pytest.approx(scipy(q).as_matrix(), abs=1e-12)
    assert same(from_matrix(to_matrix(q)), q)


def test_directions_become_the_rotations_that_scipy_makes_of_them():
    """Half of them lie near half a turn, where the scalar part is near zero."""
    rng = np.random.default_rng(11)
    q = rng.normal(size=(4000, 4))
    q[::2, 0] *= np.logspace(-16, 0, 2000)
    q[1::4, 1:] *= np.logspace(-16, 0, 1000)[:, None]
    six = to_directions(normalise(q)) * rng.uniform(0.2, 5.0, (4000, 1))
    x = six[:, :3] / np.linalg.norm(six[:, :3], axis=1, keepdims=True)
    y = six[:, 3:] - np.sum(x * six[:, 3:], axis=1, keepdims=True) * x
    y /= np.linalg.norm(y, axis=1, keepdims=True)
    matrices = np.stack([x, y, np.cross(x, y)], axis=-1)
    expected = Rotation.from_matrix(matrices).as_quat(scalar_first=True)
    ours = from_directions(six)
    signs = np.sign(np.sum(ours * expected, axis=1, keepdims=True))
    np.testing.assert_allclose(ours * signs, expected, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(ours, axis=1), 1.0, atol=1e-12)


@given(quaternions(), quaternions(), vectors)
def test_a_product_turns_by_the_second_then_by_the_first(a, b, v):
    assert rotate(multiply(a, b), v) == pytest.approx(rotate(a, rotate(b, v)), abs=1e-9)
    assert same(multiply(a, b), (scipy(a) * scipy(b)).as_quat(scalar_first=True))


@given(quaternions(), vectors, vectors)
def test_rotation_keeps_lengths_angles_and_handedness(q, v, w):
    a, b = rotate(q, v), rotate(q, w)
    assert a == pytest.approx(scipy(q).apply(v), abs=1e-9)
    assert a @ b == pytest.approx(v @ w, abs=1e-8)
    assert rotate(q, np.cross(v, w)) == pytest.approx(np.cross(a, b), abs=1e-7)


@given(quaternions(), vectors)
def test_the_conjugate_turns_back(q, v):
    assert rotate(conjugate(q), rotate(q, v)) == pytest.approx(v, abs=1e-9)


@given(directions(), angles, vectors)
def test_axis_and_angle_mean_what_scipy_means(axis, angle, v):
    expected = Rotation.from_rotvec(axis * angle).apply(v)
    assert rotate(from_axis_angle(axis, angle), v) == pytest.approx(expected, abs=1e-9)


@given(quaternions(), quaternions())
def test_the_angle_between_is_scipys_and_does_not_care_for_signs(a, b):
    expected = (scipy(a).inv() * scipy(b)).magnitude()
    assert angle_between(a, b) == pytest.approx(expected, abs=1e-7)
    assert angle_between(-a, b) == pytest.approx(expected, abs=1e-7)


@given(quaternions(), quaternions(), shares)
def test_slerp_goes_the_short_way_at_an_even_rate(a, b, share):
    whole = angle_between(a, b)
    middle = slerp(a, b, share)
    assert np.linalg.norm(middle) == pytest.approx(1)
    if whole < np.pi - 1e-4:  # half a turn apart, both ways are the shortest
        assert angle_between(a, middle) == pytest.approx(share * whole, abs=1e-6)
        assert angle_between(middle, b) == pytest.approx((1 - share) * whole, abs=1e-6)
        expected = Slerp([0, 1], Rotation.concatenate([scipy(a), scipy(b)]))(share)
        assert same(middle, expected.as_quat(scalar_first=True), within=1e-6)


@given(quaternions(), quaternions())
def test_slerp_begins_and_ends_where_it_says(a, b):
    assert same(slerp(a, b, 0.0), a)
    assert same(slerp(a, b, 1.0), b)


@given(directions(), directions())
def test_between_turns_one_direction_into_the_other_by_their_angle(a, b):
    turn = between(a, b)
    assert rotate(turn, a) == pytest.approx(b, abs=1e-7)
    angle = np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)
    assert angle_between(np.array([1.0, 0, 0, 0]), turn) == pytest.approx(angle, abs=1e-6)


@pytest.mark.parametrize("off", [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13])
def test_between_nearly_opposite_directions_loses_no_digits(off):
    a, b = np.array([1.0, 0.0, 0.0]), np.array([-np.cos(off), np.sin(off), 0.0])
    assert rotate(between(a, b), a) == pytest.approx(b, abs=1e-9)


@given(directions())
def test_between_opposite_directions_is_half_a_turn(a):
    turn = between(a, -a)
    assert rotate(turn, a) == pytest.approx(-a, abs=1e-9)
    assert np.linalg.norm(turn) == pytest.approx(1)


@given(quaternions(6), st.lists(st.sampled_from([-1.0, 1.0]), min_size=6, max_size=6))
def test_continuous_signs_keep_the_rotations_and_the_first_sign(q, signs):
    flipped = q * np.array(signs)[:, None]
    smooth = make_continuous(flipped)
    assert same(smooth, q)
    assert np.array_equal(smooth[0], flipped[0])
    assert (np.sum(smooth[1:] * smooth[:-1], axis=-1) >= 0).all()


@given(quaternions(), st.floats(0.01, 100))
def test_normalising_takes_only_the_length_away(q, size):
    assert normalise(q * size) == pytest.approx(q, abs=1e-12)


def test_all_functions_work_over_leading_axes():
    q = Rotation.random(24, rng=np.random.default_rng(1)).as_quat().reshape(2, 3, 4, 4)
    one = q[1, 2, 3]
    v = np.array([1.0, 2.0, 3.0])
    for batch, single in (
        (to_matrix(q), to_matrix(one)),
        (to_directions(q), to_directions(one)),
        (to_euler(q, "ZXY"), to_euler(one, "ZXY")),
        (rotate(q, v), rotate(one, v)),
        (multiply(q, q[:, :1]), multiply(one, q[1, 0, 3])),
        (slerp(q, q[:1], 0.3), slerp(one, q[0, 2, 3], 0.3)),
    ):
        assert batch[1, 2, 3] == pytest.approx(single, abs=1e-12)
