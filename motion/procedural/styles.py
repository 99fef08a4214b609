"""The styles of the sample library: how emotions and characters walk.

Values are round and our own. Their directions follow studies of emotional gait: Michalak et al.
2009 (sad), Gross et al. 2012, Halovic & Kroos 2018, Roether et al. 2009; of women's and men's
gait: Bruening et al. 2015.
"""

from __future__ import annotations

from motion.procedural.bodies import Body
from motion.procedural.style import Style

NEUTRAL = Style()

# Ten characters, as different as a short set can make them (motion set A).
CHARACTERS: dict[str, Style] = {
    "neutral": NEUTRAL,
    "energetic": NEUTRAL.but(
        cadence=120, stride=1.66, stance=0.595, bounce=1.35, arm_swing=58, elbow=34,
        elbow_swing=28, shoulder_twist=8, lean=4, head_pitch=-3, heel_strike=1.3, push_off=1.1,
        step_width=0.11,
    ),
    "proud": NEUTRAL.but(
        cadence=90, stride=1.48, stance=0.63, lean=-3, chest_pitch=-6, head_pitch=-9, arm_swing=40,
        arm_out=12, shoulder_forward=-8, shoulder_lift=2, shoulder_twist=7, toe_out=14, elbow=24,
        step_width=0.09,
    ),
    "sad": NEUTRAL.but(
        cadence=76, stride=1.08, stance=0.67, bounce=0.65, sway=0.065, lean=5, chest_pitch=9,
        head_pitch=28, arm_swing=9, arm_forward=1, elbow=14, elbow_swing=4, shoulder_forward=9,
        shoulder_lift=-3, shoulder_twist=2, push_off=1.0, heel_strike=0.9, knee_bend=3,
        foot_lift=0.7,
    ),
    "angry": NEUTRAL.but(
        cadence=138, stride=1.56, stance=0.59, lean=14, chest_pitch=5, head_pitch=14, arm_swing=76,
        arm_forward=-17, arm_out=15, elbow=46, elbow_swing=46, shoulder_twist=11, shoulder_lift=5,
        tension=0.5, heaviness=0.5, wrist=25, step_width=0.11, surge=0.16,
    ),
    "old": NEUTRAL.but(
        cadence=94, stride=0.86, stance=0.68, lean=15, chest_pitch=13, head_pitch=10, knee_bend=14,
        push_off=0.7, heel_strike=0.7, foot_lift=0.5, step_width=0.17, toe_out=13, arm_swing=20,
        arm_forward=-6, elbow=38, elbow_swing=8, shoulder_forward=8, sway=0.07, asymmetry=0.05,
        pelvis_yaw=0.6, shoulder_twist=2, bounce=0.8,
    ),
    "timid": NEUTRAL.but(
        cadence=92, stride=0.84, stance=0.68, lean=6, chest_pitch=10, head_pitch=20, arm_swing=5,
        arm_forward=12, arm_out=4, arm_turn=28, elbow=108, elbow_swing=4, wrist=22, shoulder_lift=9,
        shoulder_forward=12, tension=0.7, hesitation=0.5, step_width=0.06, toe_out=1, knee_bend=8,
        bounce=0.6, heel_strike=0.6, foot_lift=0.8,
    ),
    "tired": NEUTRAL.but(
        cadence=92, stride=1.16, stance=0.655, lean=8, chest_pitch=15, head_pitch=30, head_bob=4,
        heaviness=0.9, knee_bend=8, arm_swing=26, arm_forward=4, arm_out=5, elbow=10,
        elbow_swing=8, shoulder_forward=11, shoulder_lift=-4, step_width=0.15, sway=0.075,
        foot_lift=0.55, push_off=0.95, asymmetry=0.05,
    ),
    "childlike": NEUTRAL.but(
        cadence=124, stride=1.24, stance=0.6, bounce=2.6, head_bob=3, head_pitch=-5, arm_swing=54,
        arm_out=20, elbow=48, elbow_swing=26, shoulder_twist=15, pelvis_yaw=1.2, step_width=0.15,
        foot_lift=1.9, push_off=0.8, toe_out=4, side_lean=4,
    ),
    "swaggering": NEUTRAL.but(
        cadence=100, stride=1.42, stance=0.62, step_width=0.21, toe_out=20, sway=0.10, side_lean=6,
        shoulder_twist=-10, pelvis_yaw=1.8, arm_swing=48, arm_out=22, elbow=32, elbow_swing=18,
        knee_bend=7, head_pitch=8, chest_pitch=4, lean=2, heaviness=0.4, shoulder_lift=3,
    ),
}  # fmt: skip

# Russell's circle of affect, eight points and the middle (motion set B).
AFFECTS: dict[str, Style] = {
    "excitement": NEUTRAL.but(
        cadence=126, stride=1.62, stance=0.585, bounce=1.5, arm_swing=64, elbow=56, elbow_swing=40,
        arm_out=14, shoulder_twist=10, head_pitch=-7, chest_pitch=-3, foot_lift=1.3, head_bob=2,
    ),
    "pleasure": NEUTRAL.but(
        cadence=112, stride=1.56, stance=0.59, bounce=1.45, arm_swing=48, elbow=26,
        elbow_swing=26, arm_out=10, shoulder_twist=7, pelvis_roll=1.25, head_pitch=-6,
        chest_pitch=-3, side_lean=2,
    ),
    "contentment": NEUTRAL.but(
        cadence=98, stride=1.44, stance=0.62, bounce=0.95, arm_swing=36, elbow=18, arm_out=8,
        shoulder_twist=3, head_pitch=-2, chest_pitch=-2, sway=0.055, side_lean=2.5, lean=1,
        pelvis_roll=1.15,
    ),
    "sleepiness": NEUTRAL.but(
        cadence=78, stride=1.02, stance=0.67, bounce=0.6, sway=0.085, side_lean=4, lean=3,
        chest_pitch=8, head_pitch=24, head_bob=5, arm_swing=14, arm_forward=2, elbow=9,
        elbow_swing=4, shoulder_lift=-4, shoulder_forward=6, foot_lift=0.45, heel_strike=0.6,
        push_off=0.9, knee_bend=7, step_width=0.13, asymmetry=0.05,
    ),
    "depression": NEUTRAL.but(
        cadence=80, stride=1.04, stance=0.67, bounce=0.55, sway=0.06, lean=8, chest_pitch=13,
        head_pitch=33, arm_swing=7, arm_forward=3, arm_out=4, elbow=12, elbow_swing=3,
        shoulder_forward=13, shoulder_lift=-4, shoulder_twist=1.5, pelvis_yaw=0.6, push_off=0.95,
        heel_strike=0.7, foot_lift=0.6, knee_bend=5,
    ),
    "misery": NEUTRAL.but(
        cadence=88, stride=1.12, stance=0.655, bounce=0.8, sway=0.07, lean=12, chest_pitch=16,
        head_pitch=26, heaviness=1.0, arm_swing=12, arm_forward=10, arm_out=3, arm_turn=42,
        elbow=44, elbow_swing=6, shoulder_forward=15, shoulder_lift=3, tension=0.4, knee_bend=9,
        push_off=0.95, foot_lift=0.7, asymmetry=0.04,
    ),
    "distress": NEUTRAL.but(
        cadence=124, stride=1.18, stance=0.61, lean=9, chest_pitch=6, head_pitch=6, head_bob=2.5,
        arm_swing=18, arm_forward=4, arm_out=14, arm_turn=34, elbow=100, elbow_swing=22,
        shoulder_lift=10, shoulder_forward=7, tension=0.8, hesitation=0.35, asymmetry=0.05,
        step_width=0.08, knee_bend=4,
    ),
    "arousal": NEUTRAL.but(
        cadence=130, stride=1.46, stance=0.595, lean=6, chest_pitch=-4, head_pitch=-4, arm_swing=46,
        arm_out=12, elbow=66, elbow_swing=24, shoulder_lift=5, shoulder_twist=7, tension=0.5,
        bounce=1.1, wrist=15,
    ),
    # Not the neutral of set A again: equal clips would be one clip in the library.
    "neutral": NEUTRAL.but(cadence=106, stride=1.46, arm_swing=31),
}  # fmt: skip

# Förger's ten acted emotions; distinct from the circle's because they also stand and knock.
# The neutral one leads: a body's figure learns its joints' axes from its first clip, and learns
# them best where the arms hang.
ACTED: dict[str, Style] = {
    "neutral": NEUTRAL,
    "afraid": CHARACTERS["timid"].but(
        cadence=112, stride=0.92, stance=0.65, hesitation=0.45, head_pitch=8, head_bob=2,
        knee_bend=12, elbow=116, arm_forward=2, arm_turn=27, lean=4, wrist=24,
    ),
    "angry": CHARACTERS["angry"],
    "excited": AFFECTS["excitement"],
    "happy": AFFECTS["pleasure"].but(cadence=116, bounce=1.55, arm_swing=54, side_lean=3),
    "relaxed": AFFECTS["contentment"].but(cadence=92, lean=-1, sway=0.065, elbow=16, toe_out=11),
    "sad": CHARACTERS["sad"],
    "strong": NEUTRAL.but(
        cadence=100, stride=1.6, stance=0.615, step_width=0.17, toe_out=13, arm_swing=44,
        arm_out=24, arm_turn=30, elbow=34, elbow_swing=16, shoulder_twist=9, shoulder_lift=3,
        shoulder_forward=-5, chest_pitch=-6, head_pitch=-3, lean=2, heaviness=0.5, side_lean=4,
        tension=0.3, sway=0.07, wrist=22,
    ),
    "tired": CHARACTERS["tired"],
    "weak": NEUTRAL.but(
        cadence=88, stride=0.96, stance=0.67, bounce=0.7, lean=4, chest_pitch=7, head_pitch=13,
        arm_swing=12, arm_out=2, elbow=26, elbow_swing=5, shoulder_forward=8, shoulder_lift=-2,
        knee_bend=11, foot_lift=0.5, push_off=0.9, heel_strike=0.6, step_width=0.11, sway=0.08,
        side_lean=4, pelvis_yaw=0.7, shoulder_twist=2, asymmetry=0.04,
    ),
}  # fmt: skip

SPEEDS: dict[str, tuple[float, float]] = {
    # Factors of cadence and stride; people change both in about the same measure.
    "fast": (1.17, 1.10),
    "normal": (1.0, 1.0),
    "slow": (0.80, 0.87),
}


def at_speed(style: Style, speed: str) -> Style:
    """The style walked faster or slower: stance and arm swing go with the speed."""
    cadence, stride = SPEEDS[speed]
    pace = cadence * stride
    return style.but(
        cadence=style.cadence * cadence,
        stride=min(style.stride * stride, 1.78),
        stance=style.stance - 0.055 * (pace - 1.0),
        bounce=style.bounce / max(pace, 1.0) ** 1.3,
        arm_swing=style.arm_swing * (0.5 + 0.5 * pace),
        shoulder_twist=style.shoulder_twist * (0.4 + 0.6 * pace),
        pelvis_yaw=style.pelvis_yaw * (0.5 + 0.5 * pace),
        pelvis_roll=style.pelvis_roll * (0.5 + 0.5 * pace),
        lean=style.lean + 4.0 * (pace - 1.0),
    )


def for_body(style: Style, body: Body) -> Style:
    """The style as a woman or a man walks it; other bodies keep it."""
    if body.name == "female":
        return style.but(
            pelvis_roll=style.pelvis_roll * 1.3,
            pelvis_yaw=style.pelvis_yaw * 1.2,
            shoulder_twist=style.shoulder_twist * 1.3,
            arm_swing=style.arm_swing * 1.15,
            step_width=style.step_width * 0.8,
            cadence=style.cadence * 1.03,
            arm_turn=style.arm_turn - 6.0,
        )
    if body.name == "male":
        return style.but(
            pelvis_roll=style.pelvis_roll * 0.75,
            pelvis_yaw=style.pelvis_yaw * 0.85,
            shoulder_twist=style.shoulder_twist * 0.85,
            arm_swing=style.arm_swing * 0.92,
            step_width=style.step_width * 1.2,
            side_lean=style.side_lean + 1.2,
            arm_out=style.arm_out + 3.0,
            toe_out=style.toe_out + 3.0,
        )
    return style
