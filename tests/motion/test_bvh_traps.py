"""What BVH files in the wild do: each is repaired and reported, or refused with its place."""

import numpy as np
import pytest

from motion.bvh import read_bvh
from motion.errors import BvhSyntaxError
from motion.ingest import IngestOptions, ingest
from motion.kinematics import forward_kinematics
from tests.support.bvh_files import TWO_JOINTS, motion_text, person, two_joints

ROW = "1 2 3 4 5 6 7 8 9"
VALUES = np.arange(1.0, 10.0)


def texts(notes):
    return " | ".join(note.text for note in notes)


def placed(*rows, hips="0 90 0"):
    """A still root, hips that travel, and a knee whose position channels the rows give."""
    hierarchy = """HIERARCHY
ROOT World
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Hips
  {
    OFFSET 0 93 -3
    CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
    JOINT Knee
    {
      OFFSET 0 -44 0
      CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
      JOINT Ankle
      {
        OFFSET 0 -40 0
        CHANNELS 3 Zrotation Xrotation Yrotation
      }
    }
  }
}
"""
    lines = [f"0 0 0 0 0 0 {hips} 0 0 0 {row} 0 0 0 0 0 0" for row in rows]
    return (hierarchy + motion_text(lines)).encode()


# Position channels beyond the root


def test_position_channels_replace_the_offset_and_constant_ones_fold_into_it():
    data = placed("0 -46 0", "0 -46 0").decode().replace("0 90 0", "0 90 5", 1)
    result = ingest(data.encode(), IngestOptions(unit=0.01))
    knee = result.clip.skeleton.names.index("Knee")
    assert result.clip.skeleton.offsets[knee] == pytest.approx([0, -0.46, 0])
    assert "Position channels replace the offsets of 1 joint" in texts(result.report.repairs)
    assert "Constant positions folded into the skeleton" in texts(result.report.repairs)


def test_a_still_root_above_moving_hips_is_merged_into_them():
    data = placed("0 -44 0", "0 -44 0").decode().replace("0 90 0", "0 90 50", 1)
    result = ingest(data.encode(), IngestOptions(unit=0.01, up_axis="y"))
    assert result.clip.skeleton.names == ("Hips", "Knee", "Ankle")
    assert np.linalg.norm(result.clip.travel) == pytest.approx(0.5)
    assert "“World” above the moving “Hips” was merged" in texts(result.report.repairs)


def test_other_moving_positions_are_baked_into_rotations_and_the_error_is_reported():
    swing = [f"{30 * np.sin(a)} {-44 * np.cos(a)} 0" for a in np.linspace(-0.3, 0.3, 9)]
    rows = placed(*swing).decode().splitlines()
    rows = [row.replace("0 90 0", f"0 90 {number}", 1) for number, row in enumerate(rows)]
    result = ingest("\n".join(rows).encode(), IngestOptions(unit=0.01, up_axis="y"))
    assert "Moving positions of Knee turned into rotations" in texts(result.report.repairs)
    lengths = [np.hypot(*[float(v) for v in step.split()[:2]]) for step in swing]
    assert result.report.bake_error > 0
    assert result.report.bake_error == pytest.approx(
        max(abs(np.array(lengths) - np.median(lengths))) / 100, rel=0.05
    )


def test_a_root_position_replaces_the_root_offset_and_is_noted():
    data = two_joints("1 2 3 0 0 0 0 0 0").replace(b"OFFSET 0 0 0", b"OFFSET 7 8 9", 1)
    result = ingest(data, IngestOptions(unit=1.0, up_axis="y"))
    assert "replace the OFFSET of “Hips”" in texts(result.report.repairs)
    knee = forward_kinematics(result.clip).positions[0, 1]
    assert np.linalg.norm(knee - result.clip.root_positions[0]) == pytest.approx(45)


# Channels


def test_each_joint_keeps_its_own_rotation_order_and_rotations_may_come_before_positions():
    text = TWO_JOINTS.replace(
        "6 Xposition Yposition Zposition Zrotation Xrotation Yrotation",
        "6 Yrotation Zrotation Xrotation Zposition Xposition Yposition",
        1,
    )
    file = read_bvh((text + motion_text(["90 0 0 3 1 2 0 0 90"])).encode())
    assert file.joints[0].channels[:3] == ("Yrotation", "Zrotation", "Xrotation")
    assert file.joints[1].channels == ("Zrotation", "Xrotation", "Yrotation")
    result = ingest((text + motion_text(["90 0 0 3 1 2 0 0 90"])).encode(), IngestOptions(unit=1.0))
    half = np.sqrt(0.5)
    assert np.abs(result.clip.rotations[0, 0]) == pytest.approx([half, 0, half, 0])


def test_joints_may_have_no_one_or_two_channels():
    text = TWO_JOINTS.replace("CHANNELS 3 Zrotation Xrotation Yrotation", "CHANNELS 1 Yrotation")
    text = text.replace("6 Xposition Yposition Zposition Zrotation", "3", 1).replace(
        "3 Xrotation Yrotation", "2 Xrotation Yrotation"
    )
    file = read_bvh((text + motion_text(["1 2 3"])).encode())
    assert [len(joint.channels) for joint in file.joints] == [2, 1]
    assert [joint.column for joint in file.joints] == [0, 2]
    none = text.replace("CHANNELS 1 Yrotation", "CHANNELS 0")
    assert read_bvh((none + motion_text(["1 2"])).encode()).values.tolist() == [[1, 2]]


# Frames


@pytest.mark.parametrize("declared", [1, 3, 10**9])
def test_the_complete_rows_count_when_another_number_of_frames_is_declared(declared):
    file = read_bvh((TWO_JOINTS + motion_text([ROW, ROW], declared=declared)).encode())
    assert len(file.values) == 2
    assert "2 complete ones present and read" in texts(file.notes)


def test_a_billion_declared_frames_over_three_rows_read_three_and_say_so():
    file = read_bvh((TWO_JOINTS + motion_text([ROW] * 3, declared=10**9)).encode())
    assert file.values.shape == (3, 9)
    assert "1 000 000 000 frames declared, 3 complete ones present" in texts(file.notes)


def test_a_partial_last_row_is_dropped_and_noted():
    file = read_bvh(two_joints(ROW, "1 2 3 4"))
    assert file.values.tolist() == [VALUES.tolist()]
    note = next(note for note in file.notes if "left out" in note.text)
    assert note.text == "The last frame has 4 of 9 values and was left out"
    assert note.line == two_joints(ROW, "1 2 3 4").decode().splitlines().index("1 2 3 4") + 1


def test_frames_may_run_over_several_lines():
    file = read_bvh(two_joints("1 2 3\n4 5 6\n7 8 9", "1 2 3\n4 5 6\n7 8 9"))
    assert file.values.tolist() == [VALUES.tolist()] * 2
    assert "several lines" in texts(file.notes)


def test_lines_cut_anywhere_are_counted_off_by_values():
    file = read_bvh(two_joints("1 2 3 4 5 6 7 8 9 1 2", "3 4 5 6 7 8 9 1 2 3 4", "5 6 7 8 9"))
    assert file.values.tolist() == [VALUES.tolist()] * 3
    assert "counted off by their values" in texts(file.notes)


def test_a_row_that_lacks_a_value_is_refused_by_line_instead_of_shifting_all_others():
    with pytest.raises(BvhSyntaxError, match="8 values; the channels ask for 9") as caught:
        read_bvh(two_joints(ROW, ROW, "1 2 3 4 5 6 7 8", ROW, ROW))
    lines = two_joints(ROW, ROW, "1 2 3 4 5 6 7 8", ROW, ROW).decode().splitlines()
    assert lines[caught.value.line - 1] == "1 2 3 4 5 6 7 8"
    assert caught.value.fault.frame == 3


@pytest.mark.parametrize(
    "change",
    [
        lambda text: text.replace(" ", "\t"),
        lambda text: text.replace(" ", "  "),
        lambda text: text.replace("\n", " \n "),
        lambda text: text.replace("\n", "\n\n"),
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text.replace("\n", "\r"),
        lambda text: text.rstrip("\n"),
        lambda text: text.rstrip("\n") + " \t\n\n  ",
    ],
    ids=["tabs", "double", "around", "blank lines", "CRLF", "CR", "no last newline", "trailing"],
)
def test_any_white_space_separates(change):
    text = two_joints(ROW, ROW).decode().replace("left knee", "Knee")
    file = read_bvh(change(text).encode())
    assert file.values.tolist() == [VALUES.tolist()] * 2
    assert [joint.name for joint in file.joints] == ["Hips", "Knee"]


# Numbers


def test_every_decimal_that_c_reads_is_read():
    file = read_bvh(two_joints("+1 .008 5. 1E-07 1.5e-40 -0 -.5e+2 1e3 00012.50"))
    assert file.values[0].tolist() == [1, 0.008, 5, 1e-7, 1.5e-40, 0, -50, 1000, 12.5]


@pytest.mark.parametrize("token", ["1_0", "0x10", "1..2", "--1", "1e", "e5", "abc", "½"])
def test_what_is_no_decimal_is_refused_with_its_place(token):
    with pytest.raises(BvhSyntaxError, match="is not a number") as caught:
        read_bvh(two_joints(ROW, f"1 2 3 4 5 6 7 {token} 9".replace("½", "\u00bd")))
    error = caught.value
    assert (error.line, error.column) == (20, 15)
    assert (error.fault.frame, error.fault.joint, error.fault.channel) == (
        2,
        "left knee",
        "Xrotation",
    )


@pytest.mark.parametrize("token", ["nan", "NaN", "-inf", "Infinity", "1.#QNAN", "1e999"])
def test_values_that_are_not_finite_are_refused_and_filling_is_offered(token):
    with pytest.raises(BvhSyntaxError, match="not a finite number") as caught:
        read_bvh(two_joints(ROW, f"1 2 3 4 5 6 7 {token} 9", ROW))
    error = caught.value
    assert (error.line, error.column) == (20, 15)
    assert error.fault.offer == "fill_gaps"
    assert error.fault.frame == 2
    assert error.fault.joint == "left knee"
    assert error.fault.context == (
        (19, ROW),
        (20, f"1 2 3 4 5 6 7 {token} 9"),
        (21, ROW),
    )


def test_filled_gaps_are_interpolated_the_short_way_round_and_reported():
    rows = [f"0 0 0 {angle} 0 0 0 0 0" for angle in ("170", "nan", "-170")]
    file = read_bvh(two_joints(*rows), fill_gaps=True)
    assert file.values[1, 3] == pytest.approx(180)
    assert "1 missing value of Hips, Zrotation filled by interpolation" in texts(file.notes)


def test_a_channel_without_any_number_cannot_be_filled():
    with pytest.raises(BvhSyntaxError, match="no value is a number"):
        read_bvh(two_joints("0 0 0 nan 0 0 0 0 0"), fill_gaps=True)


def test_decimal_commas_are_converted_when_every_decimal_is_one():
    text = two_joints("1,5 2 3 4 5 6 7 8 -0,25").replace(b"0.0333333", b"0,0333333")
    file = read_bvh(text)
    assert file.values[0, [0, 8]].tolist() == [1.5, -0.25]
    assert file.frame_time == 0.0333333
    assert "Decimal commas" in texts(file.notes)


def test_commas_beside_points_are_refused():
    with pytest.raises(BvhSyntaxError, match="decimal commas stand beside"):
        read_bvh(two_joints("1,5 2.5 3 4 5 6 7 8 9"))


# Frame time


def test_the_keywords_of_the_motion_part_need_no_space_behind_them():
    text = TWO_JOINTS + f"MOTION\nFrames:1\nFrame Time:.03\n{ROW}\n"
    file = read_bvh(text.encode())
    assert (len(file.values), file.frame_time) == (1, 0.03)


@pytest.mark.parametrize("written", ["0", "0.0", "-0.01"])
def test_a_frame_time_that_is_not_positive_is_refused(written):
    with pytest.raises(BvhSyntaxError, match="frame time must be above 0") as caught:
        read_bvh((TWO_JOINTS + motion_text([ROW], frame_time=written)).encode())
    assert caught.value.line == 18
    assert caught.value.fault.offer == "frame_time"


def test_a_rounded_frame_time_is_kept_as_written_and_the_exact_one_offered():
    file = read_bvh((TWO_JOINTS + motion_text([ROW], frame_time="0.033333")).encode())
    assert file.frame_time == 0.033333
    note = next(note for note in file.notes if note.offer == "frame_time")
    assert note.text == "Frame time 0.033333 kept as written (1/30 s offered)"
    assert read_bvh(two_joints(ROW), frame_time=1 / 30).frame_time == 1 / 30


# Names


def test_the_rest_of_the_line_is_the_name():
    names = {"Hips": "mixamorig:Hips", "LeftArm": "left upper.arm 2", "Head": "Kopf (oben)"}
    file = read_bvh(person(names=names))
    found = {joint.name for joint in file.joints}
    assert set(names.values()) <= found


def test_a_name_used_twice_becomes_unique_and_is_noted():
    result = ingest(person(names={"LeftHand": "Hand", "RightHand": "Hand"}))
    assert {"Hand", "Hand_2"} <= set(result.clip.skeleton.names)
    assert "A second joint “Hand” is called “Hand_2”" in texts(result.report.repairs)


def test_a_joint_without_a_name_gets_one():
    file = read_bvh(two_joints(ROW).replace(b"JOINT left knee", b"JOINT"))
    assert file.joints[1].name == "joint_2"
    assert "without a name" in texts(file.notes)


def test_a_byte_order_mark_is_left_out_and_noted():
    file = read_bvh(b"\xef\xbb\xbf" + two_joints(ROW))
    assert file.joints[0].name == "Hips"
    assert "byte order mark" in texts(file.notes)


@pytest.mark.parametrize(
    ("encoding", "name", "read"),
    [
        ("utf-8", "Hüfte", "Hüfte"),
        ("latin-1", "Hüfte", "Hüfte"),
        ("cp932", "頭", "頭".encode("cp932").decode("latin-1")),
        ("cp932", "左ボーン", "左ボーン".encode("cp932").decode("latin-1")),  # has the byte of {
    ],
)
def test_names_are_utf8_or_else_latin1(encoding, name, read):
    file = read_bvh(two_joints(ROW).replace(b"left knee", name.encode(encoding)))
    assert file.joints[1].name == read
    assert ("Latin-1" in texts(file.notes)) == (encoding != "utf-8")


def test_utf16_text_is_refused_in_words():
    with pytest.raises(BvhSyntaxError, match="Save it as UTF-8"):
        read_bvh(two_joints(ROW).decode().encode("utf-16"))


# End sites, braces, keywords


@pytest.mark.parametrize(
    "end",
    [
        "End Site\n{\nOFFSET 0 -40 0\n}",
        "end site\n{\nOFFSET 0 -40 0\n}",
        "END SITE Toe tip {\nOFFSET 0 -40 0\n}",
        "End Site\n{\nOFFSET 0 -40 0\nCHANNELS 0\n}",
        "EndSite { OFFSET 0 -40 0 }",
    ],
)
def test_end_sites_come_in_any_case_named_or_with_no_channels(end):
    head, _, tail = TWO_JOINTS.partition("End Site")
    tail = tail.partition("}")[2]
    file = read_bvh((head + end + tail + motion_text([ROW])).encode())
    assert [(tip.joint, tip.offset) for tip in file.tips] == [(1, (0, -40, 0))]


def test_an_absent_end_site_is_not_invented():
    result = ingest(person())
    assert result.clip.skeleton.end_sites == ()


def test_offsets_of_end_sites_are_kept_as_tips():
    result = ingest(two_joints(ROW), IngestOptions(unit=0.01, up_axis="y"))
    (site,) = result.clip.skeleton.end_sites
    assert (site.joint, site.offset) == (1, pytest.approx((0, -0.4, 0)))


def test_braces_may_stand_on_the_keywords_line_and_keywords_in_any_case():
    text = two_joints(ROW).decode().replace("\n{", " {").replace("\n  {", " {")
    for word in (
        "HIERARCHY",
        "ROOT",
        "JOINT",
        "OFFSET",
        "CHANNELS",
        "MOTION",
        "Frame",
        "Xrotation",
    ):
        text = text.replace(word, word.swapcase())
    file = read_bvh(text.encode())
    assert [joint.name for joint in file.joints] == ["Hips", "left knee"]
    assert file.joints[1].channels == ("Zrotation", "Xrotation", "Yrotation")
    assert file.values.tolist() == [VALUES.tolist()]


# Several figures, degenerate skeletons


def two_figures():
    first = person(2, names={"Hips": "First"}).decode()
    second = person(2, names={"Hips": "Second"}).decode()
    head, _, motion = first.partition("MOTION")
    other = second.partition("MOTION")[0].replace("HIERARCHY", "").replace("OFFSET 9", "OFFSET 8.5")
    rows = [line for line in motion.splitlines()[3:] if line]
    return (head + other + motion_text([f"{row} {row}" for row in rows])).encode()


def test_of_several_roots_all_are_read_and_the_user_picks_one():
    file = read_bvh(two_figures())
    assert [file.joints[root].name for root in file.roots] == ["First", "Second"]
    first, second = ingest(two_figures()), ingest(two_figures(), IngestOptions(root=1))
    assert "2 figures" in texts(first.report.questions)
    assert first.report.roles["hips"] == "First"
    assert second.report.roles["hips"] == "Second"


def test_zero_length_offsets_are_never_divided_by():
    # As in the CMU files: a hip joint in the middle of the hips, a clavicle in the chest.
    data = person(4, bend=2.0).decode()
    data = data.replace("OFFSET 4 17 0", "OFFSET 0 0 0").replace("OFFSET -4 17 0", "OFFSET 0 0 0")
    result = ingest(data.encode())
    assert np.isfinite(result.clip.rotations).all()
    assert not result.report.missing_roles


def test_a_file_without_motion_is_a_skeleton():
    for data in (TWO_JOINTS.encode(), (TWO_JOINTS + motion_text([])).encode()):
        file = read_bvh(data)
        assert file.values.shape == (0, 9)
        assert file.motion_line is None
        assert "skeleton but no" in texts(file.notes)
        assert ingest(data, IngestOptions(unit=0.01, up_axis="y")).clip.frames == 1


# Units, axes, poses


@pytest.mark.parametrize(
    ("scale", "unit", "name"),
    [
        (0.01, 1.0, "metres"),
        (1.0, 0.01, "centimetres"),
        (10.0, 0.001, "millimetres"),
        (1 / 2.54, 0.0254, "inches"),
        (1 / 30.48, 0.3048, "feet"),
        (0.45 / 2.54, 0.0254 / 0.45, "CMU units (5.64 cm)"),
    ],
)
def test_the_unit_is_guessed_from_the_height_and_asked_about(scale, unit, name):
    report = ingest(person(scale=scale)).report
    assert report.unit == pytest.approx(unit)
    assert report.unit_name == name
    assert report.stature == pytest.approx(1.68, abs=0.06)
    question = report.questions[0]
    assert question.text.startswith(
        f"Is the figure {report.stature:.2f} m tall? Read as {name}, y up"
    )
    assert question.offer == "unit"


UP_AXES = {
    "y": np.eye(3),
    "z": np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]]),
    "x": np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]),
    "-y": np.diag([1, -1, -1]),
    "-z": np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]]),
    "-x": np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
}


@pytest.mark.parametrize("axis", UP_AXES)
def test_the_up_axis_is_guessed_from_the_resting_direction(axis):
    result = ingest(person(turn=UP_AXES[axis]))
    assert result.report.up_axis == axis
    pose = forward_kinematics(result.clip)
    expected = forward_kinematics(ingest(person()).clip)
    assert pose.positions == pytest.approx(expected.positions, abs=1e-6)
    assert result.clip.skeleton.offsets[1] == pytest.approx([0, 0.12, 0])


def test_unit_and_up_axis_can_be_given():
    report = ingest(person(), IngestOptions(unit=0.02, up_axis="z")).report
    assert (report.unit, report.up_axis) == (0.02, "z")


def with_calibration_pose():
    rows = person(8, bend=1.0).decode().splitlines()
    pose = np.array(rows[-1].split(), float)
    first = pose.copy()
    first[6:] += 40
    rows.insert(len(rows) - 8, " ".join(map(str, first)))
    return "\n".join(rows).encode()


def test_a_calibration_pose_in_the_first_frame_is_asked_about_and_can_be_dropped():
    kept = ingest(with_calibration_pose())
    offer = next(note for note in kept.report.questions if note.offer == "drop_first_frame")
    assert offer.where == "frame 1"
    dropped = ingest(with_calibration_pose(), IngestOptions(drop_first_frame=True))
    assert dropped.clip.frames == kept.clip.frames - 1
    assert "left out" in texts(dropped.report.repairs)
    assert not any(note.offer == "drop_first_frame" for note in dropped.report.questions)


def test_a_rest_pose_that_is_no_t_pose_changes_nothing_but_the_rest_pose():
    # The same person whose rest pose lies on the back: the motion stands it up again.
    lying = person(turn=UP_AXES["z"]).decode().splitlines()
    rows = next(index for index, line in enumerate(lying) if line.startswith("Frame Time")) + 1
    for index in range(rows, len(lying)):
        values = lying[index].split()
        values[:3] = ["5", "94", "-20"]
        values[4] = "-90"
        lying[index] = " ".join(values)
    result = ingest("\n".join(lying).encode())
    expected = forward_kinematics(ingest(person()).clip)
    assert result.report.up_axis == "y"
    assert forward_kinematics(result.clip).positions == pytest.approx(expected.positions, abs=1e-6)
