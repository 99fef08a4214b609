"""Body roles in the naming conventions of common programs."""

import numpy as np
import pytest

from motion.body import REQUIRED, ROLES
from motion.ingest import ingest
from tests.support.bvh_files import PERSON, person

# Our person's joints as other programs call them; left ones, the right ones follow by "swap".
CONVENTIONS = {
    "mixamo": {
        "LeftShoulder": "mixamorig:LeftShoulder", "LeftArm": "mixamorig:LeftArm",
        "LeftForeArm": "mixamorig:LeftForeArm", "LeftHand": "mixamorig:LeftHand",
        "LeftUpLeg": "mixamorig:LeftUpLeg", "LeftLeg": "mixamorig:LeftLeg",
        "LeftFoot": "mixamorig:LeftFoot", "LeftToeBase": "mixamorig:LeftToeBase",
        "Hips": "mixamorig:Hips", "Neck": "mixamorig:Neck", "Head": "mixamorig:Head",
    },
    "bandai": {
        "LeftShoulder": "Shoulder_L", "LeftArm": "UpperArm_L", "LeftForeArm": "LowerArm_L",
        "LeftHand": "Hand_L", "LeftUpLeg": "UpperLeg_L", "LeftLeg": "LowerLeg_L",
        "LeftFoot": "Foot_L", "LeftToeBase": "Toes_L",
    },
    "xsens": {
        "LeftShoulder": "LeftCollar", "LeftArm": "LeftShoulder", "LeftForeArm": "LeftElbow",
        "LeftHand": "LeftWrist", "LeftUpLeg": "LeftHip", "LeftLeg": "LeftKnee",
        "LeftFoot": "LeftAnkle", "LeftToeBase": "LeftToe", "Spine": "Chest", "Chest": "Chest2",
    },
    "rokoko": {
        "LeftUpLeg": "LeftThigh", "LeftLeg": "LeftShin", "LeftToeBase": "LeftToe",
    },
    "daz": {
        "Hips": "hip", "Spine": "abdomen", "Chest": "chest", "Neck": "neck", "Head": "head",
        "LeftShoulder": "lCollar", "LeftArm": "lShldr", "LeftForeArm": "lForeArm",
        "LeftHand": "lHand", "LeftUpLeg": "lThigh", "LeftLeg": "lShin", "LeftFoot": "lFoot",
        "LeftToeBase": "lToe",
    },
    "blender": {
        "Hips": "hips", "Spine": "spine", "Neck": "neck", "Head": "head",
        "LeftShoulder": "shoulder.L", "LeftArm": "upper_arm.L", "LeftForeArm": "forearm.L",
        "LeftHand": "hand.L", "LeftUpLeg": "thigh.L", "LeftLeg": "shin.L", "LeftFoot": "foot.L",
        "LeftToeBase": "toe.L",
    },
    "unreal": {
        "Hips": "pelvis", "Spine": "spine_01", "Chest": "spine_02", "Neck": "neck_01",
        "Head": "head", "LeftShoulder": "clavicle_l", "LeftArm": "upperarm_l",
        "LeftForeArm": "lowerarm_l", "LeftHand": "hand_l", "LeftUpLeg": "thigh_l",
        "LeftLeg": "calf_l", "LeftFoot": "foot_l", "LeftToeBase": "ball_l",
    },
    "biped": {
        "Hips": "Bip01 Pelvis", "Spine": "Bip01 Spine", "Chest": "Bip01 Spine1",
        "Neck": "Bip01 Neck", "Head": "Bip01 Head", "LeftShoulder": "Bip01 L Clavicle",
        "LeftArm": "Bip01 L UpperArm", "LeftForeArm": "Bip01 L Forearm",
        "LeftHand": "Bip01 L Hand", "LeftUpLeg": "Bip01 L Thigh", "LeftLeg": "Bip01 L Calf",
        "LeftFoot": "Bip01 L Foot", "LeftToeBase": "Bip01 L Toe0",
    },
    "smpl": {
        "Hips": "Pelvis", "Spine": "Spine1", "Chest": "Spine3", "LeftShoulder": "L_Collar",
        "LeftArm": "L_Shoulder", "LeftForeArm": "L_Elbow", "LeftHand": "L_Wrist",
        "LeftUpLeg": "L_Hip", "LeftLeg": "L_Knee", "LeftFoot": "L_Ankle", "LeftToeBase": "L_Foot",
    },
    "lower case": {
        "Hips": "hips", "LeftShoulder": "lclavicle", "LeftArm": "lupperarm",
        "LeftForeArm": "lforearm", "LeftHand": "lhand", "LeftUpLeg": "leftupleg",
        "LeftLeg": "leftleg", "LeftFoot": "leftfoot", "LeftToeBase": "lefttoe",
    },
}  # fmt: skip

SWAPS = {
    "bandai": ("_L", "_R"), "blender": (".L", ".R"), "unreal": ("_l", "_r"),
    "biped": (" L ", " R "), "smpl": ("L_", "R_"),
}  # fmt: skip


def both_sides(convention):
    names = dict(CONVENTIONS[convention])
    for joint, name in CONVENTIONS[convention].items():
        if not joint.startswith("Left"):
            continue
        if convention in SWAPS:
            other = name.replace(*SWAPS[convention])
        elif "Left" in name or "left" in name:
            other = name.replace("Left", "Right").replace("left", "right")
        else:
            other = "r" + name[1:]
        names[joint.replace("Left", "Right")] = other
    return names


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_names_tell_every_role(convention):
    names = both_sides(convention)
    report = ingest(person(names=names)).report
    plain = ingest(person()).report
    assert report.roles == {role: names.get(name, name) for role, name in plain.roles.items()}
    assert set(report.roles) == set(ROLES)
    assert [note.offer for note in report.questions] == ["unit"]


def test_every_required_role_is_a_role():
    assert set(REQUIRED) < set(ROLES)
    assert len(set(ROLES)) == len(ROLES)


def test_what_is_named_left_but_lies_on_the_right_is_asked_about():
    swapped = {
        name: name.replace("Left", "@").replace("Right", "Left").replace("@", "Right")
        for name, _, _ in PERSON
    }
    questions = ingest(person(names=swapped)).report.questions
    assert "What the names call left lies on the body's right" in [note.text for note in questions]


def test_without_toes_the_knees_tell_front_from_back():
    names = {name: f"part{number}" for number, (name, _, _) in enumerate(PERSON)}
    text = person(names=names).decode()
    for foot in ("LeftToeBase", "RightToeBase"):
        channels = "CHANNELS 3 Zrotation Xrotation Yrotation"
        block = f"JOINT {names[foot]}\n{{\nOFFSET 0 -5 14\n{channels}\n}}\n"
        assert block in text
        text = text.replace(block, "")
    lines = []
    for line in text.replace("OFFSET 0 -42 0", "OFFSET 0 -42 3").splitlines():
        values = line.split()
        moving = len(values) == 66
        lines.append(" ".join(values[:51] + values[54:63]) if moving else line)
    roles = ingest("\n".join(lines).encode()).report.roles
    assert roles["left_shin"] == names["LeftLeg"]
    assert "left_toes" not in roles


def test_a_skeleton_that_is_no_body_gets_no_roles_and_says_which_are_missing():
    text = b"HIERARCHY\nROOT a\n{ OFFSET 0 0 0 CHANNELS 3 Xrotation Yrotation Zrotation\n}\n"
    report = ingest(text + b"MOTION\nFrames: 1\nFrame Time: 1\n1 2 3\n").report
    assert report.roles == {}
    assert report.missing_roles[: len(REQUIRED)] == REQUIRED
    assert np.isfinite(report.stature)
