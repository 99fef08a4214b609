// What the studio asks of the server.
import { api } from "../api";
import type { components } from "../api-types";
import type { Finding } from "./checks";
import type { Schema } from "./form_model";
import type { Steps } from "./recipe";

type Schemas = components["schemas"];
export type Clip = Schemas["ClipView"] & { recipe_source?: string | null };
export interface Provenance {
  source: string;
  source_name: string | null;
  recipe: Steps;
}
export type ClipDetail = Clip & { provenance?: Provenance | null };

export interface Operation {
  /** With its version, as recipes write it. */
  name: string;
  title: string;
  summary: string;
  parameters: Schema;
}

export interface Preset {
  name: string;
  title: string;
  summary: string;
  operations: Steps;
}

export interface Pose {
  id: string;
  name: string;
  /** It comes with the server. */
  stance: boolean;
}

export interface Checked {
  report: { clean: boolean; findings: Finding[] };
  contacts: { left: [number, number][]; right: [number, number][] };
  duration: number;
  frames: number;
}

export interface Eased {
  operations: Steps;
  share: number;
}

/** A recipe applied to a clip. */
export interface Edited {
  source: string;
  operations: Steps;
}

export const clipOf = (id: string) => api.get<ClipDetail>(`/api/v1/clips/${id}?motion=false`);
export const clips = async () => (await api.get<{ clips: Clip[] }>("/api/v1/clips")).clips;
export const preview = (edited: Edited) => api.bytesFor("/api/v1/clips/preview", edited);
export const check = (edited: Edited) => api.post<Checked>("/api/v1/clips/check", edited);
export const easeOff = (edited: Edited) => api.post<Eased>("/api/v1/clips/ease-off", edited);
export const save = (edited: Edited, name: string) => api.post<ClipDetail>("/api/v1/clips", { ...edited, name });
export const rename = (id: string, name: string) => api.put<ClipDetail>(`/api/v1/clips/${id}/label`, { name });
export const operations = async () =>
  (await api.get<{ operations: Operation[] }>("/api/v1/operations")).operations;
export const presets = async () => (await api.get<{ presets: Preset[] }>("/api/v1/presets")).presets;
export const poses = async () => (await api.get<{ poses: Pose[] }>("/api/v1/poses")).poses;
export const capture = (clip: string, frame: number, name: string) =>
  api.post<Pose>("/api/v1/poses", { clip, frame, name });
