// What is said about an edited clip. No DOM in here.
import type { components } from "../api-types";

export type Finding = components["schemas"]["Finding"];

export const findingPlace = ({ start, end }: Finding): string =>
  start.toFixed(2) === end.toFixed(2) ? `${start.toFixed(2)} s` : `${start.toFixed(2)} to ${end.toFixed(2)} s`;

/** "21 mm, up to 5 mm would do": lengths below a metre in millimetres, as feet slide. */
export function findingSize({ size, limit, unit }: Finding): string {
  const told = unit === "m" && size < 1
    ? [`${(size * 1000).toFixed(0)} mm`, `${(limit * 1000).toFixed(0)} mm`]
    : [size, limit].map((value) => `${rounded(value)}${unit === "°" ? "" : " "}${unit}`);
  return `${told[0]}; up to ${told[1]} would do`;
}

export function rebuiltWords(identical: boolean, isOther: boolean): string {
  if (isOther) {
    return identical
      ? "This engine makes the same motion, to the last bit; it is kept beside this one."
      : "This engine makes another motion; it is kept beside this one.";
  }
  return identical
    ? "Made again: the same motion, to the last bit."
    : "Made again, it came out differently. The files of this clip may be damaged.";
}

const rounded = (value: number): string => String(Number(value.toPrecision(3))).replace("-", "−");
