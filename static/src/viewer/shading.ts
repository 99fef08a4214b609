/** Shader code: shade between the parts of a body, analytically from spheres along its bones. */
import { LIMBS } from "./body";

/** More spheres than this are left out: the shader's uniforms have a fixed size. */
export const MOST_SPHERES = 48;
export const MOST_SOLE_POINTS = 32;

/**
 * Share of the sky that a sphere hides from a surface point; the sphere may reach below the
 * horizon. The approximation by Inigo Quilez ("sphere ambient occlusion", 2006): the clamped cosine
 * term (cos·h + 1)/2h² to the power 3/2, h = distance/radius, is within a few hundredths of exact.
 */
export const SPHERE_SHADE = /* glsl */ `
float hiddenBySphere(vec3 point, vec3 normal, vec4 sphere) {
  vec3 way = sphere.xyz - point;
  float distance2 = max(dot(way, way), 1e-6);
  float radius2 = sphere.w * sphere.w;
  float along = dot(normal, way) * inversesqrt(distance2);
  float h2 = max(distance2 / radius2, 1.0);
  float share = clamp(0.5 * (along * sqrt(h2) + 1.0) / h2, 0.0, 1.0);
  return share * sqrt(share);
}`;

/**
 * How much of a small lamp a sphere lets through; its edge softens with the way to the sphere.
 * What touches the surface is left out: there the turning away from the light says enough.
 */
export const SPHERE_CAST = /* glsl */ `
float pastSphere(vec3 point, vec3 toward, vec4 sphere, float nearest) {
  vec3 way = sphere.xyz - point;
  float along = dot(way, toward);
  float away = length(way - along * toward);
  float soft = 0.02 + 0.07 * max(along, 0.0);
  float hidden = 1.0 - smoothstep(sphere.w - soft, sphere.w + soft, away);
  return 1.0 - hidden * smoothstep(nearest, nearest + sphere.w, along);
}`;

/**
 * Code of `shadeFromLimbs`: how much of the sky, and of the key light, reaches a point of the body
 * past the limbs that it is no part of. One loop with fixed bounds a limb, so that drivers unroll.
 */
export function limbShader(counts: readonly number[]): string {
  let first = 0;
  const loops = LIMBS.map((limb, index) => {
    const count = counts[index] ?? 0;
    const share = `${index < 3 ? "vLimbsA" : "vLimbsB"}.${"xyz"[index % 3]}`;
    const from = first;
    first += count;
    if (count === 0) return "";
    return `
  other = 1.0 - ${share}; // ${limb}
  if (other > 0.01) for (int i = ${from}; i < ${from + count}; i += 1) {
    sky *= 1.0 - other * hiddenBySphere(point, normal, spheres[i]);
    lamp *= mix(1.0, pastSphere(point, key, spheres[i], 0.2 * spheres[i].w), other);
  }`;
  });
  return `${SPHERE_SHADE}
${SPHERE_CAST}
void shadeFromLimbs(vec3 point, vec3 normal, out float sky, out float lamp) {
  sky = lamp = 1.0;
  float other;${loops.join("")}
}`;
}
