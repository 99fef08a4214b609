// The middle: the figure, the example that is looked at, and what is said over them.
import { html, nothing, type TemplateResult } from "lit";
import { keyed } from "lit/directives/keyed.js";
import type { ApiError } from "../api";
import { bareStage, note, unreachable } from "../studio/stage_view";
import type { Space } from "./server";
import type { SpaceSession } from "./session";

export interface StageActs {
  ready(): void;
  motion(): void;
  goTo(index: number): void;
  again(): void;
  dismiss(): void;
}

export function stage(session: SpaceSession | null, failure: ApiError | null, acts: StageActs): TemplateResult {
  return html`<section class="studio-stage" aria-label="Stage" aria-busy=${session ? session.isBusy : !failure}>
    ${session ? figure(session.space, acts) : bareStage(failure ? "Nothing is on the stage" : "The examples are on their way")}
    ${session && session.looking !== null ? looked(session, session.looking, acts) : nothing}
    <div class="stage-notes">${notes(session, failure, acts)}</div></section>`;
}

/** Another version may have another first example, so it is another stage. */
const figure = ({ id, name, clips: [first] }: Space, { ready, motion }: StageActs) => keyed(id, html`<motion-viewer theme="auto" controls="views"
  arrange="one" autoplay loop="on" label=${name} @ready=${ready} @motion=${motion}>
  <motion-figure src=${first!.glb_url} figure=${first!.figure_url ?? nothing} as="clay"></motion-figure></motion-viewer>`);

const looked = (session: SpaceSession, index: number, { goTo }: StageActs) => html`<div class="looked" role="group" aria-label="Example">
  <p role="status"><span class="tiny">Example</span> <b>${session.space.clips[index]!.name}</b></p>
  <button class="button" type="button" @click=${() => goTo(index)}>Go there</button>
  <button class="button" type="button" @click=${() => session.look(null)}>Back to the mix</button></div>`;

function notes(session: SpaceSession | null, failure: ApiError | null, { again, dismiss }: StageActs): TemplateResult | typeof nothing {
  const act = (words: string, click: () => void) => html`<button class="link-button" type="button" @click=${click}>${words}</button>`;
  if (session?.problem?.transient) return unreachable(() => session.retry());
  if (session?.problem) return note(session.problem.message, session.problem.mend, act("Undo the change", () => session.undo()));
  if (!failure) return nothing;
  return note(failure.message, failure.mend, session ? act("All right", dismiss) : act("Load the space again", again));
}
