// What the pages about authoring spaces ask of the server.
import { api } from "../api";
import type { components } from "../api-types";
import { stepsOf, type Edited } from "../studio/server";

type Schemas = components["schemas"];
export type Space = Schemas["SpaceDetail"];
export type ListedSpace = Schemas["ListedSpace"];
export type Versions = "one" | "all";
export type Sliders = Schemas["Sliders"];
export type Point = Schemas["Point"];
export type Prediction = Schemas["Prediction"];
export type Predicted = Schemas["PredictedParameter"];
export type Keytimes = Record<string, number>;
export type Words = Schemas["Words"];

/** A point's motion, and what the point means. */
export interface Blended {
  glb: ArrayBuffer;
  weights: number[];
  outside: number;
}

const at = (id: string): string => `/api/v1/spaces/${id}`;

export const spaces = async () => (await api.get<Schemas["SpaceList"]>("/api/v1/spaces")).spaces;
export const make = (name: string, clips: readonly string[]) => api.post<Space>("/api/v1/spaces", { name, clips });
/** Delete a space, or every version of its name; its clips stay. */
export const remove = (id: string, versions: Versions) => api.delete(at(id), { query: { versions } });
export const space = (id: string) => api.get<Space>(at(id));

export async function motion(id: string, point: Point): Promise<Blended> {
  const { bytes, headers } = await api.reply(`${at(id)}/motion`, point);
  return { glb: bytes, ...blendOf(headers) };
}

/** What the answer to a point says besides its motion. */
export function blendOf(headers: Headers): Pick<Blended, "weights" | "outside"> {
  const weights = (headers.get("Manner-Weights") ?? "").split(",").filter(Boolean).map(Number);
  return { weights, outside: Number(headers.get("Manner-Outside") ?? 0) };
}

export async function recipe(id: string, point: Point): Promise<Edited> {
  const { source, operations } = await api.post<Schemas["SpaceRecipe"]>(`${at(id)}/recipe`, point);
  return { source, operations: stepsOf(operations as Schemas["Step"][]) };
}

export const version = (id: string, change: { keytimes?: Record<string, Keytimes>; join?: string[] }) =>
  api.post<Space>(`${at(id)}/versions`, change);
export const prediction = (id: string, clip: string) => api.get<Prediction>(`${at(id)}/predictions/${clip}`);
export const keytimes = async (clip: string) =>
  (await api.get<Schemas["KeytimesView"]>(`/api/v1/clips/${clip}/keytimes`)).keytimes as Keytimes;
