// Forms out of JSON Schemas: which control a parameter gets, and what it starts with. No DOM in here.
import type { Json, Parameters } from "./recipe";

export interface Schema {
  title?: string;
  description?: string;
  type?: string | string[];
  enum?: Json[];
  anyOf?: Schema[];
  items?: Schema;
  properties?: Record<string, Schema>;
  required?: string[];
  minimum?: number;
  maximum?: number;
  minItems?: number;
  neutral?: number;
  unit?: string;
  default?: Json;
  pattern?: string;
  /** What the value is the id of. */
  refers?: "clip" | "pose";
}

export type Kind = "clip" | "number" | "choice" | "choices" | "flag" | "text" | "json";

/** Where a slider would be too coarse to hit anything, a field stands alone. */
const WIDEST_SLIDER = 100;

export function kindOf(schema: Schema): Kind {
  const types = [schema.type ?? []].flat();
  if (schema.refers === "clip") return "clip";
  if (schema.enum) return "choice";
  if (types.includes("boolean")) return "flag";
  if (types.includes("number") || types.includes("integer")) return "number";
  if (types.includes("array") && schema.items?.enum) return "choices";
  if (types.includes("string") || (schema.anyOf?.length && schema.anyOf.every(isText))) return "text";
  return "json";
}

const isText = (schema: Schema): boolean => schema.type === "string";

export const isWhole = (schema: Schema): boolean => [schema.type].flat().includes("integer");
export const mayBeNull = (schema: Schema): boolean =>
  [schema.type].flat().includes("null") || (schema.anyOf ?? []).some(({ type }) => type === "null");
export const hasSlider = ({ minimum, maximum, ...schema }: Schema): boolean =>
  minimum !== undefined && maximum !== undefined && maximum - minimum <= WIDEST_SLIDER && !mayBeNull(schema);

/** A step of a slider: fine enough for a hundred of them. */
export function stepOf(schema: Schema): number {
  if (isWhole(schema)) return 1;
  const width = (schema.maximum ?? 1) - (schema.minimum ?? 0);
  return width > 20 ? 0.5 : width > 8 ? 0.1 : 0.01;
}

/** What a parameter is before anybody has set it. */
export function startOf(schema: Schema): Json {
  if (schema.default !== undefined) return schema.default;
  if (schema.enum) return schema.enum[0] ?? null;
  const kind = kindOf(schema);
  if (kind === "number") return schema.neutral ?? schema.minimum ?? 0;
  if (kind === "flag") return false;
  if (kind === "text") return "";
  return [schema.type].flat().includes("array") ? [] : mayBeNull(schema) ? null : {};
}

/** Parameters to begin with; where another clip belongs, the clip itself stands until one is chosen. */
export const startingParameters = (schema: Schema, clip: string): Parameters =>
  Object.fromEntries(
    Object.entries(schema.properties ?? {}).map(([name, member]) => [name, kindOf(member) === "clip" ? clip : startOf(member)]),
  );

/** The words of a name that programs use. */
export const inWords = (name: Json): string => String(name).replaceAll("_", " ");

/** A text as JSON, or the reason why it is none. */
export function readJson(text: string): { value: Json } | { problem: string } {
  try {
    return { value: JSON.parse(text) as Json };
  } catch (error) {
    return { problem: (error as Error).message };
  }
}
