/** The body of a skeleton as loaded: mesh, joints, and the spheres and soles that shade it. */
import { BufferAttribute, BufferGeometry, Matrix4, Vector3 } from "three";
import { Glb, GlbError } from "./glb";

/** The parts of a body that shade one another, in the order in which the shader knows them. */
export const LIMBS = ["torso", "head", "left_arm", "right_arm", "left_leg", "right_leg"] as const;

export interface ShadeSphere {
  joint: number;
  centre: Vector3;
  radius: number;
  limb: number;
}

export interface SolePoint {
  joint: number;
  point: Vector3;
}

export interface BodyJoint {
  name: string;
  parent: number;
  translation: [number, number, number];
  rotation: [number, number, number, number];
}

export interface Body {
  geometry: BufferGeometry;
  /** Every node of the file's skeleton, parents first. */
  joints: BodyJoint[];
  /** For each bone of the skin: its joint and the inverse of its bind pose. */
  skin: number[];
  inverses: Matrix4[];
  /** Sorted by limb. */
  spheres: ShadeSphere[];
  soles: SolePoint[];
  stature: number;
  roles: Record<string, string>;
}

const STANDARD_STATURE = 1.58;
const ATTRIBUTES: Record<string, string> = {
  POSITION: "position",
  NORMAL: "normal",
  JOINTS_0: "skinIndex",
  WEIGHTS_0: "skinWeight",
  _OCCLUSION: "openness",
};

/** Takes the figure out of a file. Throws GlbError when it has no skinned mesh. */
export function readBody(glb: Glb): Body {
  const skin = glb.json.skins?.[0];
  const primitive = glb.json.meshes?.[0]?.primitives[0];
  if (!skin || !primitive) throw new GlbError("The file holds no figure.");
  const { order, joints } = readJoints(glb, skin.joints);
  const place = new Map(order.map((node, index) => [node, index]));
  const names = new Map(joints.map((joint, index) => [joint.name, index]));
  const matrices = glb.floats(skin.inverseBindMatrices);
  const bones = skin.joints.map((node) => place.get(node)!);
  const spheres = readSpheres(glb.extras, names);
  const geometry = readGeometry(glb, primitive);
  addLimbShares(geometry, bones, limbOfJoints(joints, glb.extras));
  return {
    geometry,
    joints,
    skin: bones,
    inverses: bones.map((_, index) => new Matrix4().fromArray(matrices, index * 16)),
    spheres,
    soles: readSoles(glb.extras, names),
    stature: (glb.extras["stature"] as number | undefined) ?? STANDARD_STATURE,
    roles: (glb.extras["roles"] as Record<string, string> | undefined) ?? {},
  };
}

/** The skin's nodes and whatever lies above or below them, parents first. */
function readJoints(glb: Glb, skinned: number[]): { order: number[]; joints: BodyJoint[] } {
  const parents = glb.parents();
  const wanted = new Set<number>();
  for (const node of skinned) {
    for (let at = node; at >= 0 && !wanted.has(at); at = parents[at]!) wanted.add(at);
  }
  const order: number[] = [];
  const visit = (node: number) => {
    if (glb.nodes[node]!.mesh === undefined) order.push(node);
    glb.nodes[node]!.children?.forEach(visit);
  };
  [...wanted].filter((node) => parents[node]! < 0).forEach(visit);
  const place = new Map(order.map((node, index) => [node, index]));
  const joints = order.map((node) => ({
    name: glb.nodes[node]!.name ?? `node ${node}`,
    parent: place.get(parents[node]!) ?? -1,
    translation: glb.nodes[node]!.translation ?? ([0, 0, 0] as [number, number, number]),
    rotation: glb.nodes[node]!.rotation ?? ([0, 0, 0, 1] as [number, number, number, number]),
  }));
  return { order, joints };
}

function readGeometry(
  glb: Glb,
  primitive: { attributes: Record<string, number>; indices?: number },
): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const [key, name] of Object.entries(ATTRIBUTES)) {
    const index = primitive.attributes[key];
    if (index === undefined) {
      if (key === "_OCCLUSION") continue;
      throw new GlbError(`The figure's mesh has no ${key}.`);
    }
    const { array, itemSize, normalized } = glb.accessor(index);
    geometry.setAttribute(name, new BufferAttribute(array, itemSize, normalized));
  }
  if (primitive.indices !== undefined) {
    geometry.setIndex(new BufferAttribute(glb.accessor(primitive.indices).array, 1));
  }
  return geometry;
}

function readSpheres(extras: Record<string, unknown>, names: Map<string, number>): ShadeSphere[] {
  const stored = (extras["spheres"] ?? []) as {
    node: string;
    centre: number[];
    radius: number;
    limb: string;
  }[];
  return stored
    .filter((sphere) => names.has(sphere.node))
    .map((sphere) => ({
      joint: names.get(sphere.node)!,
      centre: new Vector3().fromArray(sphere.centre),
      radius: sphere.radius,
      limb: Math.max(LIMBS.indexOf(sphere.limb as (typeof LIMBS)[number]), 0),
    }))
    .sort((a, b) => a.limb - b.limb);
}

function readSoles(extras: Record<string, unknown>, names: Map<string, number>): SolePoint[] {
  const stored = (extras["soles"] ?? []) as { node: string; points: number[][] }[];
  return stored
    .filter((sole) => names.has(sole.node))
    .flatMap(({ node, points }) =>
      points.map((p) => ({ joint: names.get(node)!, point: new Vector3().fromArray(p) })),
    );
}

/** A joint of no named limb belongs to the one of its parent. */
function limbOfJoints(joints: BodyJoint[], extras: Record<string, unknown>): number[] {
  const named = (extras["limbs"] ?? {}) as Record<string, string>;
  const limbs: number[] = [];
  joints.forEach((joint, index) => {
    const own = LIMBS.indexOf(named[joint.name] as (typeof LIMBS)[number]);
    limbs[index] = own >= 0 ? own : (limbs[joint.parent] ?? 0);
  });
  return limbs;
}

/** Two attributes that say how much of a vertex belongs to each limb: no hard seam between them. */
function addLimbShares(geometry: BufferGeometry, bones: number[], limbs: number[]): void {
  const indices = geometry.getAttribute("skinIndex");
  const weights = geometry.getAttribute("skinWeight");
  const shares = new Float32Array(LIMBS.length);
  const upper = new Uint8Array(indices.count * 4);
  const lower = new Uint8Array(indices.count * 4);
  for (let vertex = 0; vertex < indices.count; vertex += 1) {
    shares.fill(0);
    for (let k = 0; k < 4; k += 1) {
      const limb = limbs[bones[indices.getComponent(vertex, k)] ?? 0] ?? 0;
      shares[limb] = shares[limb]! + weights.getComponent(vertex, k);
    }
    for (let k = 0; k < 3; k += 1) {
      upper[vertex * 4 + k] = Math.round(255 * Math.min(shares[k]!, 1));
      lower[vertex * 4 + k] = Math.round(255 * Math.min(shares[k + 3]!, 1));
    }
  }
  geometry.setAttribute("limbsA", new BufferAttribute(upper, 4, true));
  geometry.setAttribute("limbsB", new BufferAttribute(lower, 4, true));
}
