/** A body at ease: what is shown, pale, before its motion has arrived. */
import { MathUtils, Quaternion, Vector3 } from "three";
import type { Body } from "./body";
import { MotionClip } from "./clip";

/** Degrees by which the bind pose's spread limbs are brought in; a foot stays level. */
const TURNS: Record<string, number> = { upper_arm: 36, thigh: 11, foot: -11 };
/** Closed legs reach farther down than spread ones, by this share of the stature. */
const RISE = 0.009;
const FORWARD = new Vector3(0, 0, 1);

/** One frame of the bind pose with arms and legs brought in. */
export function standingClip(body: Body): MotionClip {
  const turns = turnsByJoint(body);
  const rotations = new Float32Array(body.joints.length * 4);
  const bound: Quaternion[] = [];
  body.joints.forEach((joint, index) => {
    const local = new Quaternion().fromArray(joint.rotation);
    const parent = bound[joint.parent] ?? new Quaternion();
    bound[index] = parent.clone().multiply(local);
    const turn = new Quaternion().setFromAxisAngle(FORWARD, turns.get(joint.name) ?? 0);
    // The turn is about the world's axis: carried over into the parent's frame and back.
    parent.clone().invert().multiply(turn).multiply(bound[index]).toArray(rotations, index * 4);
  });
  const [x, y, z] = body.joints[0]!.translation;
  return new MotionClip({
    names: body.joints.map((joint) => joint.name),
    parents: Int16Array.from(body.joints, (joint) => joint.parent),
    offsets: Float32Array.from(body.joints.flatMap((joint) => joint.translation)),
    rotations,
    roots: Float32Array.of(x, y + RISE * body.stature, z),
    frameTime: 1 / 30,
    cyclic: false,
  });
}

/** Radians about the forward axis: inward is the other way round on the right. */
function turnsByJoint(body: Body): Map<string, number> {
  const turns = new Map<string, number>();
  for (const [part, degrees] of Object.entries(TURNS)) {
    const angle = MathUtils.degToRad(degrees);
    const left = body.roles[`left_${part}`];
    const right = body.roles[`right_${part}`];
    if (left) turns.set(left, -angle);
    if (right) turns.set(right, angle);
  }
  return turns;
}
