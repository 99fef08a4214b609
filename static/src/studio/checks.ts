// The quality report in a person's words. No DOM in here.
import { rounded } from "./recipe";

export interface Finding {
  kind: string;
  part: string;
  start: number;
  end: number;
  size: number;
  unit: string;
  limit: number;
}

/** Kind to what is said of it: the fault (its part before, its size after), and what is right without one. */
const WORDS: Record<string, [fault: string, fine: string]> = {
  "foot slip": ["slides", "Planted feet hold within 5 mm"],
  floor: ["sinks", "Nothing sinks into the floor"],
  "joint range": ["bends", "Joints bend as far as joints do"],
  intersection: ["enters the body by", "Limbs stay out of the body"],
  balance: ["tips over by", "The body stays in balance"],
  jerk: ["jerks", "No new jerks"],
};

export const faultWords = ({ kind, part }: Finding): string =>
  `${capital(part)} ${WORDS[kind]?.[0] ?? `shows ${kind}:`}`;

/** What is right, for every kind that has no finding. */
export const fineLines = (findings: readonly Finding[]): string[] =>
  Object.entries(WORDS)
    .filter(([kind]) => findings.every((finding) => finding.kind !== kind))
    .map(([, [, fine]]) => fine);

/** "7 mm", "12°", "3.1 m/s³"; what is near its limit is not rounded to it. */
export function sizeWords(size: number, unit: string): string {
  if (unit === "m") return size < 0.1 ? `${Number((size * 1000).toFixed(size < 0.01 ? 1 : 0))} mm` : `${rounded(size, 0.01)} m`;
  if (unit === "°") return `${Math.round(size)}°`;
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : 2;
  return `${size.toFixed(digits)} ${unit}`.trim();
}

/** How far an edit was eased off; where nothing of it is left, that is said. */
export const easedWords = (share: number): string =>
  share > 0
    ? `Eased off to ${Math.round(share * 100)} % of what it was.`
    : "Only without the edit is all well. Undo brings it back.";

/** "at 4.9 s", or "from 4.9 to 6.2 s" for what lasts. */
export function timeWords({ start, end }: Finding): string {
  return end - start < 0.25
    ? `at ${start.toFixed(1)} s`
    : `from ${start.toFixed(1)} to ${end.toFixed(1)} s`;
}

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
