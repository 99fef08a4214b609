"""What recipes do to clips: nothing at no amount, the same bits again, feet that stand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from motion import MotionError
from motion.editing.foot_plants import find_feet
from motion.editing.grid import nine_motions
from motion.editing.path_length import PathLength, change_path_length
from motion.editing.posture import PostureOffset, add_posture, capture_pose
from motion.editing.tempo import change_tempo
from motion.errors import RecipeError
from motion.ingest import IngestOptions, ingest
from motion.kinematics import forward_kinematics
from motion.procedural.stances import stance
from motion.recipe import MAX_FRAMES, OPERATIONS, PRESETS, Materials, Recipe
from motion.rotations import angle_between
from tests.motion.recipe.strategies import CYCLE, OTHER_CYCLE, POSE, SHORT

# One example of every operation, with a clear effect.
EXAMPLES = {
    "grid@1": {"path": 1.5, "timing": 1.5},
    "posture@1": {"offsets": [{"pose": "head_down"}, {"pose": POSE, "amount": 0.3}]},
    "path_length@1": {"gain": 1.3},
    "bands@1": {"gains": [{"frequency": 0.4}, {"frequency": 1.0, "gain": 1.4}]},
    "timing@1": {"kind": "added"},
    "contacts@1": {"amount": 0.5},
    "vary@1": {"path": 0.5, "rhythm": 0.3, "seed": 5},
    "tempo@1": {"factor": 1.3},
    "resample@1": {"rate": 24},
    "cut@1": {"start": 0.2, "end": 0.8},
    "repair_feet@1": {},
    "warp@1": {"keyframes": [{"time": 0.4, "turns": [{"role": "head", "x": 20}], "up": 0.1}]},
    "warp_time@1": {"moments": [{"was": 0.4, "shall": 0.5}]},
    "waveshape@1": {"limits": [{"role": "left_forearm", "axis": "x", "low": -20, "high": 20}]},
    "fourier@1": {"clip": OTHER_CYCLE, "amount": 0.5},
    "emotion@1": {"neutral": CYCLE, "emotional": OTHER_CYCLE, "amount": 0.5},
    "blend@1": {"examples": [{"clip": CYCLE, "weight": 1}, {"clip": OTHER_CYCLE, "weight": 0.5}]},
    "cycle@1": {"start": 0.1, "end": 0.9},
    "retarget@1": {"clip": CYCLE},
}
# Which have no amount.
SETTINGS = {"resample@1", "cut@1", "repair_feet@1", "blend@1", "cycle@1", "retarget@1"}


def recipe(*keys):
    return Recipe.parse([{"operation": key, "parameters": EXAMPLES[key]} for key in keys])


def one(operation, **parameters):
    return Recipe.parse([{"operation": operation, "parameters": parameters}])


def outcome(recipe, clip, materials):
    """The edited clip, or the error."""
    try:
        return recipe.apply(clip, materials)
    except RecipeError as error:
        return error


def largest_slip(clip, plants_of):
    """m: how far any planted sole point moves on the floor within a plant."""
    pose, slips = forward_kinematics(clip), [0.0]
    for foot in find_feet(plants_of):
        for point, planted in zip(foot.points, foot.planted, strict=True):
            level = point.positions(pose)[:, [0, 2]]
            edges = np.flatnonzero(np.diff(np.r_[0, planted.astype(int), 0]))
            for start, stop in edges.reshape(-1, 2):
                slips.append(np.linalg.norm(level[start:stop] - level[start], axis=1).max())
    return max(slips)


def test_there_is_an_example_of_every_operation():
    assert list(EXAMPLES) == list(OPERATIONS)


def test_no_steps_change_nothing(short):
    assert Recipe.parse([]).apply(short) is short


@pytest.mark.parametrize("key", EXAMPLES)
def test_every_operation_gives_the_same_bits_again(key, short, cycle, materials):
    source = cycle if key in ("fourier@1", "blend@1") else short
    first = recipe(key).apply(source, materials)
    again = Recipe.parse(recipe(key).to_list()).apply(source, materials)
    assert first.content_hash == again.content_hash
    if key != "repair_feet@1":
        assert first.content_hash != source.content_hash


@pytest.mark.parametrize("key", [key for key in EXAMPLES if key not in SETTINGS])
def test_eased_off_to_nothing_every_operation_does_nothing(key, short, cycle, materials):
    source = cycle if key in ("fourier@1", "blend@1") else short
    assert recipe(key).eased(0.0).apply(source, materials).content_hash == source.content_hash


@pytest.mark.parametrize("key", EXAMPLES)
def test_eased_off_by_nothing_a_recipe_is_the_same(key):
    assert recipe(key).eased(1.0).hash == recipe(key).hash


def test_an_eased_recipe_lies_between():
    steps = [
        {"operation": "grid@1", "parameters": {"path": 2, "timing": 0}},
        {"operation": "posture@1", "parameters": {"offsets": [{"pose": "head_down"}]}},
        {"operation": "cut@1", "parameters": {"start": 1, "end": 2}},
    ]
    grid, posture, cut = (s["parameters"] for s in Recipe.parse(steps).eased(0.25).to_list())
    assert (grid["path"], grid["timing"]) == (1.25, 0.75)
    assert posture["offsets"][0]["amount"] == 0.25
    assert cut == {"start": 1.0, "end": 2.0}


def test_the_grid_gives_the_nine_motions(knocking):
    edited = one("grid@1", path=2, timing=2).apply(knocking)
    assert edited.content_hash == nine_motions(knocking).at(2, 2).content_hash


def test_a_recipe_is_its_steps_one_after_the_other(knocking):
    steps = [
        {"operation": "path_length@1", "parameters": {"gain": 0.7}},
        {"operation": "tempo@1", "parameters": {"factor": 1.5}},
    ]
    first, second = (Recipe.parse([step]) for step in steps)
    expected = second.apply(first.apply(knocking))
    assert Recipe.parse(steps).apply(knocking).content_hash == expected.content_hash


def test_offsets_of_one_step_add_up_in_any_order(knocking):
    offsets = [{"pose": "head_down", "amount": 0.7}, {"pose": "elbows_away"}]
    edited = one("posture@1", offsets=offsets).apply(knocking)
    other = one("posture@1", offsets=offsets[::-1]).apply(knocking)
    expected = add_posture(
        knocking,
        [
            (PostureOffset.between(stance("neutral"), stance(name)), amount)
            for name, amount in (("head_down", 0.7), ("elbows_away", 1.0))
        ],
    )
    np.testing.assert_allclose(edited.rotations, expected.rotations, atol=1e-12)
    np.testing.assert_allclose(edited.rotations, other.rotations, atol=1e-12)


def test_a_captured_pose_is_met_like_a_stance(knocking):
    poses = {"c" * 64: capture_pose(knocking, 200), "d" * 64: capture_pose(knocking, 0)}
    offsets = [{"pose": "c" * 64, "neutral": "d" * 64, "amount": 0.0}]
    assert one("posture@1", offsets=offsets).apply(knocking, Materials(poses)) is knocking
    keyed = one("warp@1", keyframes=[{"time": 100 * knocking.frame_time, "pose": "c" * 64}])
    edited = keyed.apply(knocking, Materials(poses))
    met, wanted = capture_pose(edited, 100), poses["c" * 64]
    for role in ("head", "left_forearm", "right_upper_arm", "chest"):
        assert abs(np.dot(met[role], wanted[role])) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize(
    ("operation", "parameters"),
    [
        ("path_length@1", {"gain": 1.5}),
        ("path_length@1", {"gain": 0.5}),
        ("bands@1", {"gains": [{"frequency": 0.4}, {"frequency": 1.0, "gain": 1.5}]}),
        ("posture@1", {"offsets": [{"pose": "hands_away_and_feet_apart"}]}),
        ("warp@1", {"keyframes": [{"time": 1.2, "turns": [{"role": "left_thigh", "x": -15}]}]}),
        ("vary@1", {"path": 0.8}),
        ("waveshape@1", {"limits": [{"role": "left_shin", "axis": "x", "low": -40, "high": 40}]}),
    ],
)
def test_feet_stand_after_an_operation_that_moves_legs(knocking, operation, parameters):
    edited = one(operation, **parameters).apply(knocking)
    assert edited.content_hash != knocking.content_hash
    assert largest_slip(edited, knocking) <= max(0.005, largest_slip(knocking, knocking))


def test_without_repair_those_feet_would_slide(knocking):
    bare = change_path_length(knocking, PathLength(1.5))
    assert largest_slip(bare, knocking) > 0.02


def test_feet_of_a_body_that_stays_in_place_stand_after_new_timing(samples):
    bow = samples["bow"]
    for edit in (one("grid@1", timing=0), one("timing@1", kind="even")):
        edited = edit.apply(bow)
        assert edited.content_hash != bow.content_hash
        assert largest_slip(edited, bow) <= 0.005


def test_posture_of_head_and_arms_leaves_the_legs(knocking):
    edited = one("posture@1", offsets=[{"pose": "elbows_away"}]).apply(knocking)
    legs = [knocking.skeleton.roles[role] for role in ("left_thigh", "right_foot", "hips")]
    np.testing.assert_array_equal(edited.rotations[:, legs], knocking.rotations[:, legs])
    np.testing.assert_array_equal(edited.root_positions, knocking.root_positions)


@pytest.mark.motions
def test_two_bows_in_two_steps_are_twice_as_deep(motions_dir):
    """However deep the head hangs after the first, the second knows where forward is."""
    clip = ingest(
        (motions_dir / "bandai-namco" / "walk_sad_001.bvh").read_bytes(), IngestOptions()
    ).clip
    half = {"pose": "head_down", "amount": 0.5}
    twice = [{"operation": "posture@1", "parameters": {"offsets": [half]}}] * 2
    once = one("posture@1", offsets=[{"pose": "head_down", "amount": 1.0}]).apply(clip)
    again = Recipe.parse(twice).apply(clip)
    head = clip.skeleton.roles["head"]
    turns = [forward_kinematics(c).rotations[:, head] for c in (clip, once, again)]
    deep, deeper = (np.degrees(angle_between(turns[0], turn)) for turn in turns[1:])
    assert deep.mean() > 30
    np.testing.assert_allclose(deeper, deep, atol=4)


def test_repair_follows_the_time_of_the_steps_before(knocking):
    steps = [
        {"operation": "tempo@1", "parameters": {"factor": 0.8}},
        {"operation": "repair_feet@1"},
    ]
    edited = Recipe.parse(steps).apply(knocking)
    assert largest_slip(edited, change_tempo(knocking, 0.8)) <= 0.005


def test_the_unedited_motion_has_the_recipe_s_time(knocking, materials):
    done = recipe("grid@1", "tempo@1", "cut@1", "emotion@1", "posture@1")
    edited, unedited = done.apply(knocking, materials), done.unedited(knocking, materials)
    assert (edited.frames, edited.frame_time) == (unedited.frames, unedited.frame_time)
    timeless = recipe("grid@1", "posture@1", "path_length@1", "contacts@1")
    assert timeless.unedited(knocking, materials) is knocking


def test_a_missing_pose_or_clip_is_named_before_anything_is_done(short, materials):
    for key, kind, name in (("posture@1", "pose", POSE), ("emotion@1", "clip", CYCLE)):
        with pytest.raises(RecipeError, match=name) as raised:
            recipe("tempo@1", key).apply(short)
        assert raised.value.where == (1, "parameters")
        assert kind in raised.value.message
    assert recipe("emotion@1").apply(short, materials).frames > 2


@pytest.mark.parametrize("key", EXAMPLES)
def test_a_body_whose_joints_are_unknown_gives_a_clear_error_or_an_edit(
    key, incomplete, cycle, materials
):
    found = outcome(recipe(key), incomplete, materials)
    if isinstance(found, RecipeError):
        assert found.where == (0,)
        assert "No joint is the" in str(found) or "different ones" in str(found)
    else:
        assert np.isfinite(found.rotations).all()


def test_a_result_that_would_be_too_long_is_refused_before_it_is_made(short, monkeypatch):
    assert MAX_FRAMES == 200_000
    monkeypatch.setattr("motion.recipe.operation.MAX_FRAMES", 900)
    slow = Recipe.parse([{"operation": "tempo@1", "parameters": {"factor": 0.25}}] * 3)
    with pytest.raises(RecipeError, match="at most 900") as raised:
        slow.apply(short)
    assert raised.value.where == (1,)
    with pytest.raises(RecipeError, match="at most 900"):
        one("resample@1", rate=240).apply(one("tempo@1", factor=0.25).apply(short))


def test_an_edit_that_does_not_fit_the_clip_tells_its_step(knocking):
    with pytest.raises(RecipeError, match=r"Step 2, cut") as raised:
        Recipe.parse(
            [{"operation": "grid@1"}, {"operation": "cut@1", "parameters": {"start": 30}}]
        ).apply(knocking)
    assert raised.value.where == (1,)
    assert isinstance(raised.value, MotionError)


@pytest.mark.parametrize("frames", [1, 2, 3])
@pytest.mark.parametrize("key", EXAMPLES)
def test_the_shortest_clips_are_edited_or_refused(key, frames, short, materials):
    tiny = replace(
        short,
        root_positions=short.root_positions[:frames].copy(),
        rotations=short.rotations[:frames].copy(),
    )
    found = outcome(recipe(key), tiny, materials)
    if isinstance(found, RecipeError):
        assert found.where == (0,)
    else:
        assert np.isfinite(found.root_positions).all()


@pytest.mark.parametrize(
    "key", ["grid@1", "posture@1", "path_length@1", "vary@1", "tempo@1", "fourier@1"]
)
def test_a_cycle_stays_a_cycle(key, cycle, materials):
    edited = recipe(key).apply(cycle, materials)
    assert edited.cyclic
    around_root = forward_kinematics(edited).positions - edited.root_positions[:, None]
    np.testing.assert_allclose(around_root[-1], around_root[0], atol=1e-6)


@pytest.mark.parametrize("name", PRESETS)
def test_presets_are_done_to_the_same_bits(name, cycle):
    first = PRESETS[name].operations.apply(cycle)
    again = Recipe.parse(PRESETS[name].operations.to_list()).apply(cycle)
    assert first.content_hash == again.content_hash


def test_short_is_no_cycle(short, materials):
    with pytest.raises(RecipeError, match="cyclic"):
        one("fourier@1", clip=SHORT).apply(short, materials)
