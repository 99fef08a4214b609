/** A scene with its figures, lights, floor and camera: everything that one view draws. */
import { Scene, Vector3 } from "three";
import type { Body } from "./body";
import { OrbitCamera, type Frame, type Subject } from "./camera";
import { demandSameSkeleton, type MotionClip } from "./clip";
import { Figure } from "./figure";
import { Disc, Floor } from "./ground";
import { Lights } from "./lights";
import { looks, type FigureRole, type GhostKind, type Mode } from "./looks";
import type { Area, Surface } from "./renderer";
import { clipExtent } from "./extent";
import type { Tier } from "./statistics";

export interface Performer {
  clip: MotionClip;
  body: Body;
  role: FigureRole;
  ghost: GhostKind | null;
}

/** Ghosts behind as the page wants them, all side by side, one alone, or each in a cell of its own. */
export const ARRANGEMENTS = ["ghost", "beside", "one", "cells"] as const;
export type Arrangement = (typeof ARRANGEMENTS)[number];

/** Half the distance between two figures side by side, metres: the pair's discs just part. */
const HALF_GAP = 0.55;
const DISC_MARGIN = 0.04;
const STANDARD_STATURE = 1.58;

export class Stage {
  readonly orbit = new OrbitCamera();
  figures: Figure[] = [];
  /** The others are as far through their clips as the first figure is through its own. */
  inStep = false;
  private readonly scene = new Scene();
  private readonly lights = new Lights();
  private readonly floor = new Floor();
  private readonly point = new Vector3();
  private performers: Performer[] = [];
  private arrangement: Arrangement = "ghost";
  private readonly hidden = new Set<number>();
  /** The figures of each arrangement shown so far: coming back to one makes nothing anew. */
  private readonly built = new Map<Arrangement, Figure[]>();
  private mode: Mode = "light";
  private tier: Tier = "full";
  private azimuth: number | null = null;
  /** Whose way the grid shows: the last figure with a place of its own, the judged one of a pair. */
  private leader: Figure | undefined;
  private bareDisc: Disc | null = null;
  /** Where each figure is drawn when each has a cell: all of one size. */
  private cells: readonly Area[] = [];

  constructor(readonly surface: Surface) {
    this.scene.add(this.lights.group, this.floor.mesh);
    this.setMode("light");
    this.cast([]);
  }

  /** Puts figures on the stage. Their clips begin at their first pose. */
  cast(performers: Performer[]): void {
    this.performers = performers;
    this.hidden.clear();
    this.rebuild();
    this.setTime(0);
    this.orbit.setSubject(this.subject(), this.homeAzimuth);
    this.orbit.jump(this.homeAzimuth);
  }

  /**
   * Gives a figure another motion. Nothing is built anew; the camera steps back if it must.
   * Throws GlbError when the motion is not for the figure's skeleton.
   */
  setMotion(index: number, clip: MotionClip, still: boolean): void {
    const performer = this.performers[index];
    if (!performer) throw new RangeError(this.nobody(index));
    demandSameSkeleton(clip, performer.clip);
    this.performers[index] = { ...performer, clip };
    for (const figures of this.built.values()) figures[index]!.clip = clip;
    this.orbit.makeRoom(this.subject(), still);
  }

  /** Poses one figure from outside at a time in seconds; the grid goes with its smoothed way. */
  setPose(
    index: number,
    root: ArrayLike<number>,
    rotations: ArrayLike<number>,
    time: number,
  ): void {
    const figure = this.figures[index];
    if (!figure) throw new RangeError(this.nobody(index));
    const joints = figure.clip.names.length;
    if (root.length !== 3 || rotations.length !== 4 * joints) {
      throw new RangeError(
        `A pose of figure ${index} is 3 and ${4 * joints} numbers (${joints} joints), ` +
          `not ${root.length} and ${rotations.length}.`,
      );
    }
    figure.setPose(root, rotations, time);
    figure.disc?.roam();
    this.floor.roam();
    this.travel();
  }

  /** Places the figures otherwise. The view stays where a person has turned it. */
  arrange(arrangement: Arrangement): void {
    if (arrangement === this.arrangement) return;
    const { moved } = this.orbit;
    this.arrangement = arrangement;
    this.enter();
    this.orbit.setSubject(this.subject(), this.homeAzimuth);
    if (!moved) this.orbit.jump(this.homeAzimuth);
  }

  setShown(index: number, shown: boolean): void {
    if (shown) this.hidden.delete(index);
    else this.hidden.add(index);
    this.show();
  }

  /** Whether a figure is on view; of several alone in one place, the first that is shown. */
  isSeen(index: number): boolean {
    if (this.hidden.has(index)) return false;
    if (this.arrangement !== "one") return true;
    return this.performers.findIndex((_, k) => !this.hidden.has(k)) === index;
  }

  /** How a figure is drawn where it stands now. A figure still awaited is pale anywhere. */
  ghostOf(index: number): GhostKind | null {
    const ghost = this.performers[index]?.ghost ?? null;
    return ghost === "loading" || this.arrangement === "ghost" ? ghost : null;
  }

  setMode(mode: Mode): void {
    this.mode = mode;
    this.lights.setMode(mode);
    this.floor.setMode(mode);
    this.bareDisc?.setMode(mode);
    for (const figure of this.figures) figure.setMode(mode);
  }

  setTier(tier: Tier): void {
    if (tier === this.tier) return;
    this.tier = tier;
    const poses = this.figures.map(({ pose }) => pose);
    this.rebuild();
    poses.forEach((pose, index) => this.figures[index]!.copy(pose));
  }

  /** The standard view of this stage where it is not the usual one, in degrees. */
  setAzimuth(azimuth: number | null): void {
    this.azimuth = azimuth;
    this.light();
    this.orbit.setSubject(this.subject(), this.homeAzimuth);
    this.orbit.jump(this.homeAzimuth);
  }

  setFrame(frame: Frame): void {
    this.orbit.setFrame(frame);
  }

  setCells(cells: readonly Area[]): void {
    this.cells = cells;
  }

  /** Poses every figure for a moment. */
  setTime(seconds: number): void {
    for (let index = 0; index < this.figures.length; index += 1) {
      this.figures[index]!.setTime(seconds * this.paceOf(index));
    }
    this.travel();
  }

  /** Draws, onto another surface if given. Its size must be that of the last `setFrame`. */
  draw(surface: Surface = this.surface): void {
    if (this.arrangement === "cells" && this.figures.length > 0) this.drawCells(surface);
    else surface.draw(this.scene, this.orbit.camera);
  }

  /** One figure after the other, each alone on the stage. One that is still awaited stands in every cell. */
  private drawCells(surface: Surface): void {
    const last = this.cells.length - 1;
    this.cells.forEach((cell, index) => {
      const figure = this.figures[index] ?? this.figures[0]!;
      for (const other of this.figures) other.group.visible = other === figure;
      this.floor.travel(figure.path[0]!, figure.path[1]!);
      surface.draw(this.scene, this.orbit.camera, cell, index === last);
    });
  }

  /** Where a label belongs: above each figure that has a place of its own, in CSS pixels. */
  labelPlaces(): number[] {
    const top = this.subject().high;
    return this.figures
      .filter((figure, index) => figure.disc && this.isSeen(index))
      .map((figure) => this.project(figure.group.position.x, top, 0).x);
  }

  /** Where a point (metres) is seen: CSS pixels from the upper left of the stage. */
  project(x: number, y: number, z: number): { x: number; y: number } {
    const seen = this.orbit.project(this.point.set(x, y, z));
    return { x: seen.x, y: seen.y };
  }

  dispose(): void {
    this.clear();
    this.bareDisc?.dispose();
    this.floor.dispose();
  }

  get clips(): MotionClip[] {
    return this.performers.map(({ clip }) => clip);
  }

  /** The clips whose length the clock goes by. */
  get timed(): MotionClip[] {
    return this.inStep ? this.clips.slice(0, 1) : this.clips;
  }

  /** Seconds of the shortest frame of the clips. */
  get frameTime(): number {
    return Math.min(...this.clips.map(({ frameTime }) => frameTime));
  }

  private paceOf(index: number): number {
    const [first] = this.performers;
    const own = this.performers[index];
    return this.inStep && first && own && first.clip.duration > 0 ? own.clip.duration / first.clip.duration : 1;
  }

  private get solid(): number {
    if (this.arrangement === "one" || this.arrangement === "cells") return 1;
    return this.performers.filter((_, index) => !this.ghostOf(index)).length;
  }

  /** x of each place, metres, from left to right. */
  private get places(): number[] {
    const count = Math.max(this.solid, 1);
    return Array.from({ length: count }, (_, k) => (2 * k - (count - 1)) * HALF_GAP);
  }

  private get homeAzimuth(): number {
    if (this.azimuth !== null) return this.azimuth;
    return this.solid > 1 ? looks.camera.pairAzimuth : looks.camera.azimuth;
  }

  private get discRadius(): number {
    return this.solid > 1 ? looks.ground.discRadiusPair : looks.ground.discRadius;
  }

  private nobody(index: number): string {
    const count = this.performers.length;
    return `There is no figure ${index} on the stage; it has ${count}. Wait for “ready” first.`;
  }

  private clear(): void {
    for (const figures of this.built.values()) for (const figure of figures) figure.dispose();
    this.built.clear();
    this.figures = [];
  }

  private rebuild(): void {
    this.clear();
    this.enter();
  }

  /** Brings on the figures of the arrangement, in the poses of those that leave. */
  private enter(): void {
    const leaving = this.figures;
    for (const figure of leaving) figure.group.removeFromParent();
    this.figures = this.built.get(this.arrangement) ?? this.build();
    this.built.set(this.arrangement, this.figures);
    for (const figure of this.figures) this.scene.add(figure.group);
    leaving.forEach(({ pose }, index) => this.figures[index]!.copy(pose));
    this.light();
    this.show();
    this.setMode(this.mode);
  }

  private build(): Figure[] {
    const { places, discRadius, tier } = this;
    const key = this.lights.keyDirection;
    let taken = -1;
    return this.performers.map(({ body, clip, role }, index) => {
      const ghost = this.ghostOf(index);
      if (!ghost) taken += 1;
      const place = places[Math.min(Math.max(taken, 0), places.length - 1)]!;
      return new Figure(body, clip, { role, ghost, tier, place, discRadius, key });
    });
  }

  private show(): void {
    this.figures.forEach((figure, index) => (figure.group.visible = this.isSeen(index)));
    this.leader = this.figures.filter(({ disc, group }) => disc && group.visible).at(-1);
    this.showBareDisc(this.leader === undefined);
    this.bareDisc?.setMode(this.mode);
    this.travel();
  }

  /** Moves the grid to where the leader has come. */
  private travel(): void {
    const path = this.leader?.path;
    if (path) this.floor.travel(path[0]!, path[1]!);
  }

  /** The lights belong to the standard view; turning the camera does not move them. */
  private light(): void {
    this.lights.place(this.homeAzimuth);
  }

  /** An empty stage still shows where somebody will stand. */
  private showBareDisc(shown: boolean): void {
    this.bareDisc?.dispose();
    this.bareDisc = shown ? new Disc(this.discRadius, [], [], this.lights.keyDirection, "plain") : null;
    if (this.bareDisc) this.scene.add(this.bareDisc.mesh);
  }

  private subject(): Subject {
    const { fit } = looks.camera;
    const extents = this.performers.map(({ clip }) => clipExtent(clip));
    const tallest = Math.max(STANDARD_STATURE, ...this.performers.map(({ body }) => body.stature));
    const standard = (fit.high * tallest) / STANDARD_STATURE;
    return {
      places: this.places,
      discRadius: this.discRadius + DISC_MARGIN,
      low: fit.low,
      high: Math.max(standard, ...extents.map(({ top }) => top)),
      reach: Math.max(0.3, ...extents.map(({ reach }) => reach)),
    };
  }
}
