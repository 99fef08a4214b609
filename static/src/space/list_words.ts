// A space of the list in a line of words.
import type { SpaceLine } from "./server";

/** "27 examples · from the study Walking, set B · by A Researcher · 22 November 2026" */
export function lineWords({ examples, study, interfaces, made_by, created_at }: SpaceLine): string {
  const when = new Date(created_at).toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" });
  return [
    `${examples} example${examples === 1 ? "" : "s"}`,
    ...(study ? [`from the study ${study}`] : interfaces.includes("adjectives") ? [] : ["from clips alone"]),
    ...(made_by ? [`by ${made_by}`] : []),
    when,
  ].join(" · ");
}
