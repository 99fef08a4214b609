"""Steering through a motion graph: what comes piece by piece is one motion without a jump."""

from __future__ import annotations

import numpy as np
import pytest

from motion import Clip, MotionError
from motion.editing.foot_plants import find_feet, runs
from motion.graph import build_graph, edit_graph, route
from motion.graph_play import play
from motion.graph_steer import Manner, Piece, Place, in_manner, next_piece
from motion.kinematics import forward_kinematics
from motion.procedural.bodies import BODIES
from motion.procedural.library import set_a
from motion.procedural.steering import graph_clips
from motion.rotations import angle_between

PLAIN = Manner()
QUIET = Manner(0.0, 2.0, (("head_down", 1.0), ("elbows_away", 0.8)))
LARGE = Manner(2.0, 0.3, (("hands_and_feet_closer", 1.0),))
MANNERS = (PLAIN, QUIET, LARGE, Manner(1.6, 1.7), Manner(0.4, 0.0, (("head_down", -1.0),)))
CLIPS = ("stand", "walk", "turn_left", "turn_right")
PIECE = 18


@pytest.fixture(scope="module")
def graph():
    return build_graph(graph_clips(BODIES["adult"]))


def joined(graph, pieces: list[Piece]) -> Clip:
    roots, rotations = (
        np.concatenate(p) for p in zip(*(one.frames for one in pieces), strict=True)
    )
    clip = next(iter(graph.clips.values()))
    return Clip(clip.skeleton, roots, rotations, clip.frame_time)


def largest_jump(motion: Clip) -> float:
    """Degrees that any joint turns from one frame to the next."""
    return float(np.degrees(angle_between(motion.rotations[1:], motion.rotations[:-1])).max())


def speeds(motion: Clip) -> np.ndarray:
    """m/s of the hips over the floor."""
    way = np.diff(motion.root_positions, axis=0)[:, [0, 2]]
    return np.linalg.norm(way, axis=1) / motion.frame_time


def test_no_transition_makes_a_joint_jump_in_any_manner_nor_where_the_manner_changes(graph):
    """Over every transition: in one manner, and from one manner into another."""
    fastest = max(
        speeds(in_manner(clip, manner)).max() for clip in graph.clips.values() for manner in MANNERS
    )
    rng = np.random.default_rng(3)
    pairs = [(one, one) for one in MANNERS] + [(PLAIN, QUIET), (QUIET, LARGE), (LARGE, PLAIN)]
    assert len(graph.transitions) > 400
    for transition in graph.transitions:
        for before, after in (pairs[k] for k in rng.choice(len(pairs), 3, replace=False)):
            start = max(0, transition.source_frame - int(rng.integers(1, 40)))
            place, pieces = Place(transition.source, start, manner=before), []
            while not pieces or pieces[-1].taken is None:
                manner = before if place.frame + PIECE < transition.source_frame else after
                piece = next_piece(graph, place, "walk", manner, PIECE, via=transition.key)
                pieces.append(piece)
                place = piece.after
            pieces.append(next_piece(graph, place, transition.target, after, PIECE))
            motion = joined(graph, pieces)
            assert pieces[-2].taken == transition
            assert largest_jump(motion) <= 15.0, (transition, before, after)
            assert speeds(motion).max() <= 1.25 * fastest, (transition, before, after)


@pytest.mark.parametrize("seed", range(3))
def test_a_long_steered_walk_with_changing_manner_never_jumps(graph, seed):
    rng = np.random.default_rng(seed)
    place, target, manner, pieces = Place("stand"), "stand", PLAIN, []
    for _ in range(250):
        if rng.random() < 0.2:
            target = str(rng.choice(CLIPS))
        if rng.random() < 0.3:
            manner = Manner(*rng.uniform(0, 2, 2), (("head_down", float(rng.uniform(-1, 1))),))
        piece = next_piece(graph, place, target, manner, int(rng.integers(1, 30)))
        pieces.append(piece)
        place = piece.after
    motion = joined(graph, pieces)
    assert {piece.after.clip for piece in pieces} == set(CLIPS)
    assert largest_jump(motion) <= 15.0
    assert speeds(motion).max() < 2.5
    assert np.abs(np.diff(motion.root_positions[:, 1])).max() / motion.frame_time < 0.9
    height = forward_kinematics(motion).positions[..., 1]
    assert height.min() > 0.0  # no joint sinks into the floor


@pytest.mark.parametrize("manner", [PLAIN, QUIET], ids=["plain", "quiet"])
def test_pieces_are_what_is_played_along_the_same_way(graph, manner):
    way = [t for stop in ("turn_left", "stand") for t in route(graph, *_end(graph, stop))]
    edited = edit_graph(graph, lambda clip: in_manner(clip, manner))
    fitted = {t.key: t for t in edited.transitions}
    place, pieces = Place("stand", 10, manner=manner), []
    for transition in way:
        while not pieces or pieces[-1].taken != transition:
            pieces.append(next_piece(graph, place, "walk", manner, 7, via=transition.key))
            place = pieces[-1].after
    steered = joined(graph, pieces)
    played = play(edited, "stand", [fitted[t.key] for t in way], start=10, stop=place.frame)
    assert steered.frames == played.frames
    turned = np.degrees(angle_between(steered.rotations, played.rotations))
    assert turned[:, 1:].max() < 1e-5
    assert turned[:, 0].max() < 0.05  # velocities at the ends of a cycle, known more exactly
    np.testing.assert_allclose(steered.root_positions, played.root_positions, atol=2e-3)


def _end(graph, target: str) -> tuple[str, int, str]:
    """Where the way to the turn begins, and where that to standing goes on from it."""
    if target == "turn_left":
        return "stand", 10, target
    last = route(graph, "stand", 10, "turn_left")[-1]
    return last.target, last.target_frame + graph.fade, target


@pytest.mark.parametrize("target", CLIPS)
@pytest.mark.parametrize("source", CLIPS)
def test_a_wanted_clip_is_reached_when_it_was_said(graph, source, target):
    place = Place(source, 60)
    piece = next_piece(graph, place, target, PLAIN, PIECE)
    said, frames = piece.reaches, 0
    while piece.reaches:
        piece = next_piece(graph, piece.after, target, PLAIN, PIECE)
        frames += len(piece.frames[0])
    assert piece.after.clip == target
    assert frames == said


def test_whoever_goes_on_wanting_a_clip_stays_in_it(graph):
    for target in CLIPS:
        piece = next_piece(graph, Place(target, 100), target, PLAIN, PIECE)
        for _ in range(120):
            piece = next_piece(graph, piece.after, target, PLAIN, PIECE)
            assert piece.after.clip == target
            assert len(piece.frames[0]) > 0


def test_standing_feet_stay_while_clips_go_over_into_each_other(graph):
    rng = np.random.default_rng(5)
    piece, pieces = next_piece(graph, Place("stand"), "walk", PLAIN, PIECE), []
    for _ in range(200):
        piece = next_piece(graph, piece.after, str(rng.choice(CLIPS)), PLAIN, PIECE)
        pieces.append(piece)
    motion, slips = joined(graph, pieces), []
    pose = forward_kinematics(motion)
    for foot in find_feet(motion):
        for point, planted in zip(foot.points, foot.planted, strict=True):
            places = point.positions(pose)[:, [0, 2]]
            slips += [np.linalg.norm(places[p] - places[p][0], axis=1).max() for p in runs(planted)]
    assert sum(piece.blended for piece in pieces) > 50
    assert max(slips) < 0.006


def test_a_changed_manner_is_there_after_one_fade(graph):
    place = Place("walk", 150)
    piece = next_piece(graph, place, "walk", QUIET, PIECE)
    assert piece.blended
    assert piece.taken is None
    assert piece.after.manner == QUIET
    assert piece.after.frame == 150 + graph.fade
    rotations = next_piece(graph, piece.after, "walk", QUIET, PIECE).frames[1][:, 1:]
    frames = slice(piece.after.frame, piece.after.frame + len(rotations))
    wanted = in_manner(graph.clips["walk"], QUIET).rotations[frames, 1:]
    assert np.degrees(angle_between(rotations, wanted)).max() < 1e-5


def test_a_cyclic_clip_goes_on_for_ever():
    walks = {sample.name: sample.clip for sample, _ in zip(set_a(), range(2), strict=False)}
    graph = build_graph(walks, threshold=0.3)
    name = next(iter(walks))
    piece, pieces = next_piece(graph, Place(name), name, PLAIN, PIECE), []
    for _ in range(20):
        piece = next_piece(graph, piece.after, name, PLAIN, PIECE)
        pieces.append(piece)
    motion = joined(graph, pieces)
    assert piece.after.frame < walks[name].frames
    steady = walks[name].travel[2] / walks[name].duration
    assert (motion.root_positions[-1, 2] - motion.root_positions[0, 2]) / motion.duration == (
        pytest.approx(steady, rel=0.05)
    )
    assert largest_jump(motion) <= 15.0


def test_what_cannot_be_steered_is_refused(graph):
    with pytest.raises(MotionError, match="no clip “swim”"):
        next_piece(graph, Place("stand"), "swim", PLAIN, PIECE)
    with pytest.raises(MotionError, match="no stance “proud”"):
        next_piece(graph, Place("walk"), "walk", Manner(postures=(("proud", 1.0),)), PIECE)
    with pytest.raises(MotionError, match="reaches from 0 to 2"):
        next_piece(graph, Place("walk", 100), "walk", Manner(path=2.5), PIECE)
    with pytest.raises(MotionError, match="no transition at frame 3"):
        next_piece(graph, Place("walk"), "walk", PLAIN, PIECE, via=("walk", 3, "stand", 4))
    with pytest.raises(MotionError, match="no way leads"):
        next_piece(graph, Place("walk", 420), "stand", PLAIN, PIECE)
