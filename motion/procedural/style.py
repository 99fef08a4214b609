"""What makes one walk different from another: the knobs of the generator."""

from __future__ import annotations

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Style:
    """A way of walking; the defaults are a calm, neutral adult.

    Angles in degrees, lengths in metres unless said; "gain" multiplies the published curve.

    Attributes:
        cadence: steps per minute.
        stride: length of two steps, as a multiple of the leg.
        step_width: distance of the ankles sideways.
        toe_out: feet turned out.
        stance: share of the cycle a foot is on the ground.
        bounce: gain of the hips' rise and fall.
        sway: range of the hips from side to side.
        surge: how much the forward speed varies, share of the mean.
        knee_bend: added to the knees while they carry.
        foot_lift: gain of the soles' clearance in swing.
        heel_strike: gain of the toes' lift at contact.
        push_off: gain of the heel's lift at the end of stance.
        pelvis_yaw: gain.
        pelvis_roll: gain.
        shoulder_twist: amplitude of the chest's turn against the pelvis.
        lean: trunk forward of upright.
        chest_pitch: upper back bent forward beyond the lean.
        side_lean: trunk towards the standing leg, amplitude.
        head_pitch: nose down.
        head_bob: amplitude of the head's nod with each step.
        arm_swing: range of the upper arm.
        arm_forward: mean of the upper arm, forward of the vertical.
        arm_out: upper arm away from the body.
        arm_turn: upper arm turned inward, so that a bent forearm points across the body.
        elbow: mean bend.
        elbow_swing: range of the bend.
        wrist: hand bent towards the palm.
        shoulder_lift: collar bones raised.
        shoulder_forward: collar bones drawn forward.
        tension: 0 loose to 1 stiff: less follow-through, less twist, held shoulders.
        hesitation: 0 even to 1: lingers before each foot is set down.
        asymmetry: share by which left and right steps and arms differ.
        heaviness: 0 to 1: how much the trunk dips after each contact.
    """

    cadence: float = 110.0
    stride: float = 1.48
    step_width: float = 0.095
    toe_out: float = 7.0
    stance: float = 0.60
    bounce: float = 1.0
    sway: float = 0.045
    surge: float = 0.12
    knee_bend: float = 0.0
    foot_lift: float = 1.0
    heel_strike: float = 1.15
    push_off: float = 1.0
    pelvis_yaw: float = 1.0
    pelvis_roll: float = 1.0
    shoulder_twist: float = 4.0
    lean: float = 3.0
    chest_pitch: float = 0.0
    side_lean: float = 1.2
    head_pitch: float = 2.0
    head_bob: float = 1.0
    arm_swing: float = 34.0
    arm_forward: float = -2.0
    arm_out: float = 8.5
    arm_turn: float = 16.0
    elbow: float = 22.0
    elbow_swing: float = 15.0
    wrist: float = 8.0
    shoulder_lift: float = 0.0
    shoulder_forward: float = 0.0
    tension: float = 0.0
    hesitation: float = 0.0
    asymmetry: float = 0.015
    heaviness: float = 0.0

    def but(self, **changes: float) -> Style:
        """The same style with some knobs set differently."""
        return replace(self, **changes)
