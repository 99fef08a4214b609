// What a stimulus of a study file is: a clip, or how one is made. No DOM in here.
import { api } from "../api";
import type { components } from "../api-types";
import { at, inWords, isObj, listOf, objOf, textOf, type Json, type Obj } from "./model";

type Recipe = components["schemas"]["SpaceRecipe"];

/** How a clip is made; the source by its id. */
export interface Edit {
  source: string;
  preset?: string;
  operations?: Json[];
}

/** Whether publishing will make it; then it has no clip of its own yet. */
export const isMade = (stimulus: Json | undefined): boolean => isObj(at(stimulus, ["made"])) && !at(stimulus, ["clip"]);

/** Under another name in the results; without one, it is called as its clip. */
export function named(stimulus: Json | undefined, name: string): Obj {
  const { name: _, ...rest } = typeof stimulus === "string" ? { clip: stimulus } : objOf(stimulus);
  return name ? { ...rest, name } : rest;
}

/**
 * @param source id of the clip that it is made from, where the study names one.
 * @param spaceOf id of the space of this name.
 */
export async function editOf(stimulus: Json | undefined, source: string | undefined, spaceOf: (name: string) => Promise<string>): Promise<Edit> {
  const made = objOf(at(stimulus, ["made"]));
  if (made["space"]) {
    const point = { interface: interfaceOf(made), values: objOf(made["values"]) };
    const recipe = await api.post<Recipe>(`/api/v1/spaces/${await spaceOf(textOf(made["space"]))}/recipe`, point);
    return { source: recipe.source, operations: recipe.operations as unknown as Json[] };
  }
  const how = made["preset"] ? { preset: textOf(made["preset"]) } : { operations: listOf(made["operations"]) };
  return { source: source ?? textOf(made["source"]), ...how };
}

const interfaceOf = (made: Obj): string => textOf(made["interface"]) || "adjectives";
const BY: Record<string, string> = { adjectives: "adjectives", features: "motion features", weights: "weights of the examples" };

/**
 * What it is, line by line.
 * @param space what its space is called; without it, as the study file names it.
 */
export function factsOf(stimulus: Json | undefined, source: string | undefined, space?: string): [string, string][] {
  const made = at(stimulus, ["made"]);
  if (!isObj(made)) return [["What it is", "A clip of the library"]];
  const name = source ?? textOf(made["source"]);
  if (made["space"]) {
    const by = interfaceOf(made);
    const values = Object.entries(objOf(made["values"]));
    const told = by === "weights" ? [["Examples", String(values.length)]] : values.map(([id, value]) => [inWords(id), Number(value).toFixed(2)]);
    return [["Made in", space || textOf(made["space"])], ["By", BY[by] ?? by], ...told] as [string, string][];
  }
  const steps = listOf(made["operations"]).map((step) => inWords(textOf(at(step, ["operation"])).split("@")[0]));
  return [["Made from", name], ["By", made["preset"] ? inWords(made["preset"]) : steps.join(", ") || "nothing"]];
}
