/** How much room a motion takes, so that no head, hand or foot is ever cut off. */
import { Matrix4, Quaternion, Vector3 } from "three";
import type { MotionClip } from "./clip";

export interface Extent {
  /** Highest point, metres. */
  top: number;
  /** Farthest point from the followed path, metres. */
  reach: number;
}

/** What lies beyond the outermost joint: a hand beyond its wrist, a crown above the head's joint. */
const BEYOND = 0.19;
const MOST_POSES = 60;

const known = new WeakMap<MotionClip, Extent>();

export function clipExtent(clip: MotionClip): Extent {
  let extent = known.get(clip);
  if (!extent) known.set(clip, (extent = measure(clip)));
  return extent;
}

function measure(clip: MotionClip): Extent {
  const pose = clip.makePose();
  const world = clip.names.map(() => new Matrix4());
  const place = new Vector3();
  const turn = new Quaternion();
  const one = new Vector3(1, 1, 1);
  const extent = { top: 0, reach: 0 };
  const count = Math.min(clip.frames, MOST_POSES);
  for (let index = 0; index < count; index += 1) {
    clip.sample((clip.duration * index) / Math.max(count - 1, 1), pose);
    clip.names.forEach((_, joint) => {
      const parent = clip.parents[joint]!;
      place.fromArray(parent < 0 ? pose.root : clip.offsets, parent < 0 ? 0 : joint * 3);
      turn.fromArray(pose.rotations, joint * 4);
      world[joint]!.compose(place, turn, one);
      if (parent >= 0) world[joint]!.premultiply(world[parent]!);
      place.setFromMatrixPosition(world[joint]!);
      const away = Math.hypot(place.x - pose.path[0]!, place.z - pose.path[1]!);
      extent.top = Math.max(extent.top, place.y + BEYOND);
      extent.reach = Math.max(extent.reach, away + BEYOND);
    });
  }
  return extent;
}
