/** The camera: a 21° lens that always shows the whole disc and stature, turned around by hand. */
import { MathUtils, PerspectiveCamera, Vector3 } from "three";
import { direction } from "./lights";
import { CAMERA_PRESET_MS, looks } from "./looks";

/** What must stay in view: a disc around each figure's place, and columns of a height above. */
export interface Subject {
  /** x of each figure's place, metres. */
  places: number[];
  discRadius: number;
  low: number;
  high: number;
  /** How far limbs reach from the path, metres; shown only where the disc is not wider anyway. */
  reach: number;
}

/** Pixels. */
export interface Frame {
  width: number;
  height: number;
  top: number;
  bottom: number;
  side: number;
}

export interface Fit {
  distance: number;
  /** Pixels by which the picture moves to bring the subject to the middle of the free area. */
  shiftX: number;
  shiftY: number;
}

export const PRESETS = { "three-quarter": looks.camera.azimuth, front: 0, side: 90 } as const;
export type Preset = keyof typeof PRESETS;

const LOWEST = 0;
const HIGHEST = 75;
const RING = 24;
const LOOK_HEIGHT = 0.5;
/** Metres that a subject must grow before the camera steps back. */
const ROOM_STEP = 0.01;

/** The points that must be seen, as x y z triples. */
export function subjectPoints(subject: Subject): Float64Array {
  const points: number[] = [];
  const { discRadius, high, low, reach } = subject;
  for (const place of subject.places) {
    for (let k = 0; k < RING; k += 1) {
      const angle = (2 * Math.PI * k) / RING;
      const x = Math.cos(angle);
      const z = Math.sin(angle);
      points.push(place + discRadius * x, 0, discRadius * z);
      points.push(place + 0.12 * x, high, 0.12 * z);
      points.push(place + reach * x, 0.55 * high, reach * z);
    }
    points.push(place, low, 0);
  }
  return Float64Array.from(points);
}

/**
 * The nearest distance from which all points lie in the free part of the frame, and the shift that
 * puts them in its middle. Azimuth, elevation and the lens (over the frame's height) in degrees.
 */
export function fit(
  points: Float64Array,
  middle: number,
  azimuth: number,
  elevation: number,
  lens: number,
  frame: Frame,
): Fit {
  const around = MathUtils.degToRad(azimuth);
  const up = MathUtils.degToRad(elevation);
  const focal = frame.height / 2 / Math.tan(MathUtils.degToRad(lens) / 2);
  const freeWidth = Math.max(frame.width - 2 * frame.side, 40);
  const freeHeight = Math.max(frame.height - frame.top - frame.bottom, 40);
  const box = { left: 0, right: 0, down: 0, up: 0 };
  const measure = (distance: number) => {
    box.left = box.down = Infinity;
    box.right = box.up = -Infinity;
    for (let at = 0; at < points.length; at += 3) {
      const x = points[at]!;
      const y = points[at + 1]! - middle;
      const z = points[at + 2]!;
      const level = Math.sin(around) * x + Math.cos(around) * z;
      const scale = focal / (distance - (Math.cos(up) * level + Math.sin(up) * y));
      const across = (Math.cos(around) * x - Math.sin(around) * z) * scale;
      const above = (Math.cos(up) * y - Math.sin(up) * level) * scale;
      box.left = Math.min(box.left, across);
      box.right = Math.max(box.right, across);
      box.down = Math.min(box.down, above);
      box.up = Math.max(box.up, above);
    }
    return box.right - box.left <= freeWidth && box.up - box.down <= freeHeight;
  };
  let near = 2;
  let far = 200;
  for (let step = 0; step < 40; step += 1) {
    const distance = (near + far) / 2;
    if (measure(distance)) far = distance;
    else near = distance;
  }
  measure(far);
  const spare = freeHeight - (box.up - box.down);
  return {
    distance: far,
    shiftX: -(box.left + box.right) / 2,
    // Spare height goes mostly above: a figure stands on its ground, it does not float.
    shiftY: frame.bottom + 0.4 * spare - (frame.height / 2 + box.down),
  };
}

export class OrbitCamera {
  readonly camera = new PerspectiveCamera(looks.camera.fov, 1, 0.5, 60);
  azimuth: number = looks.camera.azimuth;
  elevation: number = looks.camera.elevation;
  zoom = 1;
  private home: number = looks.camera.azimuth;
  private subject: Subject | null = null;
  private points: Float64Array = new Float64Array(0);
  private middle = LOOK_HEIGHT;
  private frame: Frame = { width: 300, height: 300, top: 24, bottom: 84, side: 8 };
  private flight: { from: number[]; to: number[]; progress: number } | null = null;
  private growth: { from: Subject; to: Subject; progress: number } | null = null;

  setSubject(subject: Subject, home: number): void {
    this.growth = null;
    this.home = home;
    this.regard(subject);
  }

  /** Steps back, without a jump, as far as a larger subject needs; a smaller one keeps its room. */
  makeRoom(wanted: Subject, still: boolean): void {
    const from = this.subject ?? wanted;
    const seen = this.growth?.to ?? from;
    const high = Math.max(seen.high, wanted.high);
    const reach = Math.max(seen.reach, wanted.reach);
    if (high - seen.high < ROOM_STEP && reach - seen.reach < ROOM_STEP) return;
    const to = { ...from, high, reach };
    if (still) this.regard(to);
    else this.growth = { from, to, progress: 0 };
  }

  setFrame(frame: Frame): void {
    this.frame = frame;
    this.camera.aspect = frame.width / frame.height;
    this.apply();
  }

  get moved(): boolean {
    const turned = Math.abs(this.azimuth - this.home) > 0.5 || this.zoom !== 1;
    return turned || Math.abs(this.elevation - looks.camera.elevation) > 0.5;
  }

  orbit(azimuth: number, elevation: number): void {
    this.flight = null;
    this.azimuth = wrap(this.azimuth + azimuth);
    this.elevation = MathUtils.clamp(this.elevation + elevation, LOWEST, HIGHEST);
    this.apply();
  }

  zoomBy(factor: number): void {
    this.zoom = MathUtils.clamp(this.zoom * factor, 0.7, 3);
    this.apply();
  }

  jump(azimuth: number): void {
    this.look(azimuth, looks.camera.elevation, 1);
  }

  /** Turns to this view at once; angles in degrees. */
  look(azimuth: number, elevation: number, zoom: number): void {
    this.flight = null;
    this.azimuth = wrap(azimuth);
    this.elevation = elevation;
    this.zoom = zoom;
    this.apply();
  }

  /** Turns to an azimuth at the standard height, by the shorter way, in the presets' time. */
  flyTo(azimuth: number, still: boolean): void {
    if (still) return this.jump(azimuth);
    const from = [this.azimuth, this.elevation, this.zoom];
    const turn = wrap(azimuth - this.azimuth);
    this.flight = { from, to: [this.azimuth + turn, looks.camera.elevation, 1], progress: 0 };
  }

  reset(still: boolean): void {
    this.flyTo(this.home, still);
  }

  get flying(): boolean {
    return this.flight !== null || this.growth !== null;
  }

  /** Goes on with a preset's flight, and with the way back from a larger subject. */
  advance(milliseconds: number): void {
    const step = milliseconds / CAMERA_PRESET_MS;
    if (this.growth) this.advanceGrowth(this.growth, step);
    if (this.flight) this.advanceFlight(this.flight, step);
  }

  private advanceGrowth(growth: NonNullable<typeof this.growth>, step: number): void {
    const { from, to } = growth;
    growth.progress = Math.min(growth.progress + step, 1);
    const at = (key: "high" | "reach") => from[key] + (to[key] - from[key]) * eased(growth.progress);
    if (growth.progress === 1) this.growth = null;
    this.regard({ ...to, high: at("high"), reach: at("reach") });
  }

  private advanceFlight(flight: NonNullable<typeof this.flight>, step: number): void {
    flight.progress = Math.min(flight.progress + step, 1);
    const share = eased(flight.progress);
    const at = (index: number) =>
      flight.from[index]! + (flight.to[index]! - flight.from[index]!) * share;
    this.azimuth = wrap(at(0));
    this.elevation = at(1);
    this.zoom = at(2);
    if (flight.progress === 1) this.flight = null;
    this.apply();
  }

  /** Pixels from the left and the top of the frame at which a point is seen. */
  project(point: Vector3): Vector3 {
    point.project(this.camera);
    point.x = ((point.x + 1) / 2) * this.frame.width;
    point.y = ((1 - point.y) / 2) * this.frame.height;
    return point;
  }

  private regard(subject: Subject): void {
    this.subject = subject;
    this.points = subjectPoints(subject);
    this.middle = subject.high / 2;
    this.apply();
  }

  private apply(): void {
    const { camera, frame, middle } = this;
    if (this.points.length === 0) return;
    const found = fit(this.points, middle, this.azimuth, this.elevation, looks.camera.fov, frame);
    direction(this.azimuth, this.elevation, found.distance / this.zoom, camera.position);
    camera.position.y += middle;
    camera.lookAt(0, middle, 0);
    camera.near = Math.max(found.distance / this.zoom - 4, 0.1);
    camera.far = found.distance / this.zoom + 5;
    const { width, height } = frame;
    camera.setViewOffset(width, height, -found.shiftX, found.shiftY, width, height);
    camera.updateMatrixWorld();
  }
}

/** Fast at first, slow at the end, for a progress of 0…1. */
function eased(progress: number): number {
  return 1 - (1 - progress) ** 4;
}

/** The same angle within −180…180°. */
function wrap(degrees: number): number {
  return MathUtils.euclideanModulo(degrees + 180, 360) - 180;
}
