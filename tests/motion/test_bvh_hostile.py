"""Files made to hurt end with a clear error, in bounded memory."""

import tracemalloc

import pytest

from motion.bvh import Limits, read_bvh
from motion.errors import BvhSyntaxError
from tests.support.bvh_files import TWO_JOINTS, motion_text, two_joints

ROW = "1 2 3 4 5 6 7 8 9"


def peak_of_refusal(data, match, **options):
    """Bytes allocated on the way to a refusal, the file itself not counted."""
    tracemalloc.start()
    try:
        with pytest.raises(BvhSyntaxError, match=match):
            read_bvh(data, **options)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def test_joints_ten_thousand_deep_are_refused_where_the_limit_is():
    data = b"HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0\n" + b"JOINT b\n{ OFFSET 0 1 0\n" * 10_000
    assert peak_of_refusal(data, "nested deeper than 200") < 2_000_000


def test_a_million_joints_are_refused_where_the_limit_is():
    data = b"HIERARCHY\nROOT a\n{ OFFSET 0 0 0\n" + b"JOINT b\n{ OFFSET 0 1 0 }\n" * 1_000_000
    assert peak_of_refusal(data, "More than 2000 joints") < 5_000_000


def test_a_million_end_sites_are_refused():
    data = b"HIERARCHY\nROOT a\n{ OFFSET 0 0 0\n" + b"End Site\n{ OFFSET 0 1 0 }\n" * 1_000_000
    assert peak_of_refusal(data, "end sites") < 10_000_000


def test_two_hundred_megabytes_of_spaces_are_refused_by_their_size():
    assert peak_of_refusal(b" " * 200_000_000, "200 MB; at most 100 MB") < 100_000


def test_spaces_within_the_limit_end_too():
    data = b" " * 20_000_000
    assert peak_of_refusal(data, "not a BVH file") < 100_000
    values = read_bvh(two_joints(ROW) + data).values
    assert len(values) == 1


def test_a_number_without_end_is_refused():
    data = two_joints(ROW) + b"1" * 5_000_000
    assert peak_of_refusal(data, "is not a number") < 20_000_000


@pytest.mark.parametrize(
    ("before", "after", "match"),
    [
        (b"OFFSET 0", b"OFFSET 1e200", "OFFSET of"),
        (b"Frame Time: ", b"Frame Time: 1e308 ", "Expected a number for the Frame Time"),
        (b"\n1 2 3", b"\n1e200 2 3", "frame 1.*not a finite number of usable size"),
    ],
)
def test_numbers_too_large_to_compute_with_are_refused(before, after, match):
    data = two_joints(ROW)
    assert before in data
    with pytest.raises(BvhSyntaxError, match=match):
        read_bvh(data.replace(before, after, 1))


def test_a_name_without_end_is_cut_in_messages():
    data = b"HIERARCHY\n" + b"x" * 1_000_000
    with pytest.raises(BvhSyntaxError) as caught:
        read_bvh(data)
    assert len(str(caught.value)) < 200


def test_more_frames_than_the_limit_are_refused():
    data = (TWO_JOINTS + motion_text([ROW] * 11)).encode()
    with pytest.raises(BvhSyntaxError, match="more than 10 are not read"):
        read_bvh(data, limits=Limits(frames=10))
    assert len(read_bvh(data, limits=Limits(frames=11)).values) == 11


def test_declared_frames_allocate_nothing():
    data = (TWO_JOINTS + motion_text([ROW] * 3, declared=10**9)).encode()
    tracemalloc.start()
    read_bvh(data)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 2_000_000


def test_a_file_cut_off_anywhere_is_read_or_refused_with_a_place_in_it():
    data = two_joints(ROW, ROW)
    lines = data.count(b"\n") + 1
    refused = []
    for end in range(len(data)):
        try:
            read_bvh(data[:end])
        except BvhSyntaxError as error:
            refused.append((error.line, error.column))
    assert len(refused) > data.index(b"MOTION")
    assert all(1 <= line <= lines and column >= 1 for line, column in refused)


@pytest.mark.parametrize(
    ("data", "match"),
    [
        (b"", "The file is empty"),
        (b"GIF89a\x00\xff", "not a BVH file"),
        (b"HIERARCHY", "no ROOT"),
        (b"HIERARCHY ROOT a", "Expected { after “a”"),
        (b"HIERARCHY\nROOT a\n{", "“a”, opened on line 2, is not closed"),
        (b"HIERARCHY\nROOT a\n{ } }", "closes nothing"),
        (b"HIERARCHY\nROOT a\n{ OFFSET 1 2 }", "Expected a number for the OFFSET of “a”"),
        (b"HIERARCHY\nROOT a\n{ OFFSET 1 2 nan", "Expected a number for the OFFSET"),
        (b"HIERARCHY\nROOT a\n{ OFFSET 0 0 0 OFFSET 0 0 0 }", "once each"),
        (b"HIERARCHY\nROOT a\n{ CHANNELS 7 }", "cannot have 7 channels"),
        (b"HIERARCHY\nROOT a\n{ CHANNELS 2 Xrotation }", "Expected 2 channels such as"),
        (b"HIERARCHY\nROOT a\n{ CHANNELS 1 Xscale }", "“Xscale”"),
        (b"HIERARCHY\nROOT a\n{ CHANNELS 1.5 }", "whole number"),
        (b"HIERARCHY\nROOT a\n{\nROOT b\n{ } }", "found “ROOT”"),
        (b"HIERARCHY\nJOINT a\n{ }", "Expected ROOT or MOTION"),
        (b"HIERARCHY\nROOT a\n{\nEnd Site\n{\nJOINT b\n{ } } }", "Expected OFFSET or }"),
        (b"HIERARCHY\nROOT a\n{ }\nMOTION\nFrame Time: 1", "Expected “Frames:”"),
        (b"HIERARCHY\nROOT a\n{ }\nMOTION\nFrames: x", "whole number|number of Frames"),
        (b"HIERARCHY\nROOT a\n{ }\nMOTION\nFrames: 1\n1 2 3", "Expected “Frame Time:”"),
        (b"HIERARCHY\nROOT a\n{ }\nMOTION\nFrames: 1\nFrame Time: 1\n1", "no joint has CHANNELS"),
    ],
)
def test_what_is_no_bvh_is_refused_in_words(data, match):
    with pytest.raises(BvhSyntaxError, match=match):
        read_bvh(data)
