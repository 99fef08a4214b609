/** A motion as the viewer plays it: evenly spaced poses, sampled at any moment. */
import { Glb, GlbError } from "./glb";
import { smoothPath } from "./path";

/** One pose. Made once and written over in every frame. */
export interface Pose {
  /** Local rotation of each joint, xyzw. */
  rotations: Float32Array;
  /** Position of the root, metres. */
  root: Float32Array;
  /** Where the hips' smoothed path is at this moment: x and z, metres. */
  path: Float32Array;
}

export interface ClipData {
  names: string[];
  parents: Int16Array;
  offsets: Float32Array;
  rotations: Float32Array;
  roots: Float32Array;
  frameTime: number;
  cyclic: boolean;
}

export class MotionClip {
  readonly names: string[];
  readonly parents: Int16Array;
  readonly offsets: Float32Array;
  readonly frameTime: number;
  readonly cyclic: boolean;
  readonly frames: number;
  readonly duration: number;
  /** Way of the root over the whole clip, x y z. */
  readonly travel: Float32Array;
  private readonly rotations: Float32Array;
  private readonly roots: Float32Array;
  private readonly path: Float32Array;

  constructor(data: ClipData) {
    this.names = data.names;
    this.parents = data.parents;
    this.offsets = data.offsets;
    this.rotations = data.rotations;
    this.roots = data.roots;
    this.frameTime = data.frameTime;
    this.frames = data.roots.length / 3;
    this.cyclic = data.cyclic && this.frames > 1;
    this.duration = Math.max(this.frames - 1, 0) * data.frameTime;
    const last = data.roots.length - 3;
    this.travel = Float32Array.from([0, 1, 2], (axis) => data.roots[last + axis]! - data.roots[axis]!);
    keepSigns(this.rotations, this.names.length);
    this.path = smoothPath(this.roots, this.frameTime, this.cyclic);
  }

  makePose(): Pose {
    return {
      rotations: new Float32Array(this.names.length * 4),
      root: new Float32Array(3),
      path: new Float32Array(2),
    };
  }

  /**
   * The pose at a moment. A cyclic clip goes on for ever: each cycle begins where the last one
   * ended, so that nothing jumps. Other clips hold their first and last frame.
   */
  sample(time: number, pose: Pose): void {
    const cycle = this.cyclic ? Math.floor(time / this.duration) : 0;
    const within = Math.min(Math.max(time - cycle * this.duration, 0), this.duration);
    const exact = this.duration > 0 ? within / this.frameTime : 0;
    const frame = Math.min(Math.floor(exact), Math.max(this.frames - 2, 0));
    const next = Math.min(frame + 1, this.frames - 1);
    const blend = exact - frame;
    this.blendRotations(frame, next, blend, pose.rotations);
    for (let axis = 0; axis < 3; axis += 1) {
      const from = this.roots[frame * 3 + axis]!;
      const to = this.roots[next * 3 + axis]!;
      pose.root[axis] = from + (to - from) * blend + cycle * this.travel[axis]!;
    }
    for (let axis = 0; axis < 2; axis += 1) {
      const from = this.path[frame * 2 + axis]!;
      const to = this.path[next * 2 + axis]!;
      pose.path[axis] = from + (to - from) * blend + cycle * this.travel[axis * 2]!;
    }
  }

  private blendRotations(frame: number, next: number, blend: number, out: Float32Array): void {
    const from = frame * out.length;
    const to = next * out.length;
    for (let at = 0; at < out.length; at += 4) slerp(this.rotations, from + at, to + at, blend, out, at);
  }
}

/** Shortest way between two unit quaternions of one array; their signs already agree. */
function slerp(
  values: Float32Array,
  from: number,
  to: number,
  blend: number,
  out: Float32Array,
  at: number,
): void {
  let cosine = 0;
  for (let k = 0; k < 4; k += 1) cosine += values[from + k]! * values[to + k]!;
  let first = 1 - blend;
  let second = blend;
  if (cosine < 0.9995) {
    const angle = Math.acos(Math.max(cosine, -1));
    const sine = Math.sin(angle);
    first = Math.sin(first * angle) / sine;
    second = Math.sin(second * angle) / sine;
  }
  let length = 0;
  for (let k = 0; k < 4; k += 1) {
    const value = first * values[from + k]! + second * values[to + k]!;
    out[at + k] = value;
    length += value * value;
  }
  const scale = length > 0 ? 1 / Math.sqrt(length) : 1;
  for (let k = 0; k < 4; k += 1) out[at + k] = out[at + k]! * scale;
}

/** Gives neighbouring frames the same one of a rotation's two signs. */
function keepSigns(rotations: Float32Array, joints: number): void {
  const width = joints * 4;
  for (let at = width; at < rotations.length; at += 4) {
    let cosine = 0;
    for (let k = 0; k < 4; k += 1) cosine += rotations[at + k]! * rotations[at - width + k]!;
    if (cosine < 0) for (let k = 0; k < 4; k += 1) rotations[at + k] = -rotations[at + k]!;
  }
}

/** Metres by which two skeletons' bones may differ and still be the same. */
const SAME_BONE = 0.001;

/** Makes sure that one clip can take another's place. Throws GlbError naming what differs. */
export function demandSameSkeleton(clip: MotionClip, old: MotionClip): void {
  if (clip.names.length !== old.names.length) {
    throw new GlbError(
      `The motion has ${clip.names.length} joints, the figure has ${old.names.length}.`,
    );
  }
  old.names.forEach((name, joint) => {
    if (clip.names[joint] !== name) {
      throw new GlbError(
        `The motion is for another skeleton: its joint ${joint + 1} is “${clip.names[joint]}”, ` +
          `the figure’s is “${name}”.`,
      );
    }
    const apart = [0, 1, 2].map((k) => clip.offsets[joint * 3 + k]! - old.offsets[joint * 3 + k]!);
    // The root's own offset is where its motion begins.
    if (old.parents[joint]! >= 0 && Math.hypot(...apart) > SAME_BONE) {
      throw new GlbError(`The motion is for another body: its bone to “${name}” is not as long.`);
    }
  });
}

/** Takes the animation out of a file. Throws GlbError when it has none. */
export function readClip(glb: Glb): MotionClip {
  const animation = glb.json.animations?.[0];
  if (!animation) throw new GlbError("The file holds no motion.");
  const extras = glb.extras;
  const animated = new Set(animation.channels.map((channel) => channel.target.node));
  const listed = (extras["names"] as string[] | undefined) ?? [];
  const byName = new Map(glb.nodes.map((node, index) => [node.name ?? `node ${index}`, index]));
  const nodes = listed.length
    ? listed.map((name) => byName.get(name) ?? -1)
    : [...animated].sort((a, b) => a - b);
  if (nodes.includes(-1)) throw new GlbError("A joint of the motion has no node.");
  const times = glb.floats(animation.samplers[0]!.input);
  const frames = (extras["frames"] as number | undefined) ?? times.length;
  const frameTime =
    (extras["frame_time"] as number | undefined) ??
    (frames > 1 ? (times.at(-1)! - times[0]!) / (frames - 1) : 1 / 30);
  const place = new Map(nodes.map((node, index) => [node, index]));
  const allParents = glb.parents();
  return new MotionClip({
    names: nodes.map((node) => glb.nodes[node]!.name ?? `node ${node}`),
    parents: Int16Array.from(nodes, (node) => place.get(allParents[node]!) ?? -1),
    offsets: Float32Array.from(nodes.flatMap((node) => glb.nodes[node]!.translation ?? [0, 0, 0])),
    frameTime,
    cyclic: extras["cyclic"] === true,
    ...readChannels(glb, nodes, frames, frameTime),
  });
}

function readChannels(glb: Glb, nodes: number[], frames: number, frameTime: number) {
  const rotations = new Float32Array(frames * nodes.length * 4);
  const roots = new Float32Array(frames * 3);
  const rest = glb.nodes.map((node) => node.rotation ?? [0, 0, 0, 1]);
  const place = new Map(nodes.map((node, index) => [node, index]));
  nodes.forEach((node, joint) => fill(rotations, rest[node]!, joint * 4, nodes.length * 4));
  fill(roots, glb.nodes[nodes[0]!]!.translation ?? [0, 0, 0], 0, 3);
  const animation = glb.json.animations![0]!;
  const clocks = new Map<number, Float32Array>();
  for (const { sampler, target } of animation.channels) {
    const joint = place.get(target.node);
    if (joint === undefined) continue;
    const { input, output } = animation.samplers[sampler]!;
    const times = clocks.get(input) ?? glb.floats(input);
    clocks.set(input, times);
    const values = glb.floats(output);
    if (target.path === "rotation") {
      spread(times, values, 4, frameTime, rotations, joint * 4, nodes.length * 4);
    } else if (target.path === "translation" && joint === 0) {
      spread(times, values, 3, frameTime, roots, 0, 3);
    }
  }
  return { rotations, roots };
}

function fill(out: Float32Array, value: number[], first: number, stride: number): void {
  for (let at = first; at < out.length; at += stride) out.set(value, at);
}

/** Copies a channel's keys to even frames; a channel with fewer keys is held between them. */
function spread(
  times: Float32Array,
  values: Float32Array,
  size: number,
  frameTime: number,
  out: Float32Array,
  first: number,
  stride: number,
): void {
  let key = 0;
  for (let frame = 0, at = first; at < out.length; frame += 1, at += stride) {
    const time = times[0]! + (frame + 0.5) * frameTime;
    while (key + 1 < times.length && times[key + 1]! < time) key += 1;
    for (let k = 0; k < size; k += 1) out[at + k] = values[key * size + k]!;
  }
}
