// <stimulus-dialog>: one stimulus seen moving, what it is made of, and what the results call it. What is made only
// when the study is published is shown here as it will be.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { keyed } from "lit/directives/keyed.js";
import { live } from "lit/directives/live.js";
import { api, ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { icon } from "../icons";
import type { Clip } from "../library/model";
import type { MotionViewer } from "../viewer";
import { shownOf } from "./clips";
import { idOf, type Editing } from "./form";
import { at, textOf, type Json, type Path } from "./model";
import { calledOf, newestOf } from "./spaces";
import { editOf, factsOf, isMade, named } from "./stimulus";
import "../viewer";

interface Motion {
  /** Whose figure moves. */
  clip: Clip;
  /** Another motion of the same skeleton than the clip's own. */
  made: ArrayBuffer | null;
}

@customElement("stimulus-dialog")
export class StimulusDialog extends LitElement {
  @property({ attribute: false }) editing!: Editing;
  @state() private path: Path | null = null;
  @state() private motion: Motion | null = null;
  /** What the space that it is made in is called. */
  @state() private space = "";
  @state() private loading = false;
  @state() private problem: ApiError | null = null;
  @query("motion-viewer") private viewer!: MotionViewer | null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  show(path: Path): void {
    Object.assign(this, { path, motion: null, space: "", problem: null, loading: true });
    void this.updateComplete.then(() => this.querySelector("dialog")?.showModal());
    void this.load(path);
  }

  private async load(path: Path): Promise<void> {
    try {
      const stimulus = at(this.editing.study, path);
      const space = textOf(at(stimulus, ["made", "space"]));
      if (space) this.space = await calledOf(space);
      const motion = await this.motionOf(stimulus);
      if (path === this.path) this.motion = motion;
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      if (path === this.path) this.problem = error;
    }
    if (path === this.path) this.loading = false;
  }

  private async motionOf(stimulus: Json | undefined): Promise<Motion | null> {
    const { clip } = shownOf(stimulus, this.editing.clips);
    if (!isMade(stimulus)) return clip ? { clip, made: null } : null;
    const edit = await editOf(stimulus, clip?.id, newestOf);
    const source = this.editing.clips.find(({ id }) => id === edit.source);
    return source ? { clip: source, made: await api.bytesFor("/api/v1/clips/preview", edit) } : null;
  }

  private readonly ready = (): void => {
    if (this.motion?.made) this.viewer?.setMotion(0, this.motion.made);
  };

  protected override render(): TemplateResult | typeof nothing {
    const { path, editing } = this;
    if (!path) return nothing;
    const stimulus = at(editing.study, path);
    const { clip, name } = shownOf(stimulus, editing.clips);
    const close = () => this.querySelector("dialog")?.close();
    const call = (event: Event) => editing.set(path, named(stimulus, (event.target as HTMLInputElement).value));
    return html`<dialog class="builder-dialog stimulus-dialog" aria-labelledby="stimulus-title" @close=${() => (this.path = null)}>
      <header><h2 class="figure-title" id="stimulus-title">${name}</h2>
        <button class="button quiet icon-button" type="button" aria-label="Close" @click=${close}>${icon("close")}</button></header>
      <div class="stimulus-stage">${this.stage(name)}</div>
      <dl class="facts-list">${factsOf(stimulus, clip?.name, this.space).map(([word, value]) => html`<div><dt>${word}</dt><dd>${value}</dd></div>`)}</dl>
      <div class="field"><label for=${`${idOf(path)}-name`}>Name in the results</label>
        <input class="input" id=${`${idOf(path)}-name`} maxlength="64" autocomplete="off" spellcheck="false" placeholder=${clip?.name.slice(0, 64) ?? ""}
          .value=${live(textOf(at(stimulus, ["name"])))} ?disabled=${!editing.editable} @input=${call}></div>
      ${clip && !isMade(stimulus) ? html`<p><a href=${clip.page_url}>Show it in the library</a></p>` : nothing}</dialog>`;
  }

  private stage(name: string): unknown {
    const { motion, problem } = this;
    if (problem) return problemNote(problem, problem.transient ? () => this.show(this.path!) : undefined);
    if (!motion) return html`<p class="quiet" role="status">${this.loading ? "It is on its way." : "The library has no such clip."}</p>`;
    return keyed(motion, html`<motion-viewer theme="auto" controls="simple" autoplay loop="auto" label=${name} @ready=${this.ready}>
      <motion-figure src=${motion.clip.glb_url} figure=${motion.clip.figure_url ?? nothing}></motion-figure></motion-viewer>`);
  }
}
