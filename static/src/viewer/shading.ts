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
 * Code of `float openness(point, normal)`: how much of the sky a point of the body sees past the
 * limbs that it is no part of. One loop with fixed bounds a limb, which every driver unrolls well.
 */
export function opennessShader(counts: readonly number[]): string {
  let first = 0;
  const loops = LIMBS.map((limb, index) => {
    const count = counts[index] ?? 0;
    const share = `${index < 3 ? "vLimbsA" : "vLimbsB"}.${"xyz"[index % 3]}`;
    const loop =
      count === 0
        ? ""
        : `own = 1.0 - ${share}; // ${limb}
  if (own > 0.01) for (int i = ${first}; i < ${first + count}; i += 1)
    open *= 1.0 - own * hiddenBySphere(point, normal, spheres[i]);`;
    first += count;
    return loop;
  });
  return `${SPHERE_SHADE}
float openness(vec3 point, vec3 normal) {
  float open = 1.0;
  float own;
  ${loops.filter(Boolean).join("\n  ")}
  return open;
}`;
}
