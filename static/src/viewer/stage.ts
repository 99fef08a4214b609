/** A scene with its figures, lights, floor and camera: everything that one view draws. */
import { Scene, Vector3 } from "three";
import type { Body } from "./body";
import { OrbitCamera, type Frame, type Subject } from "./camera";
import type { MotionClip } from "./clip";
import { Figure } from "./figure";
import { Disc, Floor } from "./ground";
import { Lights } from "./lights";
import { looks, type FigureRole, type GhostKind, type Mode } from "./looks";
import type { Surface } from "./renderer";
import { clipExtent } from "./extent";
import type { Tier } from "./statistics";

export interface Performer {
  clip: MotionClip;
  body: Body;
  role: FigureRole;
  ghost: GhostKind | null;
}

/** Half the distance between two figures side by side, metres: the pair's discs just part. */
const HALF_GAP = 0.55;
const DISC_MARGIN = 0.04;
const STANDARD_STATURE = 1.58;

export class Stage {
  readonly orbit = new OrbitCamera();
  figures: Figure[] = [];
  private readonly scene = new Scene();
  private readonly lights = new Lights();
  private readonly floor = new Floor();
  private readonly point = new Vector3();
  private performers: Performer[] = [];
  private mode: Mode = "light";
  private tier: Tier = "full";
  private azimuth: number | null = null;
  /** Whose way the grid shows: the last figure with a place of its own, the judged one of a pair. */
  private leader: Figure | undefined;
  private bareDisc: Disc | null = null;

  constructor(readonly surface: Surface) {
    this.scene.add(this.lights.group, this.floor.mesh);
    this.setMode("light");
    this.cast([]);
  }

  /** Puts figures on the stage. Their clips begin at their first pose. */
  cast(performers: Performer[]): void {
    this.performers = performers;
    this.rebuild();
    this.orbit.setSubject(this.subject(), this.homeAzimuth);
    this.orbit.jump(this.homeAzimuth);
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
    this.rebuild();
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

  /** Poses every figure for a moment. */
  setTime(seconds: number): void {
    for (let index = 0; index < this.figures.length; index += 1) {
      this.figures[index]!.setTime(seconds);
    }
    const path = this.leader?.path;
    if (path) this.floor.travel(path[0]!, path[1]!);
  }

  /** Draws, onto another surface if given. Its size must be that of the last `setFrame`. */
  draw(surface: Surface = this.surface): void {
    surface.draw(this.scene, this.orbit.camera);
  }

  /** Where a label belongs: above each figure that has a place of its own, in CSS pixels. */
  labelPlaces(): number[] {
    const top = this.subject().high;
    return this.places.map((place) => this.project(place, top, 0).x);
  }

  /** Where a point (metres) is seen: CSS pixels from the upper left of the stage. */
  project(x: number, y: number, z: number): { x: number; y: number } {
    const seen = this.orbit.project(this.point.set(x, y, z));
    return { x: seen.x, y: seen.y };
  }

  dispose(): void {
    for (const figure of this.figures) figure.dispose();
    this.bareDisc?.dispose();
    this.floor.dispose();
  }

  private get solid(): number {
    return this.performers.filter((performer) => !performer.ghost).length;
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

  private rebuild(): void {
    for (const figure of this.figures) figure.dispose();
    const { places, discRadius, tier } = this;
    const key = this.lights.keyDirection;
    let taken = -1;
    this.figures = this.performers.map(({ body, clip, role, ghost }) => {
      if (!ghost) taken += 1;
      const place = places[Math.max(taken, 0)] ?? 0;
      return new Figure(body, clip, { role, ghost, tier, place, discRadius, key });
    });
    for (const figure of this.figures) this.scene.add(figure.group);
    this.leader = this.figures.filter((figure) => figure.disc).at(-1);
    this.showBareDisc(this.leader === undefined);
    this.light();
    this.setMode(this.mode);
    this.setTime(0);
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
