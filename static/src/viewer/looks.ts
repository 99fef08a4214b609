/** The figure's look from the design tokens, in the forms that the scene needs. */
import { Color } from "three";
import tokens from "../tokens.json";

export type Mode = "light" | "dark";
export type FigureRole = "clay" | "judged" | "reference" | "creation" | "original";
export type GhostKind = "target" | "original" | "loading";

export const looks = tokens.figure;
export const CAMERA_PRESET_MS = tokens.motion.cameraPreset;

export const ROLES: readonly FigureRole[] = ["clay", "judged", "reference", "creation", "original"];

export function isRole(name: string | null): name is FigureRole {
  return ROLES.includes(name as FigureRole);
}

/** A colour's numbers exactly as CSS has them (no conversion), for shaders that write them as is. */
export function plainColour(hex: string, target: Color): Color {
  const value = parseInt(hex.slice(1), 16);
  return target.setRGB((value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255, "srgb-linear");
}
