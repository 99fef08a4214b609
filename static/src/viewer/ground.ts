/** The floor: a grid that moves under the traveller, and under each figure a disc with its shade. */
import {
  Color,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  Vector2,
  type Vector3,
  Vector4,
} from "three";
import { looks, plainColour, type Mode } from "./looks";
import { SPHERE_CAST, SPHERE_SHADE } from "./shading";
import type { Tier } from "./statistics";

const { ground } = looks;
/** A hair below the soles, so that a planted foot never flickers through the floor. */
const FLOOR = -0.003;
/** Room for the cast shadow beside the disc. */
const DISC_PLANE = 3.4;
/** Where nobody knows the way beforehand, more floor is seen, so that one sees it pass: metres. */
const ROAMED_FADE = 3.4;
/** How far a disc hides the grid. */
const COVER = 0.9;
const ROAMED_COVER = 0.25;
const GRID_PLANE = 2 * ROAMED_FADE;

const VERTEX = /* glsl */ `
varying vec2 vPlace;
varying vec3 vWorld;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  vWorld = world.xyz;
  vPlace = position.xz;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

/** A line's cover of a pixel: its width in pixels is the same at any distance and slant. */
const LINE = /* glsl */ `
float line(float away, float pixels) {
  float pixel = max(fwidth(away), 1e-6);
  return clamp(0.5 + 0.5 * pixels - abs(away) / pixel, 0.0, 1.0);
}`;

const GRID_FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform vec2 offset;
uniform float reach;
varying vec2 vPlace;
varying vec3 vWorld;
${LINE}
float ruled(float along) {
  float away = abs(fract(along / STEP + 0.5) - 0.5) * STEP;
  float pixel = max(fwidth(along), 1e-6);
  return clamp(0.5 + 0.5 * LINE_PIXELS - away / pixel, 0.0, 1.0) * min(1.0, 0.12 * STEP / pixel);
}
void main() {
  vec2 place = vPlace + offset;
  float fade = 1.0 - smoothstep(0.25 * reach, reach, length(vPlace));
  float cover = max(ruled(place.x), ruled(place.y));
  gl_FragColor = vec4(colour, 0.6 * cover * fade * fade);
}`;

/** Disc, hair rim, the sky that the body hides from the floor, and the soles' tight shade. */
const DISC_FRAGMENT = /* glsl */ `
uniform vec3 disc;
uniform vec3 rim;
uniform vec3 shade;
uniform float radius;
uniform float cover;
uniform float ambient;
uniform float contact;
uniform float castAmount;
uniform vec3 key;
uniform vec4 spheres[SPHERES];
uniform vec4 soles[SOLES];
varying vec2 vPlace;
varying vec3 vWorld;
${LINE}
${SPHERE_SHADE}
${SPHERE_CAST}
float contactShade() {
  float open = 1.0;
  for (int i = 0; i < SOLES; i += 1) {
    vec3 way = soles[i].xyz - vWorld;
    float height = max(way.y, 0.0);
    float sigma = SIGMA + 0.45 * height;
    float near = exp(-0.5 * dot(way.xz, way.xz) / (sigma * sigma));
    open *= 1.0 - soles[i].w * near * (SIGMA * SIGMA) / (sigma * sigma);
  }
  return 1.0 - open;
}
// How much of the floor's sky the body takes away; what is high above it counts less.
float ambientShade() {
  float open = 1.0;
#ifdef PLAIN
  for (int i = 0; i < SOLES; i += 1) {
    vec3 way = soles[i].xyz - vWorld;
    float sigma = 0.11 + max(way.y, 0.0);
    open *= 1.0 - 0.13 * soles[i].w * exp(-0.5 * dot(way.xz, way.xz) / (sigma * sigma));
  }
#else
  for (int i = 0; i < SPHERES; i += 1)
    open *= 1.0 - exp(-2.0 * spheres[i].y) * hiddenBySphere(vWorld, vec3(0.0, 1.0, 0.0), spheres[i]);
#endif
  return 1.0 - open;
}
// The key light's shadow of the same spheres.
float castShade() {
  float open = 1.0;
  for (int i = 0; i < SPHERES; i += 1) open *= pastSphere(vWorld, key, spheres[i], -spheres[i].w);
  return 1.0 - open;
}
void main() {
  float away = length(vPlace);
  float pixel = max(fwidth(away), 1e-6);
  float inside = clamp(0.5 + (radius - away) / pixel, 0.0, 1.0);
  float edge = line(away - radius, RIM_PIXELS);
  float fade = 1.0 - smoothstep(0.3 * radius, FADE * radius, away);
  float light = 1.0;
  if (fade > 0.0) light *= (1.0 - ambient * ambientShade() * fade) * (1.0 - contact * contactShade());
#ifndef PLAIN
  // Nothing is cast toward the light, so most of the floor need not be searched for it.
  float castFade = 1.0 - smoothstep(0.35, 0.4 * PLANE, away);
  if (castFade > 0.0 && dot(vPlace, normalize(key.xz)) < 0.6 * radius)
    light *= 1.0 - castAmount * castShade() * castFade;
#endif
  float dark = 1.0 - light;
  vec3 colour = mix(disc, rim, edge);
  float covered = max(inside * cover, edge);
  // The shade lies over the disc: composed here by the "over" rule.
  float alpha = dark + covered * (1.0 - dark);
  gl_FragColor = vec4(mix(colour, shade, dark / max(alpha, 1e-4)), alpha);
}`;

/** A shader's array cannot be empty: far below the floor, without strength. */
const NOTHING = [new Vector4(0, -100, 0, 0)];

function plane(size: number): PlaneGeometry {
  const geometry = new PlaneGeometry(size, size);
  geometry.rotateX(-Math.PI / 2);
  return geometry;
}

function layer(mesh: Mesh, order: number): Mesh {
  mesh.position.y = FLOOR;
  mesh.renderOrder = order;
  return mesh;
}

/** The grid: one on a stage. */
export class Floor {
  readonly mesh: Mesh;
  private readonly grid: ShaderMaterial;

  constructor() {
    this.grid = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: GRID_FRAGMENT,
      uniforms: { colour: { value: new Color() }, offset: { value: new Vector2() }, reach: { value: ground.grid.fadeRadius } },
      defines: {
        STEP: ground.grid.step.toFixed(3),
        LINE_PIXELS: "1.0",
      },
      transparent: true,
      depthWrite: false,
    });
    this.mesh = layer(new Mesh(plane(GRID_PLANE), this.grid), 1);
  }

  setMode(mode: Mode): void {
    plainColour(ground.grid[mode], this.grid.uniforms["colour"]!.value as Color);
  }

  /** Moves the grid to where the traveller has come: x and z on the floor, metres. */
  travel(x: number, z: number): void {
    const { step } = ground.grid;
    (this.grid.uniforms["offset"]!.value as Vector2).set(x % step, z % step);
  }

  /** Reaches farther around a figure that is steered. */
  roam(): void {
    this.grid.uniforms["reach"]!.value = ROAMED_FADE;
  }

  dispose(): void {
    this.grid.dispose();
    this.mesh.geometry.dispose();
  }
}

/** The disc under one figure. Its spheres and soles are the figure's own, in world space. */
export class Disc {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;

  constructor(radius: number, spheres: Vector4[], soles: Vector4[], key: Vector3, tier: Tier) {
    const plain = tier === "plain" || spheres.length === 0;
    const uniform = <T>(value: T) => ({ value });
    this.material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: DISC_FRAGMENT,
      uniforms: {
        disc: uniform(new Color()),
        rim: uniform(new Color()),
        shade: uniform(new Color()),
        radius: uniform(radius),
        cover: uniform(COVER),
        ambient: uniform(0),
        contact: uniform(0),
        castAmount: uniform(0),
        key: uniform(key),
        spheres: uniform(spheres.length ? spheres : NOTHING),
        soles: uniform(soles.length ? soles : NOTHING),
      },
      defines: {
        SPHERES: Math.max(spheres.length, 1),
        SOLES: Math.max(soles.length, 1),
        SIGMA: ground.shade.contactSigma.toFixed(4),
        RIM_PIXELS: "1.3",
        FADE: plain ? "1.0" : "1.5",
        PLANE: DISC_PLANE.toFixed(2),
        ...(plain ? { PLAIN: 1 } : {}),
      },
      transparent: true,
      depthWrite: false,
    });
    this.mesh = layer(new Mesh(plane(plain ? 2.1 * radius : DISC_PLANE), this.material), 2);
  }

  setMode(mode: Mode): void {
    const { uniforms } = this.material;
    plainColour(ground.disc[mode], uniforms["disc"]!.value as Color);
    plainColour(ground.rim[mode], uniforms["rim"]!.value as Color);
    plainColour(ground.shade[mode], uniforms["shade"]!.value as Color);
    uniforms["ambient"]!.value = ground.shade.ambient[mode];
    uniforms["contact"]!.value = ground.shade.contact[mode];
    uniforms["castAmount"]!.value = ground.shade.castOpacity[mode];
  }

  /** Lets the grid through, so that it is seen to pass under the feet. */
  roam(): void {
    this.material.uniforms["cover"]!.value = ROAMED_COVER;
  }

  dispose(): void {
    this.mesh.removeFromParent();
    this.material.dispose();
    this.mesh.geometry.dispose();
  }
}
