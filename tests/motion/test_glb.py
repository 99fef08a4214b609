"""GLB files are valid, small, and mean to other programs what they mean to us."""

import gzip
import json
import shutil
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

from motion.clip import Clip
from motion.errors import MotionError
from motion.glb import write_clip_glb, write_figure_glb
from motion.kinematics import forward_kinematics
from motion.rotations import normalise
from motion.skeleton import Skeleton
from tests.support.figure_cases import (
    CASES,
    RECORDED,
    SAMPLE,
    figure_of,
    recorded_clip,
    sample_clip,
)

FRONT = Path(__file__).parents[1] / "front"


@pytest.fixture(
    scope="module",
    params=[pytest.param(c, marks=[pytest.mark.motions] if c in RECORDED else []) for c in CASES],
)
def clip(request):
    if request.param in SAMPLE:
        return sample_clip(request.param)
    return recorded_clip(request.getfixturevalue("motions_dir") / request.param)


def run_node(script, *arguments):
    node = shutil.which("node")
    assert node, "these tests need Node 20: `make test` brings it"
    done = subprocess.run(
        [node, str(FRONT / script), *map(str, arguments)], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def document(data):
    """The JSON and the numbers of a GLB file."""
    (length,) = struct.unpack_from("<I", data, 12)
    return json.loads(data[20 : 20 + length]), data[28 + length :]


def numbers(data, index):
    """Accessor number ``index``, as stored."""
    content, buffer = document(data)
    accessor = content["accessors"][index]
    kind = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5126: "<f4"}[
        accessor["componentType"]
    ]
    width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}[accessor["type"]]
    view = content["bufferViews"][accessor["bufferView"]]
    size = np.dtype(kind).itemsize
    start = view["byteOffset"] + accessor.get("byteOffset", 0)
    strides = (view.get("byteStride", size * width), size)
    return np.ndarray((accessor["count"], width), kind, buffer, start, strides)


def random_clip(frames=40, joints=7, seed=3):
    """A motion that turns wildly, so that quaternions change sign."""
    rng = np.random.default_rng(seed)
    parents = np.array([-1, *[int(rng.integers(0, j)) for j in range(1, joints)]])
    skeleton = Skeleton(
        tuple(f"joint {j}" for j in range(joints)), parents, rng.normal(scale=0.2, size=(joints, 3))
    )
    steps = np.cumsum(rng.normal(scale=0.2, size=(frames, joints, 4)), axis=0)
    rotations = normalise(steps + rng.normal(size=(joints, 4)))
    rotations *= rng.choice([-1.0, 1.0], size=(frames, joints, 1))
    return Clip(skeleton, np.cumsum(rng.normal(scale=0.02, size=(frames, 3)), 0), rotations, 0.01)


def three_reads(tmp_path, data, times=()):
    file = tmp_path / "read.glb"
    file.write_bytes(data)
    return run_node("gltf_read.mjs", file, *times)


def test_khronos_validator_finds_neither_error_nor_warning(clip, tmp_path):
    figure = figure_of(clip)
    contents = {
        "clip": write_clip_glb(clip),
        "figure": write_figure_glb(figure),
        "both": write_clip_glb(clip, figure=figure),
    }
    files = [tmp_path / f"{name}.glb" for name in contents]
    for file, data in zip(files, contents.values(), strict=True):
        file.write_bytes(data)
    for report in run_node("gltf_check.mjs", *files):
        assert report == {"errors": 0, "warnings": 0, "messages": []}


@pytest.mark.parametrize("with_figure", [False, True])
def test_three_puts_every_joint_where_our_kinematics_do(clip, with_figure, tmp_path):
    data = write_clip_glb(clip, figure=figure_of(clip) if with_figure else None)
    frames = np.unique(np.linspace(0, clip.frames - 1, 12).astype(int))
    read = three_reads(tmp_path, data, frames * clip.frame_time)
    expected = forward_kinematics(clip).positions[frames]
    assert np.abs(np.array(read["joints"]) - expected).max() < 0.001


def test_three_puts_every_joint_right_in_wild_motion(tmp_path):
    clip = random_clip()
    read = three_reads(tmp_path, write_clip_glb(clip), np.arange(clip.frames) * clip.frame_time)
    expected = forward_kinematics(clip).positions
    assert np.abs(np.array(read["joints"]) - expected).max() < 0.001


def test_three_shows_the_resting_skin_standing_on_the_floor(clip, tmp_path):
    figure = figure_of(clip)
    skin = np.array(three_reads(tmp_path, write_figure_glb(figure))["skin"])
    assert np.abs(skin - figure.positions - [0.0, -figure.floor, 0.0]).max() < 0.001
    assert abs(skin[:, 1].min()) < 0.002


def test_the_compressed_body_stays_within_its_limit(clip):
    assert len(gzip.compress(write_figure_glb(figure_of(clip)), 6)) <= 150_000


def test_quantised_weights_still_sum_to_one():
    data = write_figure_glb(figure_of(sample_clip("female")))
    primitive = document(data)[0]["meshes"][0]["primitives"][0]
    weights = numbers(data, primitive["attributes"]["WEIGHTS_0"]).astype(int)
    assert np.all(weights.sum(axis=1) == 255)


def test_no_rotation_takes_the_long_way_round():
    data = write_clip_glb(random_clip())
    content, _ = document(data)
    for sampler in content["animations"][0]["samplers"][1:]:
        turns = numbers(data, sampler["output"]).astype(float)
        assert np.all(np.sum(turns[1:] * turns[:-1], axis=1) >= 0.0)


def test_the_extras_tell_what_the_clip_is():
    clip = sample_clip("male")
    extras = document(write_clip_glb(clip))[0]["asset"]["extras"]["manner"]
    assert extras == {
        "skeleton": clip.skeleton.content_hash,
        "roles": {role: clip.skeleton.names[joint] for role, joint in clip.skeleton.roles.items()},
        "frame_time": clip.frame_time,
        "frames": clip.frames,
        "cyclic": True,
        "names": list(clip.skeleton.names),
    }


def test_the_figures_extras_name_joints_that_the_clip_has():
    clip = sample_clip("male")
    extras = document(write_figure_glb(figure_of(clip)))[0]["asset"]["extras"]["manner"]
    named = {item["node"] for item in extras["spheres"] + extras["soles"]} | set(extras["limbs"])
    assert named <= set(clip.skeleton.names)
    assert {sphere["limb"] for sphere in extras["spheres"]} == {
        "torso",
        "head",
        "left_arm",
        "right_arm",
        "left_leg",
        "right_leg",
    }
    assert extras["stature"] == pytest.approx(1.79, abs=0.03)


def test_body_and_clip_of_different_skeletons_do_not_mix():
    with pytest.raises(MotionError, match="another skeleton"):
        write_clip_glb(sample_clip("male"), figure=figure_of(sample_clip("female")))


def test_a_clip_without_frames_is_refused():
    clip = random_clip()
    empty = Clip(clip.skeleton, clip.root_positions[:0], clip.rotations[:0], clip.frame_time)
    with pytest.raises(MotionError, match="at least one"):
        write_clip_glb(empty)


def test_one_frame_makes_a_file_that_three_reads(tmp_path):
    clip = random_clip(frames=1)
    read = three_reads(tmp_path, write_clip_glb(clip), [0.0])
    assert np.abs(np.array(read["joints"]) - forward_kinematics(clip).positions).max() < 0.001
