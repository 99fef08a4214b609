// The middle: the figures, what is said over them, and the buttons that choose what is seen.
import { html, nothing, type TemplateResult } from "lit";
import { keyed } from "lit/directives/keyed.js";
import type { ApiError } from "../api";
import { icon } from "../icons";
import { inWords } from "./form_model";
import type { Session } from "./session";

export interface StageState {
  arrangement: "ghost" | "beside" | "one";
  original: boolean;
  failure: ApiError | null;
}

export interface StageActs {
  ready(): void;
  motion(): void;
  choose(): void;
  again(): void;
  dismiss(): void;
  arrange(arrangement: StageState["arrangement"]): void;
}

export function stage(session: Session | null, state: StageState, acts: StageActs): TemplateResult {
  return html`<section class="studio-stage" aria-label="Stage" aria-busy=${session !== null && session.isBusy}>
    ${session ? figures(session, acts) : empty(state, acts)}
    ${session ? tools(state, acts) : nothing}
    <div class="stage-notes">${notes(session, state, acts)}</div>
  </section>`;
}

/** Another source is another stage: nothing of the one before may stay. */
const figures = ({ source }: Session, acts: StageActs) =>
  keyed(
    source.id,
    html`<motion-viewer theme="auto" controls="views" arrange="ghost" autoplay loop="on" label="${source.name}, edited and original"
      @ready=${acts.ready} @motion=${acts.motion}>
      <motion-figure src=${source.glb_url} figure=${source.figure_url ?? nothing} as="clay" label="edited"></motion-figure>
      <motion-figure src=${source.glb_url} figure=${source.figure_url ?? nothing} as="original" label="original" ghost></motion-figure>
    </motion-viewer>`,
  );

function tools({ arrangement }: StageState, acts: StageActs): TemplateResult {
  const choose = (kind: StageState["arrangement"]) => () => acts.arrange(arrangement === kind ? "one" : kind);
  return html`<div class="stage-tools" role="group" aria-label="Original">
      <button class="button" type="button" title="Key G" aria-pressed=${arrangement === "ghost"} @click=${choose("ghost")}>${icon("ghost")}Ghost</button>
      <button class="button" type="button" aria-pressed=${arrangement === "beside"} @click=${choose("beside")}>${icon("beside")}Beside</button>
    </div>`;
}

function notes(session: Session | null, { failure }: StageState, { again, dismiss }: StageActs): TemplateResult | typeof nothing {
  if (session?.problem) return trouble(session.problem, session);
  if (failure) {
    const [words, act] = session ? ["All right", dismiss] : ["Load the studio again", again];
    return note(failure.message, failure.mend, html`<button class="link-button" type="button" @click=${act}>${words}</button>`);
  }
  if (!session?.fromDraft || session.isSaved) return nothing;
  return html`<div class="note" role="status">${icon("info")}<p>These are your edits of last time, not yet saved.
    <button class="link-button" type="button" @click=${() => session.startOver()}>Start over</button></p></div>`;
}

/** What you see stays the last motion that could be made. */
function trouble(problem: ApiError, session: Session): TemplateResult {
  if (problem.transient) return unreachable(() => session.retry());
  const step = session.faultyStep;
  const place = step === null ? "" : `Step ${step + 1}, ${inWords(session.steps[step]?.operation.split("@")[0] ?? "")}: `;
  return note(place + problem.message, problem.mend, html`<button class="link-button" type="button" @click=${() => session.undo()}>Undo the change</button>`);
}

export const unreachable = (retry: () => void): TemplateResult => html`<div class="note" role="status">${icon("cloud")}<p><b>The server cannot be reached.</b>
  Your edits are kept here; the figure follows as soon as it answers.
  <button class="link-button" type="button" @click=${retry}>Try now</button></p></div>`;

export const note = (message: string, mend: string | null, act: TemplateResult | typeof nothing = nothing) =>
  html`<div class="note note-bad" role="alert">${icon("warning")}<div><p><b>${message}</b></p>${mend ? html`<p>${mend}</p>` : nothing}<p>${act}</p></div></div>`;

const empty = ({ failure }: StageState, { choose }: StageActs) => bareStage(
  failure ? "Nothing is on the stage" : "Which motion shall it be?",
  html`<button class="button primary" type="button" @click=${choose}>Choose a clip</button>`,
);

/** The floor, before anybody stands on it. */
export const bareStage = (title: string, act: TemplateResult | typeof nothing = nothing): TemplateResult => html`<div class="empty">
  <svg class="disc" viewBox="0 0 220 80" aria-hidden="true"><path d="M8 66 92 14M60 72 138 12M128 72 172 18M30 22l160 40M70 12l140 34M6 44l120 30" stroke-width="1" fill="none"></path><ellipse class="rim" cx="110" cy="42" rx="84" ry="26" stroke-width="1.4"></ellipse></svg>
  <h2 class="figure-title">${title}</h2>
  <div class="buttons">${act}</div></div>`;
