// What opens over the page: the choice of a slider, the choice of a clip, and how that clip joins the space.
import { html, nothing, type TemplateResult } from "lit";
import type * as studio from "../studio/server";
import { clustersOf, slidersOf } from "./model";
import type { Chosen } from "./pair_chooser";
import type { SpaceSession } from "./session";
import "../studio/picker";
import "./join_dialog";
import "./pair_chooser";

export interface DialogActs {
  choose(chosen: Chosen): void;
  pick(clip: string): void;
  join(clip: string): void;
}

export function dialogs(session: SpaceSession, { clips, language }: { clips: readonly studio.Clip[]; language: string }, acts: DialogActs): TemplateResult {
  const there = new Set(session.space.definition.examples.map(({ clip }) => clip));
  const heard = (act: (clip: string) => void) => ({ detail }: CustomEvent<string>) => act(detail);
  return html`${pairs(session, language, acts)}
    <clip-picker .clips=${clips.filter(({ id }) => !there.has(id))} @pick=${heard(acts.pick)}></clip-picker>
    <join-dialog space=${session.space.id} language=${language} next=${session.nextVersion} @join=${heard(acts.join)}></join-dialog>`;
}

function pairs({ place, space }: SpaceSession, language: string, { choose }: DialogActs): TemplateResult | typeof nothing {
  const { by } = place;
  const sliders = by === "weights" ? null : space.definition[by];
  if (by === "weights" || !sliders) return nothing;
  const clusters = clustersOf(sliders, slidersOf(space, by, language), language);
  return html`<pair-chooser heading=${by === "adjectives" ? "Choose a pair" : "Choose a feature"} .clusters=${clusters}
    .taken=${Object.keys(place[by])} @choose=${({ detail }: CustomEvent<Chosen>) => choose(detail)}></pair-chooser>`;
}
