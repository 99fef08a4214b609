"""The body is one closed skin that any skeleton can carry."""

import numpy as np
import pytest
from scipy.spatial import KDTree

from motion.clip import Clip
from motion.errors import MotionError
from motion.figure import build_figure
from motion.figure.bind import bind_pose
from motion.figure.body import make_body
from motion.kinematics import pose_to_world
from motion.procedural.bodies import BODIES
from motion.procedural.knock import walk_and_knock
from motion.rotations import angle_between, from_axis_angle, multiply, rotate, to_matrix
from tests.support.figure_cases import (
    CASES,
    RECORDED,
    SAMPLE,
    edges,
    figure_of,
    recorded_clip,
    sample_clip,
    scaled,
    volume,
    without_roles,
)

OPTIONAL = ("spine", "chest", "neck", "clavicle", "hand", "toes")


@pytest.fixture(
    scope="module",
    params=[pytest.param(c, marks=[pytest.mark.motions] if c in RECORDED else []) for c in CASES],
)
def clip(request):
    if request.param in SAMPLE:
        return sample_clip(request.param)
    return recorded_clip(request.getfixturevalue("motions_dir") / request.param)


@pytest.fixture(scope="module")
def figure(clip):
    return figure_of(clip)


def posed(figure, clip, frame):
    """(V, 3) the skin in one frame of a clip, by linear blending of the joints' turns."""
    part = slice(frame, frame + 1)
    pose = pose_to_world(clip.skeleton, clip.root_positions[part], clip.rotations[part])
    turns = to_matrix(pose.rotations[0]) @ to_matrix(figure.bind_rotations).transpose(0, 2, 1)
    moved = pose.positions[0] - np.einsum("jab,jb->ja", turns, figure.bind_positions)
    each = np.einsum("vkab,vb->vka", turns[figure.joints], figure.positions) + moved[figure.joints]
    return np.einsum("vk,vka->va", figure.weights, each)


def test_the_skin_is_one_closed_surface_that_faces_outward(figure):
    directed = edges(figure.triangles)
    assert len(np.unique(directed, axis=0)) == len(directed)
    assert set(map(tuple, directed)) == set(map(tuple, directed[:, ::-1]))
    assert len(figure.positions) - len(directed) // 2 + len(figure.triangles) == 2
    assert volume(figure.positions, figure.triangles) > 0.0


def test_normals_are_unit_and_agree_with_the_faces(figure):
    corners = figure.positions[figure.triangles]
    face = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middle = figure.normals[figure.triangles].mean(axis=1)
    assert np.allclose(np.linalg.norm(figure.normals, axis=1), 1.0)
    assert np.mean(np.sum(face * middle, axis=1) > 0) > 0.995


def test_weights_are_shares_of_at_most_four_joints(figure):
    assert figure.weights.shape == figure.joints.shape == (len(figure.positions), 4)
    assert np.all(figure.weights >= 0)
    assert np.allclose(figure.weights.sum(axis=1), 1.0)
    assert np.all(np.diff(figure.weights, axis=1) <= 1e-12)


def test_every_limb_carries_skin(figure):
    carried = np.bincount(
        figure.joints.ravel(), figure.weights.ravel(), minlength=len(figure.skeleton)
    )
    for role in ("head", "left_forearm", "right_hand", "left_thigh", "right_shin", "left_foot"):
        assert carried[figure.skeleton.roles[role]] > 20.0, role


def test_the_size_stays_within_its_limits(figure):
    assert 5000 <= len(figure.positions) <= 8000
    assert 36 <= len(figure.spheres) <= 52


def test_soles_are_level_and_on_the_lowest_skin(figure):
    heights = [
        figure.bind_positions[sole.joint]
        + rotate(figure.bind_rotations[sole.joint], np.array(point))
        for sole in figure.soles
        for point in sole.points
    ]
    assert np.ptp(np.array(heights)[:, 1]) < 0.002
    assert figure.positions[:, 1].min() == pytest.approx(figure.floor, abs=0.002)
    assert np.array(heights)[:, 1].mean() == pytest.approx(figure.floor, abs=0.002)


def test_the_body_stands_upright_and_looks_ahead(figure, clip):
    pose = bind_pose(clip)
    head = pose.place("head")
    face = figure.positions[figure.positions[:, 1] > head[1]]
    assert np.abs(face[:, 0] - head[0]).max() < 0.1
    assert face[:, 2].max() - head[2] > 0.06
    assert pose.place("left_thigh")[0] > pose.place("right_thigh")[0]
    for side in ("left", "right"):
        knee = pose.place(f"{side}_shin") - pose.place(f"{side}_thigh")
        elbow = pose.place(f"{side}_forearm") - pose.place(f"{side}_upper_arm")
        assert np.degrees(np.arccos(-knee[1] / np.linalg.norm(knee))) == pytest.approx(13, abs=0.1)
        assert np.degrees(np.arccos(-elbow[1] / np.linalg.norm(elbow))) == pytest.approx(
            46, abs=0.1
        )


def test_in_motion_the_soles_meet_the_floor(figure, clip):
    lowest = [posed(figure, clip, frame)[:, 1].min() for frame in range(0, clip.frames, 5)]
    assert abs(np.median(lowest)) < 0.03
    assert min(lowest) > -0.06


def test_in_motion_no_limb_is_thinned_to_a_wrapper(figure, clip):
    """Linear blending collapses where two bones twist against each other; volume would tell."""
    rest = volume(figure.positions, figure.triangles)
    for frame in range(0, clip.frames, max(1, clip.frames // 6)):
        moved = volume(posed(figure, clip, frame), figure.triangles)
        assert moved == pytest.approx(rest, rel=0.05)


def test_the_resting_joints_are_what_the_clips_skeleton_makes_of_the_resting_turns(figure):
    pose = pose_to_world(figure.skeleton, np.zeros((1, 3)), figure.bind_local[None])
    assert np.allclose(pose.positions[0], figure.bind_positions, atol=1e-9)


def test_the_same_clip_gives_the_same_body():
    first, second = (build_figure(sample_clip("female")) for _ in range(2))
    for name in ("positions", "normals", "triangles", "joints", "weights", "occlusion"):
        assert np.array_equal(getattr(first, name), getattr(second, name)), name
    assert first.spheres == second.spheres
    assert first.soles == second.soles


def test_a_mirrored_skeleton_has_a_mirrored_body():
    figure = figure_of(sample_clip("adult"))
    mirrored = figure.positions * np.array([-1.0, 1.0, 1.0])
    off, _ = KDTree(figure.positions).query(mirrored)
    assert np.quantile(off, 0.99) < 0.002


def test_a_larger_skeleton_has_the_same_body_larger():
    clip = sample_clip("adult")
    small, large = figure_of(clip), build_figure(scaled(clip, 1.15))
    assert large.stature == pytest.approx(1.15 * small.stature, rel=0.005)
    assert volume(large.positions, large.triangles) == pytest.approx(
        1.15**3 * volume(small.positions, small.triangles), rel=0.02
    )


@pytest.mark.parametrize("body", SAMPLE)
def test_the_stature_is_the_skeletons(body):
    tall = {"adult": 1.72, "female": 1.65, "male": 1.79}[body]
    assert figure_of(sample_clip(body)).stature == pytest.approx(tall, abs=0.03)


@pytest.mark.parametrize("missing", [*[(part,) for part in OPTIONAL], OPTIONAL])
def test_a_missing_part_is_carried_by_its_neighbours(missing):
    clip = without_roles(sample_clip("adult"), *missing)
    whole, figure = figure_of(sample_clip("adult")), build_figure(clip)
    directed = edges(figure.triangles)
    assert len(figure.positions) - len(directed) // 2 + len(figure.triangles) == 2
    used = set(np.unique(figure.joints[figure.weights > 0]))
    assert used <= set(clip.skeleton.roles.values())
    assert volume(figure.positions, figure.triangles) == pytest.approx(
        volume(whole.positions, whole.triangles), rel=0.05
    )


@pytest.mark.parametrize("role", ["head", "left_forearm", "right_foot"])
def test_a_body_cannot_do_without_its_limbs_and_says_which_is_missing(role):
    with pytest.raises(MotionError, match=role):
        build_figure(without_roles(sample_clip("adult"), role, role.partition("_")[2]))


def test_a_bowed_head_still_gets_a_level_gaze():
    clip = sample_clip("adult")
    head = clip.skeleton.roles["head"]
    rotations = clip.rotations.copy()
    bow = from_axis_angle(np.array([1.0, 0.0, 0.0]), np.radians(35.0))
    rotations[:, head] = multiply(rotations[:, head], bow)
    bowed = bind_pose(Clip(clip.skeleton, clip.root_positions, rotations, clip.frame_time))
    assert np.allclose(bowed.rotations[head], bind_pose(clip).rotations[head])


def test_a_clip_without_frames_has_no_body():
    clip = sample_clip("adult")
    empty = Clip(clip.skeleton, clip.root_positions[:0], clip.rotations[:0], clip.frame_time)
    with pytest.raises(MotionError, match="frame"):
        build_figure(empty)


def test_one_standing_frame_is_enough():
    clip = sample_clip("adult")
    still = Clip(clip.skeleton, clip.root_positions[:1], clip.rotations[:1], clip.frame_time)
    figure = build_figure(still)
    assert figure.stature == pytest.approx(figure_of(clip).stature, abs=0.04)


def test_the_shading_balls_fill_the_body_without_standing_out(figure, clip):
    whole = make_body(bind_pose(clip)).whole
    joints = [sphere.joint for sphere in figure.spheres]
    centres = figure.bind_positions[joints] + rotate(
        figure.bind_rotations[joints], np.array([sphere.centre for sphere in figure.spheres])
    )
    depth = -whole.distance(centres)
    radii = np.array([sphere.radius for sphere in figure.spheres])
    assert np.all(depth > 0.25 * radii)
    assert np.all(radii < depth + 0.03)


def test_creases_see_less_sky_than_the_crown(figure):
    crown = np.argmax(figure.positions[:, 1])
    assert figure.occlusion[crown] > 0.97
    assert figure.occlusion.min() < 0.6
    assert np.median(figure.occlusion) > 0.9


@pytest.mark.motions
def test_whatever_the_clip_one_skeleton_gets_one_body(motions_dir):
    """Bandai clips share a skeleton whose bones lie along ±x, mirrored left and right."""
    names = ("walk_normal", "walk_sad", "bow_normal", "bye_normal", "punch_normal", "walk_giant")
    files = [motions_dir / "bandai-namco" / f"{name}_001.bvh" for name in names]
    poses = [bind_pose(recorded_clip(file)) for file in files]
    for pose in poses[1:]:
        turned = angle_between(poses[0].rotations, pose.rotations)
        assert np.degrees(turned.max()) < 6.0


@pytest.mark.parametrize("emotion", ["angry", "sad", "afraid", "happy"])
def test_a_knocking_clip_gives_the_body_of_a_walking_one(emotion):
    walking, knocking = sample_clip("female"), walk_and_knock(emotion, BODIES["female"])
    turned = angle_between(bind_pose(walking).rotations, bind_pose(knocking).rotations)
    assert np.degrees(turned.max()) < 2.0
