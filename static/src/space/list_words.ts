// The spaces of the list by their names, and each in a few words. No DOM in here.
import type { ListedSpace } from "./server";

/** A name's versions, the newest first; what was made last stands at the top. */
export function byName(spaces: readonly ListedSpace[]): ListedSpace[][] {
  const names = new Map<string, ListedSpace[]>();
  for (const space of spaces) names.set(space.name, [...(names.get(space.name) ?? []), space]);
  return [...names.values()].map((versions) => versions.sort((a, b) => b.number - a.number));
}

/** "27 examples" */
export const examplesWords = ({ examples }: ListedSpace): string => `${examples} example${examples === 1 ? "" : "s"}`;

/** Where its sliders come from, unless it is a study that can be named: "from clips alone" */
export function originWords({ study, simulated, interfaces }: ListedSpace): string {
  if (study) return "from a study of others";
  return simulated ? "from simulated raters" : interfaces.includes("adjectives") ? "from a study" : "from clips alone";
}

/** "by A Researcher, 22 November 2026" */
export function madeWords({ made_by, created_at }: ListedSpace): string {
  if (!made_by) return "comes with the server";
  return `by ${made_by}, ${new Date(created_at).toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" })}`;
}
