"""Motion graphs: transitions where clips are alike, and no jump on the way through."""

from dataclasses import replace

import numpy as np
import pytest

from motion import Clip, MotionError
from motion.editing.foot_plants import find_feet, runs
from motion.editing.foot_repair import repair_feet
from motion.editing.path_length import PathLength, change_path_length
from motion.graph import MotionGraph, Transition, build_graph, edit_graph, route
from motion.graph_play import play
from motion.graph_window import Windows
from motion.kinematics import forward_kinematics
from motion.procedural.bodies import BODIES
from motion.procedural.library import set_a
from motion.procedural.steering import graph_clips
from motion.rotations import angle_between, from_axis_angle, multiply, rotate

UP = np.array([0.0, 1.0, 0.0])


@pytest.fixture(scope="module")
def clips():
    return graph_clips(BODIES["female"])


@pytest.fixture(scope="module")
def graph(clips):
    return build_graph(clips)


def elsewhere(clip, angle, shift):
    """The same motion, played in another place in another heading."""
    turn = from_axis_angle(UP, np.asarray(angle))
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    return replace(
        clip, root_positions=rotate(turn, clip.root_positions) + shift, rotations=rotations
    )


def largest_jump(clip):
    """Degrees that any joint turns from one frame to the next."""
    return np.degrees(angle_between(clip.rotations[1:], clip.rotations[:-1])).max()


def around(graph, transition, margin=10):
    """The motion shortly before, during and shortly after a transition."""
    start = transition.source_frame
    if graph.clips[transition.source].cyclic:
        start += graph.clips[transition.source].frames - 1
    start = max(0, start - margin)
    stop = transition.target_frame + graph.fade + margin
    if not graph.clips[transition.target].cyclic:
        stop = min(stop, graph.clips[transition.target].frames)
    return play(graph, transition.source, [transition], start=start, stop=stop)


def test_no_joint_jumps_at_any_transition(graph):
    assert len(graph.transitions) > 50
    for transition in graph.transitions:
        motion = around(graph, transition)
        assert largest_jump(motion) <= 15.0, transition
        way = np.linalg.norm(np.diff(motion.root_positions, axis=0), axis=1)
        assert way.max() / motion.frame_time < 2.0, transition


def test_no_joint_jumps_between_walks_of_different_character():
    clips = {sample.name: sample.clip for sample in set_a()}
    graph = build_graph(clips, threshold=0.12)
    assert len({(t.source, t.target) for t in graph.transitions if t.source != t.target}) > 5
    for transition in graph.transitions:
        assert largest_jump(around(graph, transition)) <= 15.0, transition


def test_every_clip_is_reached_from_every_clip(graph, clips):
    for source in clips:
        for target in clips:
            way = route(graph, source, 0, target)
            motion = play(graph, source, way)
            assert largest_jump(motion) <= 15.0
            assert not way or way[-1].target == target


def test_a_standing_body_walks_off_soon(graph):
    for frame in range(0, 240, 20):
        for target in ("walk", "turn_left", "turn_right"):
            way = route(graph, "stand", frame, target)
            ((wait, _),) = [(w, t) for w, t in graph.leaving("stand", frame) if t is way[0]]
            assert len(way) == 1
            assert wait <= 30


def test_after_each_transition_another_can_follow(graph):
    ways = set(graph.transitions)
    for transition in graph.transitions:
        after = graph.leaving(transition.target, transition.target_frame + graph.fade)
        assert any(follower in ways for _, follower in after)


def test_a_long_way_through_the_graph_stays_whole(graph, clips):
    generator = np.random.default_rng(7)
    here, at, way = "stand", 0, []
    for _ in range(40):
        leaving = graph.leaving(here, at)
        _, transition = leaving[int(generator.integers(len(leaving)))]
        way.append(transition)
        here, at = transition.target, transition.target_frame + graph.fade
    motion = play(graph, "stand", way)
    assert largest_jump(motion) <= 15.0
    pose = forward_kinematics(motion)
    parents = motion.skeleton.parents[1:]
    bones = np.linalg.norm(pose.positions[:, 1:] - pose.positions[:, parents], axis=-1)
    expected = np.linalg.norm(motion.skeleton.offsets[1:], axis=1)
    np.testing.assert_allclose(bones, np.broadcast_to(expected, bones.shape), atol=1e-9)
    assert pose.positions[..., 1].min() > -0.02


@pytest.mark.parametrize("gain", [0.4, 1.6])
def test_edited_clips_follow_each_other_as_smoothly(graph, gain):
    """Path length as the character walks: every node goes through the editing."""

    def edit(clip):
        return repair_feet(clip, change_path_length(clip, PathLength(gain)))

    edited = edit_graph(graph, edit)
    assert [(t.source, t.source_frame, t.target, t.target_frame) for t in edited.transitions] == [
        (t.source, t.source_frame, t.target, t.target_frame) for t in graph.transitions
    ]
    for transition in edited.transitions:
        motion = around(edited, transition)
        assert largest_jump(motion) <= 15.0, transition
        way = np.linalg.norm(np.diff(motion.root_positions, axis=0), axis=1)
        assert way.max() / motion.frame_time < 3.0, transition


def test_an_edit_that_changes_nothing_leaves_the_graph_as_it_is(graph):
    same = edit_graph(graph, lambda clip: clip)
    for one, other in zip(graph.transitions, same.transitions, strict=True):
        assert (one.turn, one.shift) == (other.turn, other.shift)
        assert other.distance == pytest.approx(one.distance, abs=1e-6)
    with pytest.raises(MotionError, match="frames instead of"):
        edit_graph(
            graph,
            lambda clip: replace(
                clip,
                root_positions=clip.root_positions[:-9],
                rotations=clip.rotations[:-9],
                cyclic=False,
            ),
        )


def test_repaired_feet_stand_all_the_way(graph):
    motion = play(graph, "stand", route(graph, "stand", 0, "turn_left"))
    repaired, slips = repair_feet(motion, motion), []
    pose = forward_kinematics(repaired)
    for foot in find_feet(motion):
        for point, planted in zip(foot.points, foot.planted, strict=True):
            places = point.positions(pose)[:, [0, 2]]
            slips += [np.linalg.norm(places[p] - places[p][0], axis=1).max() for p in runs(planted)]
    assert len(slips) > 10
    assert max(slips) < 0.005
    assert largest_jump(repaired) <= 15.0


def test_distance_knows_no_place_and_no_heading(clips):
    walk = clips["walk"]
    moved = elsewhere(walk, 2.1, np.array([3.0, 0.0, -4.0]))
    one, other = Windows.of(walk, 18), Windows.of(moved, 18)
    distances = one.distances(other)
    np.testing.assert_allclose(np.diagonal(distances), 0.0, atol=1e-6)
    np.testing.assert_allclose(distances, one.distances(one), atol=1e-6)
    turn, (x, z) = one.alignment(other, 50, 50)
    assert turn == pytest.approx(-2.1)
    back = rotate(from_axis_angle(UP, np.asarray(turn)), moved.root_positions[50])
    np.testing.assert_allclose(back + np.array([x, 0, z]), walk.root_positions[50], atol=1e-9)


def test_distance_is_the_least_over_all_turns_and_shifts(clips):
    """Against a search by turning point clouds step by step."""
    one = Windows.of(clips["walk"], 18)
    other = Windows.of(clips["turn_left"], 18)
    i, j = 120, 210
    turns = np.exp(1j * np.linspace(-np.pi, np.pi, 20001))[:, None]
    level = np.abs(one.level[i] - turns * other.level[j]) ** 2
    upright = np.sum((one.upright[i] - other.upright[j]) ** 2)
    expected = np.sqrt((level.sum(axis=1).min() + upright) / one.points)
    assert one.distances(other)[i, j] == pytest.approx(expected, rel=1e-5)


def test_a_way_without_transitions_is_the_clip(graph, clips):
    motion = play(graph, "walk", [])
    np.testing.assert_array_equal(motion.root_positions, clips["walk"].root_positions)
    np.testing.assert_allclose(
        np.abs(np.sum(motion.rotations * clips["walk"].rotations, axis=-1)), 1.0
    )


def test_a_cyclic_clip_walks_on_while_it_waits(clips):
    """A transition that has been missed is taken in the next cycle, one cycle's travel farther."""
    cycle = next(sample.clip for sample in set_a())
    here = Transition("a", 10, "a", 10, 0.0, (0.0, 0.0), 0.0)
    graph = MotionGraph({"a": cycle}, (here,), fade=5)
    motion = play(graph, "a", [here], start=20, stop=40)
    period = cycle.frames - 1
    assert motion.frames == period - 10 + 5 + 25
    np.testing.assert_allclose(
        motion.root_positions[-1] - motion.root_positions[0],
        cycle.root_positions[39] + cycle.travel - cycle.root_positions[20],
        atol=1e-9,
    )


def test_what_does_not_belong_together_is_refused(graph, clips):
    with pytest.raises(MotionError, match="at least one"):
        build_graph({})
    other = graph_clips(BODIES["male"])["walk"]
    with pytest.raises(MotionError, match="skeletons"):
        build_graph({"walk": clips["walk"], "other": other})
    walk = clips["walk"]
    slow = Clip(walk.skeleton, walk.root_positions, walk.rotations, 1 / 30)
    with pytest.raises(MotionError, match="frames a second"):
        build_graph({"walk": walk, "slow": slow})
    with pytest.raises(MotionError, match="no clip “swim”"):
        route(graph, "walk", 0, "swim")
    leaving = [t for t in graph.transitions if t.source == "walk"]
    with pytest.raises(MotionError, match="Transition 0"):
        play(graph, "walk", leaving[:1], start=walk.frames - 1)


def test_a_graph_becomes_plain_values(graph):
    plain = graph.to_dict()
    assert plain["fade"] == graph.fade
    assert len(plain["transitions"]) == len(graph.transitions)
    assert isinstance(plain["transitions"][0]["distance"], float)


def test_a_removed_transition_is_gone_and_an_added_one_is_there(graph, clips):
    gone = graph.transitions[5].key
    new = ("walk", 123, "turn_left", 77)
    changed = build_graph(clips, removed={gone}, added=[new])
    keys = {t.key for t in changed.transitions}
    assert keys == ({t.key for t in graph.transitions} - {gone}) | {new}
    (added,) = [t for t in changed.transitions if t.key == new]
    one, other = (Windows.of(clips[name], graph.fade) for name in ("walk", "turn_left"))
    assert (added.turn, added.shift) == one.alignment(other, 123, 77)


def test_transitions_without_a_way_on_are_told_apart(graph, clips):
    """Without the ways back from standing, what leads there leads nowhere."""
    removed = {t.key for t in graph.transitions if t.source == "stand"}
    changed = build_graph(clips, removed=removed)
    assert not any("stand" in (t.source, t.target) for t in changed.transitions)
    lost = {t.key for t in graph.transitions if t.target == "stand"} - removed
    assert lost
    assert lost <= {t.key for t in changed.dead_ends}


def test_a_transition_is_added_only_where_it_has_room(clips):
    walk = clips["walk"]
    with pytest.raises(MotionError, match="no clip “swim”"):
        build_graph(clips, added=[("swim", 0, "walk", 0)])
    with pytest.raises(MotionError, match=f"frames 0 to {walk.frames - 19}"):
        build_graph(clips, added=[("walk", walk.frames - 5, "walk", 0)])


def test_the_way_is_the_soonest_of_all(graph):
    """Against a search that looks at every way of up to two transitions."""

    def soonest(clip, frame, target, depth):
        if clip == target and graph.left(clip, frame) >= 2.0:
            return 0
        if depth == 0:
            return np.inf
        return min(
            (
                wait
                + graph.fade
                + soonest(t.target, t.target_frame + graph.fade, target, depth - 1)
                for wait, t in graph.leaving(clip, frame)
            ),
            default=np.inf,
        )

    for clip, frame, target in [("stand", 7, "walk"), ("turn_left", 480, "turn_right")]:
        frames, at = 0, frame
        here = clip
        for t in route(graph, clip, frame, target):
            frames += {b: a for a, b in graph.leaving(here, at)}[t] + graph.fade
            here, at = t.target, t.target_frame + graph.fade
        assert frames == soonest(clip, frame, target, 2)


def test_a_graph_of_too_many_transitions_says_what_to_do(graph, monkeypatch):
    """Every one is linked with all that can follow it: their number squared is what it costs."""
    count = len(graph.transitions) + len(graph.dead_ends)
    monkeypatch.setattr("motion.graph._MOST", count)
    assert len(build_graph(graph.clips).transitions) == len(graph.transitions)
    monkeypatch.setattr("motion.graph._MOST", count - 1)
    with pytest.raises(MotionError, match="Lower the threshold"):
        build_graph(graph.clips)
