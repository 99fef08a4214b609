/** Warm key, cool fill, rim from behind, sky above. They stay with the standard view on orbit. */
import { DirectionalLight, Group, HemisphereLight, MathUtils, Vector3 } from "three";
import { looks, type Mode } from "./looks";

const DISTANCE = 6;
/** Height around which the shadow's map is spent. */
const MIDDLE = 0.85;
const SHADOW_TEXELS = 1024;

export class Lights {
  readonly group = new Group();
  /** Toward the key light, unit length. */
  readonly keyDirection = new Vector3();
  private readonly key = new DirectionalLight();
  private readonly fill = new DirectionalLight();
  private readonly rim = new DirectionalLight();
  private readonly sky = new HemisphereLight();

  constructor() {
    this.group.add(this.key, this.fill, this.rim, this.sky, this.key.target);
    const { shadow } = this.key;
    shadow.mapSize.set(SHADOW_TEXELS, SHADOW_TEXELS);
    shadow.intensity = looks.light.key.shadow;
    shadow.bias = -0.0006;
    shadow.normalBias = 0.012;
    shadow.radius = 3;
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

  setShadows(on: boolean): void {
    this.key.castShadow = on;
  }

  /** Places the lights for a standard view (degrees) and a stage of some radius (metres). */
  place(azimuth: number, radius: number): void {
    for (const name of ["key", "fill", "rim"] as const) {
      const { azimuthFromCamera, elevation } = looks.light[name];
      direction(azimuth + azimuthFromCamera, elevation, DISTANCE, this[name].position);
    }
    const { camera } = this.key.shadow;
    this.keyDirection.copy(this.key.position).normalize();
    this.key.target.position.set(0, MIDDLE, 0);
    this.key.position.y += MIDDLE;
    camera.left = camera.bottom = -radius;
    camera.right = camera.top = radius;
    camera.near = DISTANCE - 3;
    camera.far = DISTANCE + 3;
    camera.updateProjectionMatrix();
  }

  dispose(): void {
    this.key.dispose();
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
