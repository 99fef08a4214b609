/** Warm key, cool fill, rim from behind, sky above. They stay with the standard view on orbit. */
import { DirectionalLight, Group, HemisphereLight, MathUtils, Vector3 } from "three";
import { looks, type Mode } from "./looks";

export class Lights {
  readonly group = new Group();
  /** Toward the key light, unit length. */
  readonly keyDirection = new Vector3();
  private readonly key = new DirectionalLight();
  private readonly fill = new DirectionalLight();
  private readonly rim = new DirectionalLight();
  private readonly sky = new HemisphereLight();

  constructor() {
    this.group.add(this.key, this.fill, this.rim, this.sky);
  }

  setMode(mode: Mode): void {
    for (const name of ["key", "fill", "rim"] as const) {
      this[name].color.set(looks.light[name].colour);
      this[name].intensity = looks.light[name].intensity[mode];
    }
    const [above, below, intensity] = looks.light.sky[mode] as [string, string, number];
    this.sky.color.set(above);
    this.sky.groundColor.set(below);
    this.sky.intensity = intensity;
  }

  /** Places the lights for a standard view, in degrees. */
  place(azimuth: number): void {
    for (const name of ["key", "fill", "rim"] as const) {
      const { azimuthFromCamera, elevation } = looks.light[name];
      direction(azimuth + azimuthFromCamera, elevation, 1, this[name].position);
    }
    this.keyDirection.copy(this.key.position);
  }
}

/** A point seen from the origin: azimuth from +z toward +x, elevation upward, in degrees. */
export function direction(
  azimuth: number,
  elevation: number,
  distance: number,
  target: Vector3,
): Vector3 {
  const around = MathUtils.degToRad(azimuth);
  const up = MathUtils.degToRad(elevation);
  const level = Math.cos(up) * distance;
  return target.set(Math.sin(around) * level, Math.sin(up) * distance, Math.cos(around) * level);
}
