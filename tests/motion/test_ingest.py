"""Foreign motion arrives in metres, upright, on the floor, facing +z, with its body known."""

import json

import numpy as np
import pytest

from motion.body import REQUIRED, ROLES, sole_heights
from motion.errors import MotionError
from motion.ingest import IngestOptions, ingest
from motion.kinematics import forward_kinematics
from motion.storage import clip_from_bytes, clip_to_bytes
from motion.units import heading
from tests.support.bvh_files import PERSON, person

NEUTRAL = {name: f"part{number}" for number, (name, _, _) in enumerate(PERSON)}


def turned(data, degrees):
    """The person turned about the vertical by its root's rotation."""
    lines = data.decode().splitlines()
    start = next(n for n, line in enumerate(lines) if line.startswith("Frame Time")) + 1
    for number in range(start, len(lines)):
        values = lines[number].split()
        values[5] = str(degrees)
        lines[number] = " ".join(values)
    return "\n".join(lines).encode()


@pytest.mark.parametrize("degrees", [0, 30, -90, 179, -179])
def test_facing_is_found_and_turned_to_z(degrees):
    result = ingest(turned(person(), degrees))
    assert result.report.heading == pytest.approx(np.radians(degrees), abs=1e-9)
    pose = forward_kinematics(result.clip)
    assert heading(pose, result.clip.skeleton.roles) == pytest.approx(0, abs=1e-9)
    toes, foot = (result.clip.skeleton.roles[f"left_{part}"] for part in ("toes", "foot"))
    assert (pose.positions[:, toes] - pose.positions[:, foot])[:, 2].min() > 0.1
    left, right = (result.clip.skeleton.roles[f"{side}_hand"] for side in ("left", "right"))
    assert (pose.positions[:, left] - pose.positions[:, right])[:, 0].min() > 1


def test_the_clip_starts_over_the_origin_and_keeps_a_floor_that_the_soles_touch():
    result = ingest(person())
    assert result.clip.root_positions[0] == pytest.approx([0, 0.94, 0])
    assert abs(result.report.lowest_foot) < 0.03


def test_a_figure_that_hangs_below_its_floor_is_lifted_onto_it():
    result = ingest(person().replace(b"5.000000 94.000000", b"5.000000 0.000000"))
    assert result.report.lowest_foot == pytest.approx(0, abs=1e-9)
    soles = sole_heights(
        forward_kinematics(result.clip), result.clip.skeleton, result.report.stature
    )
    assert abs(soles.min()) < 2e-3


def test_ingesting_what_was_ingested_changes_nothing():
    from motion.bvh import write_bvh

    first = ingest(turned(person(5, bend=2.0), 40)).clip
    again = ingest(write_bvh(first)).clip
    assert again.skeleton.roles == first.skeleton.roles
    a, b = forward_kinematics(first).positions, forward_kinematics(again).positions
    assert np.abs(a - b).max() < 1e-4


def test_the_report_is_plain_data():
    report = ingest(person()).report
    data = json.loads(json.dumps(report.to_dict()))
    assert data["roles"]["left_forearm"] == "LeftForeArm"
    assert data["frames"] == 3
    assert data["questions"][0]["offer"] == "unit"


def test_roles_can_be_given_by_joint_name():
    options = IngestOptions(roles={"left_hand": "", "chest": "Spine"})
    report = ingest(person(), options).report
    assert "left_hand" not in report.roles
    assert report.roles["chest"] == "Spine"
    assert "left_hand" in report.missing_roles


@pytest.mark.parametrize(
    ("options", "match"),
    [
        (IngestOptions(roles={"tail": "Spine"}), "no body role “tail”"),
        (IngestOptions(roles={"chest": "Nobody"}), "no joint “Nobody”"),
        (IngestOptions(up_axis="w"), "up axis must be one of"),
        (IngestOptions(unit=-1.0), "unit must be above 0"),
        (IngestOptions(root=3), "no number 3"),
        (IngestOptions(frame_time=0.0), "frame time must be above 0"),
    ],
)
def test_options_that_do_not_fit_are_refused_in_words(options, match):
    with pytest.raises(MotionError, match=match):
        ingest(person(), options)


@pytest.mark.motions
def test_every_real_file_becomes_a_person_on_the_floor(motions_dir):
    paths = sorted(motions_dir.glob("*/*.bvh"))
    assert paths
    for path in paths:
        result = ingest(path.read_bytes())
        report, pose = result.report, forward_kinematics(result.clip)
        assert 1.4 < report.stature < 2.0, path.name
        soles = sole_heights(pose, result.clip.skeleton, report.stature)
        assert abs(soles.min()) < 0.03, path.name
        assert report.missing_roles == (), path.name
        assert report.bake_error < 1e-3, path.name
        assert clip_from_bytes(clip_to_bytes(result.clip)).content_hash == result.clip.content_hash


@pytest.mark.motions
def test_real_walks_and_runs_go_where_they_face(motions_dir):
    for path in sorted(motions_dir.glob("bandai-namco/[wr][au][ln]*.bvh")):
        travel = ingest(path.read_bytes()).clip.travel
        assert travel[2] > 1.5, path.name
        assert abs(travel[0]) < 0.2 * travel[2], path.name


@pytest.mark.motions
def test_real_roles_are_the_joints_that_a_person_would_name(motions_dir):
    bandai = ingest((motions_dir / "bandai-namco/walk_sad_001.bvh").read_bytes()).report.roles
    assert bandai == {
        "hips": "Hips", "spine": "Spine", "chest": "Chest", "neck": "Neck", "head": "Head",
        **{f"{side}_{role}": f"{name}_{side[0].upper()}"
           for side in ("left", "right")
           for role, name in {
               "clavicle": "Shoulder", "upper_arm": "UpperArm", "forearm": "LowerArm",
               "hand": "Hand", "thigh": "UpperLeg", "shin": "LowerLeg", "foot": "Foot",
               "toes": "Toes"}.items()},
    }  # fmt: skip
    cmu = ingest((motions_dir / "cmu/12_01_walk.bvh").read_bytes()).report.roles
    assert cmu["left_thigh"] == "LeftUpLeg"  # not LHipJoint, which has no length
    assert cmu["chest"] == "Spine1"
    assert cmu["spine"] == "Spine"
    assert set(cmu) == set(ROLES)
    other = ingest((motions_dir / "cmu/131_01_start_walk_stop.bvh").read_bytes()).report.roles
    assert other["left_thigh"] == "LeftHip"
    assert other["right_upper_arm"] == "RightShoulder"
    assert other["chest"] == "Chest2"


@pytest.mark.motions
def test_a_real_calibration_pose_is_asked_about(motions_dir):
    report = ingest((motions_dir / "cmu/12_01_walk.bvh").read_bytes()).report
    assert any(note.offer == "drop_first_frame" for note in report.questions)


@pytest.mark.motions
def test_real_bodies_are_told_by_shape_alone(motions_dir):
    """Names scrambled, every required role lands on the joint that the names gave."""
    paths = [
        *sorted(motions_dir.glob("bandai-namco/*_normal_001.bvh")),
        *sorted(motions_dir.glob("cmu/*.bvh")),
    ]
    for path in paths:
        named = ingest(path.read_bytes())
        scrambled = ingest(_scramble(path.read_bytes()))
        for role in REQUIRED:
            expected = named.clip.skeleton.roles[role]
            found = scrambled.clip.skeleton.roles[role]
            assert found == expected, (path.name, role, scrambled.report.roles)
        assert any("its shape did" in note.text for note in scrambled.report.questions)


def _scramble(data):
    lines = []
    for number, line in enumerate(data.decode().splitlines()):
        word = line.split()[0] if line.split() else ""
        lines.append(f"{word} q{number}x" if word in ("ROOT", "JOINT") else line)
    return "\n".join(lines).encode()


def test_a_body_without_telling_names_is_told_by_its_shape():
    result = ingest(person(names=NEUTRAL))
    expected = {role: NEUTRAL[name] for role, name in ingest(person()).report.roles.items()}
    assert result.report.roles == expected
    assert any("its shape did" in note.text for note in result.report.questions)
