/** Matte clay with shade in its creases and a faint warm rim; and the ghosts. */
import { Color, FrontSide, LessEqualDepth, MeshBasicMaterial, MeshStandardMaterial, type Vector4 } from "three";
import { looks, type FigureRole, type GhostKind, type Mode } from "./looks";
import { opennessShader } from "./shading";
import type { Tier } from "./statistics";

export interface ClayOptions {
  /** World-space centres and radii, sorted by limb; written over in every frame. */
  spheres: Vector4[];
  /** How many of them each limb has. */
  counts: readonly number[];
  tier: Tier;
  ghost: GhostKind | null;
}

interface ClayUniforms {
  spheres: { value: Vector4[] };
  rimColour: { value: Color };
  rimStrength: { value: number };
  edge: { value: number };
}

const VERTEX_DECLARATIONS = /* glsl */ `
varying vec3 vSurface;
#ifdef ANALYTIC_SHADE
  attribute vec4 limbsA;
  attribute vec4 limbsB;
  varying vec3 vLimbsA;
  varying vec3 vLimbsB;
#endif
#ifdef BAKED_SHADE
  attribute float openness;
  varying float vOpenness;
#endif`;

const VERTEX_END = /* glsl */ `
vSurface = (modelMatrix * vec4(transformed, 1.0)).xyz;
#ifdef ANALYTIC_SHADE
  vLimbsA = limbsA.xyz;
  vLimbsB = limbsB.xyz;
#endif
#ifdef BAKED_SHADE
  vOpenness = openness;
#endif
#ifdef BEHIND_ONLY
  // Into the farthest slice of depth: whatever else is drawn lies before it.
  gl_Position.z = mix(gl_Position.z, gl_Position.w, 0.98);
#endif`;

const FRAGMENT_DECLARATIONS = /* glsl */ `
varying vec3 vSurface;
uniform vec3 rimColour;
uniform float rimStrength;
uniform float edge;
#ifdef ANALYTIC_SHADE
  uniform vec4 spheres[SPHERES];
  varying vec3 vLimbsA;
  varying vec3 vLimbsB;
  OPENNESS
#endif
#ifdef BAKED_SHADE
  varying float vOpenness;
#endif`;

/** Direct light is dimmed less than the sky's, and blue fades before red: shade stays warm. */
const FRAGMENT_LIGHT = /* glsl */ `
float grazing = 1.0 - saturate(dot(normal, normalize(vViewPosition)));
float open = 1.0;
#ifdef ANALYTIC_SHADE
  open = openness(vSurface, inverseTransformDirection(normal, viewMatrix));
#endif
#ifdef BAKED_SHADE
  open = vOpenness;
#endif
open = mix(1.0, open, SHADE_AMOUNT);
vec3 warmShade = pow(vec3(open), vec3(0.88, 1.0, 1.14));
reflectedLight.indirectDiffuse *= warmShade;
reflectedLight.directDiffuse *= mix(vec3(1.0), warmShade, 0.62);
reflectedLight.directSpecular *= open;
totalEmissiveRadiance += rimColour * (rimStrength * pow(grazing, RIM_POWER) * open);`;

/** A ghost is denser where its surface turns away. */
const FRAGMENT_OPAQUE = /* glsl */ `
#ifdef GHOST
  diffuseColor.a = clamp(diffuseColor.a + edge * grazing * sqrt(grazing), 0.0, 1.0);
#endif
#include <opaque_fragment>`;

const WHITE = new Color("#FFFFFF");

export class Clay {
  readonly material: MeshStandardMaterial;
  private readonly uniforms: ClayUniforms;

  constructor(private readonly options: ClayOptions) {
    this.uniforms = {
      spheres: { value: options.spheres },
      rimColour: { value: new Color() },
      rimStrength: { value: 0 },
      edge: { value: 0 },
    };
    this.material = new MeshStandardMaterial({
      roughness: looks.material.roughness,
      metalness: looks.material.metalness,
      side: FrontSide,
      transparent: options.ghost !== null,
      depthFunc: LessEqualDepth,
    });
    this.material.defines = { ...this.material.defines, ...this.defines() };
    this.material.onBeforeCompile = (shader) => this.extend(shader);
    this.material.customProgramCacheKey = () => `clay ${options.counts.join(" ")}`;
  }

  /** Colours for a role in light or dark; a ghost's opacity goes with them. */
  dress(role: FigureRole, mode: Mode): void {
    const { material, uniforms } = this;
    const { ghost } = this.options;
    material.color.set(looks[role][mode]);
    uniforms.rimColour.value.set(looks.material.rim.colour[mode]);
    uniforms.rimStrength.value = looks.material.rim.strength;
    if (ghost === "target") {
      const { opacity, lightenInDark } = looks.ghost.target;
      material.opacity = opacity[mode];
      uniforms.edge.value = 0.55;
      if (mode === "dark") material.color.lerp(WHITE, lightenInDark);
    } else if (ghost === "original") {
      material.opacity = looks.ghost.original.opacity;
      uniforms.edge.value = 0.25;
    } else if (ghost === "loading") {
      material.opacity = looks.ghost.loading.opacity;
      uniforms.edge.value = 0.1;
    }
  }

  dispose(): void {
    this.material.dispose();
  }

  private defines(): Record<string, string | number> {
    const { tier, ghost, spheres } = this.options;
    const shade = ghost || spheres.length === 0 ? "NO" : tier === "full" ? "ANALYTIC" : "BAKED";
    return {
      [`${shade}_SHADE`]: 1,
      SPHERES: spheres.length,
      SHADE_AMOUNT: looks.material.occlusion.toFixed(3),
      RIM_POWER: looks.material.rim.power.toFixed(3),
      ...(ghost ? { GHOST: 1 } : {}),
      ...(ghost === "original" ? { BEHIND_ONLY: 1 } : {}),
    };
  }

  private extend(shader: { vertexShader: string; fragmentShader: string; uniforms: object }): void {
    Object.assign(shader.uniforms, this.uniforms);
    const declarations = FRAGMENT_DECLARATIONS.replace(
      "OPENNESS",
      opennessShader(this.options.counts),
    );
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", `#include <common>\n${VERTEX_DECLARATIONS}`)
      .replace("#include <fog_vertex>", `${VERTEX_END}\n#include <fog_vertex>`);
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <lights_pars_begin>", `${declarations}\n#include <lights_pars_begin>`)
      .replace("#include <lights_fragment_end>", `#include <lights_fragment_end>\n${FRAGMENT_LIGHT}`)
      .replace("#include <opaque_fragment>", FRAGMENT_OPAQUE);
  }
}

/** Lays down a ghost's depth first, so that its own far side does not show through. */
export function ghostDepthMaterial(kind: GhostKind): MeshBasicMaterial {
  const material = new MeshBasicMaterial({
    colorWrite: false,
    transparent: true, // drawn after whatever is solid
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  if (kind === "original") {
    material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        "#include <fog_vertex>",
        "gl_Position.z = mix(gl_Position.z, gl_Position.w, 0.98);",
      );
    };
    material.customProgramCacheKey = () => "ghost depth behind";
  }
  return material;
}
