/** One body on the stage, posed by one clip. */
import { Bone, Group, Matrix4, Skeleton, SkinnedMesh, Vector3, Vector4 } from "three";
import type { Body, SolePoint } from "./body";
import { LIMBS } from "./body";
import type { MotionClip, Pose } from "./clip";
import { Disc } from "./ground";
import type { FigureRole, GhostKind, Mode } from "./looks";
import { Clay, ghostDepthMaterial } from "./material";
import { FollowedPath } from "./path";
import { MOST_SOLE_POINTS, MOST_SPHERES } from "./shading";
import type { Tier } from "./statistics";

/** How much of the full contact shade one point of a sole gives; neighbours add up to it. */
const SOLE_STRENGTH = 0.5;

export interface FigureOptions {
  role: FigureRole;
  ghost: GhostKind | null;
  tier: Tier;
  /** x of its place on the stage, metres. */
  place: number;
  discRadius: number;
  /** Toward the key light, unit length; shared with the lights. */
  key: Vector3;
}

export class Figure {
  readonly group = new Group();
  readonly disc: Disc | null;
  private readonly moving = new Group();
  private readonly bones: Bone[];
  private readonly skeleton: Skeleton;
  private readonly mesh: SkinnedMesh;
  private readonly depth: SkinnedMesh | null;
  private readonly clay: Clay;
  private readonly spheres: Vector4[];
  private readonly soles: Vector4[];
  /** What it shows now. */
  readonly pose: Pose;
  private readonly followed = new FollowedPath();
  /** For each joint of the clip its bone, or -1 where the body has none. */
  private readonly links: Int16Array;
  private readonly point = new Vector3();
  private readonly solePoints: SolePoint[];

  constructor(
    private readonly body: Body,
    public clip: MotionClip,
    private readonly options: FigureOptions,
  ) {
    this.pose = clip.makePose();
    this.bones = makeBones(body);
    const byName = new Map(body.joints.map((joint, index) => [joint.name, index]));
    this.links = Int16Array.from(clip.names, (name) => byName.get(name) ?? -1);
    this.skeleton = new Skeleton(
      body.skin.map((joint) => this.bones[joint]!),
      body.inverses,
    );
    this.spheres = body.spheres.slice(0, MOST_SPHERES).map((s) => new Vector4(0, 0, 0, s.radius));
    this.solePoints = someOf(body.soles, MOST_SOLE_POINTS);
    this.soles = this.solePoints.map(() => new Vector4());
    this.clay = this.makeClay();
    this.mesh = this.skinned(this.clay.material);
    this.mesh.renderOrder = options.ghost ? 11 : 0;
    this.depth = options.ghost ? this.skinned(ghostDepthMaterial(options.ghost)) : null;
    if (this.depth) this.depth.renderOrder = 10;
    this.bones.filter((bone) => !bone.parent).forEach((bone) => this.moving.add(bone));
    this.group.add(this.moving);
    this.group.position.x = options.place;
    this.disc = this.makeDisc();
    if (this.disc) this.group.add(this.disc.mesh);
  }

  setMode(mode: Mode): void {
    this.clay.dress(this.options.role, mode);
    this.disc?.setMode(mode);
  }

  /** Where the hips' smoothed path has come to: x and z, metres. */
  get path(): Float32Array {
    return this.pose.path;
  }

  /** Takes the pose of a moment. */
  setTime(seconds: number): void {
    this.clip.sample(seconds, this.pose);
    this.show();
  }

  /** Takes a pose from outside, at a time in seconds: root in metres, rotations xyzw. */
  setPose(root: ArrayLike<number>, rotations: ArrayLike<number>, time: number): void {
    const { pose } = this;
    pose.root.set(root);
    pose.rotations.set(rotations);
    this.followed.follow(root[0]!, root[2]!, time, pose.path);
    this.show();
  }

  /** Takes the very pose of another figure of the same skeleton. */
  copy(pose: Pose): void {
    this.pose.root.set(pose.root);
    this.pose.rotations.set(pose.rotations);
    this.pose.path.set(pose.path);
    this.show();
  }

  /** Poses the bones, the body standing over its place. */
  private show(): void {
    const { pose, bones, links } = this;
    for (let joint = 0; joint < links.length; joint += 1) {
      const bone = bones[links[joint]!];
      bone?.quaternion.fromArray(pose.rotations, joint * 4);
    }
    bones[links[0]!]?.position.fromArray(pose.root);
    this.moving.position.set(-pose.path[0]!, 0, -pose.path[1]!);
    this.group.updateMatrixWorld(true);
    this.placeShade();
  }

  /** World position of each joint of the clip where the motion took it: x y z, metres. */
  jointPositions(): Float32Array {
    const positions = new Float32Array(this.links.length * 3).fill(NaN);
    this.links.forEach((link, joint) => {
      const bone = this.bones[link];
      if (!bone) return;
      this.point.setFromMatrixPosition(bone.matrixWorld);
      this.point.sub(this.group.position).sub(this.moving.position).toArray(positions, joint * 3);
    });
    return positions;
  }

  dispose(): void {
    this.clay.dispose();
    this.disc?.dispose();
    this.skeleton.dispose();
    this.group.removeFromParent();
  }

  private placeShade(): void {
    const { body, bones, spheres, soles, solePoints, point } = this;
    for (let index = 0; index < spheres.length; index += 1) {
      const source = body.spheres[index]!;
      point.copy(source.centre).applyMatrix4(bones[source.joint]!.matrixWorld);
      spheres[index]!.set(point.x, point.y, point.z, source.radius);
    }
    for (let index = 0; index < soles.length; index += 1) {
      const source = solePoints[index]!;
      point.copy(source.point).applyMatrix4(bones[source.joint]!.matrixWorld);
      soles[index]!.set(point.x, point.y, point.z, SOLE_STRENGTH);
    }
  }

  private makeClay(): Clay {
    const { tier, ghost, key } = this.options;
    const shown = this.body.spheres.slice(0, MOST_SPHERES);
    const counts = LIMBS.map((_, limb) => shown.filter((sphere) => sphere.limb === limb).length);
    return new Clay({ spheres: this.spheres, counts, key, tier, ghost });
  }

  /** A ghost stands on another's disc; a figure still awaited has one of its own, without shade. */
  private makeDisc(): Disc | null {
    const { ghost, discRadius, key, tier } = this.options;
    if (ghost === "loading") return new Disc(discRadius, [], [], key, tier);
    return ghost ? null : new Disc(discRadius, this.spheres, this.soles, key, tier);
  }

  private skinned(material: SkinnedMesh["material"]): SkinnedMesh {
    const mesh = new SkinnedMesh(this.body.geometry, material);
    mesh.frustumCulled = false;
    mesh.bind(this.skeleton, new Matrix4());
    this.moving.add(mesh);
    return mesh;
  }
}

function makeBones(body: Body): Bone[] {
  const bones = body.joints.map((joint) => {
    const bone = new Bone();
    bone.name = joint.name;
    bone.position.fromArray(joint.translation);
    bone.quaternion.fromArray(joint.rotation);
    return bone;
  });
  body.joints.forEach((joint, index) => bones[joint.parent]?.add(bones[index]!));
  return bones;
}

/** At most so many of a list, evenly spread. */
function someOf<T>(items: readonly T[], most: number): T[] {
  const step = Math.max(items.length / most, 1);
  return Array.from({ length: Math.min(items.length, most) }, (_, k) => items[Math.floor(k * step)]!);
}
