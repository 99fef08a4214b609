// What the studio asks of the server.
import { api } from "../api";
import type { components } from "../api-types";
import type { Schema } from "./form_model";
import type { Step, Steps } from "./recipe";

type Schemas = components["schemas"];
export type Clip = Schemas["ClipView"];
export type ClipDetail = Schemas["ClipDetail"];
export type Preset = Schemas["PresetView"];
export type Pose = Schemas["PoseView"];
export type Checked = Schemas["Checked"];
export type Operation = Omit<Schemas["OperationView"], "parameters"> & { parameters: Schema };

/** What came as JSON is JSON, though the generated types cannot say so. */
export const stepsOf = (recipe: Schemas["Step"][]): Steps => recipe as Step[];

/** A recipe applied to a clip. */
export interface Edited {
  source: string;
  operations: Steps;
}

export const clipOf = (id: string) => api.get<ClipDetail>(`/api/v1/clips/${id}?motion=false`);
export const clips = async () => (await api.get<Schemas["ClipList"]>("/api/v1/clips")).clips;
export const preview = (edited: Edited) => api.bytesFor("/api/v1/clips/preview", edited);
export const check = (edited: Edited) => api.post<Checked>("/api/v1/clips/check", edited);
export const easeOff = (edited: Edited) => api.post<Schemas["EasedOff"]>("/api/v1/clips/ease-off", edited);
export const save = (edited: Edited, name: string) => api.post<ClipDetail>("/api/v1/clips", { ...edited, name });
export const rename = (id: string, name: string) => api.put<ClipDetail>(`/api/v1/clips/${id}/label`, { name });
export const remove = (id: string) => api.delete(`/api/v1/clips/${id}`);
export const operations = async () =>
  (await api.get<{ operations: Operation[] }>("/api/v1/operations")).operations;
export const presets = async () => (await api.get<Schemas["PresetList"]>("/api/v1/presets")).presets;
export const poses = async () => (await api.get<Schemas["PoseList"]>("/api/v1/poses")).poses;
export const capture = (clip: string, frame: number, name: string) =>
  api.post<Pose>("/api/v1/poses", { clip, frame, name });
export const forget = (pose: string) => api.delete(`/api/v1/poses/${pose}`);
