/** Matte clay with shade in its creases and a faint warm rim; and the ghosts. */
import {
  Color,
  MeshBasicMaterial,
  MeshStandardMaterial,
  ShaderChunk,
  type Vector3,
  type Vector4,
} from "three";
import { looks, type FigureRole, type GhostKind, type Mode } from "./looks";
import { limbShader } from "./shading";
import type { Tier } from "./statistics";

export interface ClayOptions {
  /** World-space centres and radii, sorted by limb; written over in every frame. */
  spheres: Vector4[];
  /** How many of them each limb has. */
  counts: readonly number[];
  /** Toward the key light, unit length. */
  key: Vector3;
  tier: Tier;
  ghost: GhostKind | null;
}

interface ClayUniforms {
  key: { value: Vector3 };
  spheres: { value: Vector4[] };
  rimColour: { value: Color };
  rimStrength: { value: number };
  edge: { value: number };
}

const VERTEX_DECLARATIONS = /* glsl */ `
#ifdef SHADED
  attribute float openness;
  varying float vOpenness;
#endif
#ifdef BY_LIMBS
  attribute vec4 limbsA;
  attribute vec4 limbsB;
  varying vec3 vLimbsA;
  varying vec3 vLimbsB;
  varying vec3 vSurface;
#endif`;

const VERTEX_END = /* glsl */ `
#ifdef SHADED
  vOpenness = openness;
#endif
#ifdef BY_LIMBS
  vSurface = (modelMatrix * vec4(transformed, 1.0)).xyz;
  vLimbsA = limbsA.xyz;
  vLimbsB = limbsB.xyz;
#endif
#ifdef BEHIND_ONLY
  // Into the farthest slice of depth: whatever else is drawn lies before it.
  gl_Position.z = mix(gl_Position.z, gl_Position.w, 0.98);
#endif
#include <fog_vertex>`;

const FRAGMENT_DECLARATIONS = /* glsl */ `
uniform vec3 rimColour;
uniform float rimStrength;
uniform float edge;
#ifdef SHADED
  varying float vOpenness;
#endif
#ifdef BY_LIMBS
  uniform vec4 spheres[SPHERES];
  uniform vec3 key;
  varying vec3 vLimbsA;
  varying vec3 vLimbsB;
  varying vec3 vSurface;
  SHADE_FUNCTIONS
#endif
#include <lights_pars_begin>`;

/** Before the lights: the body's creases (baked) and the limbs before it (as they stand now). */
const FRAGMENT_SHADE = /* glsl */ `
float sky = 1.0;
float lamp = 1.0;
#ifdef BY_LIMBS
  shadeFromLimbs(vSurface, inverseTransformDirection(normal, viewMatrix), sky, lamp);
  sky = pow(sky, LIMB_SHADE) * mix(1.0, vOpenness, CREASES);
#elif defined(SHADED)
  sky = vOpenness;
#endif
sky = mix(1.0, sky, SHADE_AMOUNT);
lamp = mix(1.0, lamp, KEY_SHADE);
`;

/** The key is the first of the directional lights, and the only one that anything stands before. */
const KEY_LIGHT = "getDirectionalLightInfo( directionalLight, directLight );";
const SHADED_KEY_LIGHT = `${KEY_LIGHT}
    #if UNROLLED_LOOP_INDEX == 0
      directLight.color *= lamp;
    #endif`;

/** Direct light is dimmed less than the sky's, and blue fades before red: shade stays warm. */
const FRAGMENT_LIGHT = /* glsl */ `
#include <lights_fragment_end>
float grazing = 1.0 - saturate(dot(normal, normalize(vViewPosition)));
vec3 warmShade = pow(vec3(sky), vec3(0.88, 1.0, 1.14));
reflectedLight.indirectDiffuse *= warmShade;
reflectedLight.directDiffuse *= mix(vec3(1.0), warmShade, 0.8);
reflectedLight.directSpecular *= sky;
totalEmissiveRadiance += rimColour * (rimStrength * pow(grazing, RIM_POWER) * sky);`;

/** A ghost is denser where its surface turns away. */
const FRAGMENT_OPAQUE = /* glsl */ `
#ifdef GHOST
  diffuseColor.a = clamp(diffuseColor.a + edge * grazing * sqrt(grazing), 0.0, 1.0);
#endif
#include <opaque_fragment>`;

/** How much of the bind pose's own creases shows beside the shade between limbs. */
const CREASES = 0.8;
/** Spheres cover less than the limbs around them: their shade is deepened by this power. */
const LIMB_SHADE = 1.7;
const WHITE = new Color("#FFFFFF");

export class Clay {
  readonly material: MeshStandardMaterial;
  private readonly uniforms: ClayUniforms;

  constructor(private readonly options: ClayOptions) {
    this.uniforms = {
      key: { value: options.key },
      spheres: { value: options.spheres },
      rimColour: { value: new Color() },
      rimStrength: { value: 0 },
      edge: { value: 0 },
    };
    this.material = new MeshStandardMaterial({
      roughness: looks.material.roughness,
      metalness: looks.material.metalness,
      transparent: options.ghost !== null,
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
    const byLimbs = !ghost && tier === "full" && spheres.length > 0;
    return {
      ...(ghost ? { GHOST: 1 } : { SHADED: 1 }),
      ...(byLimbs ? { BY_LIMBS: 1 } : {}),
      ...(ghost === "original" ? { BEHIND_ONLY: 1 } : {}),
      SPHERES: spheres.length,
      SHADE_AMOUNT: looks.material.occlusion.toFixed(3),
      KEY_SHADE: looks.light.key.shadow.toFixed(3),
      CREASES: CREASES.toFixed(3),
      LIMB_SHADE: LIMB_SHADE.toFixed(3),
      RIM_POWER: looks.material.rim.power.toFixed(3),
    };
  }

  private extend(shader: { vertexShader: string; fragmentShader: string; uniforms: object }): void {
    Object.assign(shader.uniforms, this.uniforms);
    const declarations = FRAGMENT_DECLARATIONS.replace("SHADE_FUNCTIONS", limbShader(this.options.counts));
    const lights = ShaderChunk.lights_fragment_begin.replace(KEY_LIGHT, SHADED_KEY_LIGHT);
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", `#include <common>\n${VERTEX_DECLARATIONS}`)
      .replace("#include <fog_vertex>", VERTEX_END);
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <lights_pars_begin>", declarations)
      .replace("#include <lights_fragment_begin>", `${FRAGMENT_SHADE}\n${lights}`)
      .replace("#include <lights_fragment_end>", FRAGMENT_LIGHT)
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
