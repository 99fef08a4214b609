// <body-dialog>: a motion tried on another body, beside its own, with all that gets lost; then made.
// Event: `made` ClipDetail.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { keyed } from "lit/directives/keyed.js";
import type { ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { icon } from "../icons";
import { Latest } from "../studio/latest";
import { asApiError } from "../studio/session";
import type { MotionViewer } from "../viewer";
import * as server from "./bodies";
import type { Clip } from "./model";

interface Choice {
  body: server.Body;
  cut: server.Cut;
}

/** The figures on the stage. */
const OWN = 0;
const NEW = 1;

/** The stretch of the motion that is tried, on either body. */
interface Motions {
  own: ArrayBuffer;
  moved: ArrayBuffer;
}

@customElement("body-dialog")
export class BodyDialog extends LitElement {
  @state() private clip: Clip | null = null;
  @state() private bodies: readonly server.Body[] = [];
  @state() private choice: Choice | null = null;
  @state() private fit: server.Fit | null = null;
  @state() private problem: ApiError | null = null;
  @state() private making = false;
  @state() private made: server.ClipDetail | null = null;
  @query("dialog") private dialog!: HTMLDialogElement | null;
  @query("motion-viewer") private viewer!: MotionViewer | null;
  private readonly tries = new Latest<Choice>((choice) => this.attempt(choice));
  /** What is to be seen, once it has come. */
  private motions: Motions | null = null;
  private isReady = false;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  /** Offer these bodies for a kept clip; the first is tried at once. */
  show(clip: Clip, bodies: readonly server.Body[]): void {
    const [body] = bodies;
    if (!body) return;
    Object.assign(this, { clip, bodies, made: null, making: false, choice: null });
    this.choose({ body, cut: "none" });
    void this.updateComplete.then(() => this.dialog?.showModal());
  }

  private choose(choice: Choice): void {
    if (choice.body !== this.choice?.body) this.isReady = false;
    this.choice = choice;
    this.fit = this.problem = this.motions = null;
    this.present();
    this.tries.ask(choice);
  }

  private async attempt({ body, cut }: Choice): Promise<void> {
    const { clip } = this;
    if (!clip) return;
    const isWanted = () => this.clip === clip && this.choice?.body === body && this.choice.cut === cut;
    try {
      const onto = body.example.id;
      const [fit, own, moved] = await Promise.all([server.fitOf(clip, onto, cut), server.onItsOwn(clip, cut), server.preview(clip, onto, cut)]);
      if (isWanted()) Object.assign(this, { fit, motions: { own, moved } });
    } catch (error) {
      if (isWanted()) this.problem = asApiError(error);
    }
    this.present();
  }

  /** Show the second figure as soon as both it and its motion are here, and not before. */
  private present(): void {
    if (!this.isReady || !this.viewer) return;
    if (this.motions) {
      this.viewer.setMotion(OWN, this.motions.own);
      this.viewer.setMotion(NEW, this.motions.moved);
    }
    this.viewer.setShown(NEW, this.motions !== null);
  }

  private readonly ready = (): void => {
    this.isReady = true;
    this.present();
  };

  private async make(name: string): Promise<void> {
    const { clip, choice } = this;
    if (!clip || !choice) return;
    this.making = true;
    try {
      this.made = await server.make(clip, choice.body.example.id, choice.cut, name);
      this.dispatchEvent(new CustomEvent("made", { detail: this.made }));
      await this.updateComplete;
      this.querySelector<HTMLElement>(".made a")?.focus();
    } catch (error) {
      this.problem = asApiError(error);
    }
    this.making = false;
  }

  private close(): void {
    this.dialog?.close();
  }

  protected override render(): TemplateResult | typeof nothing {
    const { clip, choice } = this;
    if (!clip || !choice) return nothing;
    // The drawer around it would close by the same key.
    const stay = (event: KeyboardEvent) => event.stopPropagation();
    return html`<dialog class="body-dialog" aria-labelledby="body-title" @keydown=${stay} @close=${() => (this.clip = null)}>
      <header><h2 class="figure-title" id="body-title">${clip.name} on another body</h2>
        <button class="button quiet icon-button" type="button" aria-label="Close" @click=${() => this.close()}>${icon("close")}</button></header>
      <div class="body-stage">${this.stage(clip, choice.body)}</div>
      ${this.made ? this.done(this.made, choice.body) : this.form(clip, choice)}</dialog>`;
  }

  /** Another body is another stage. */
  private stage(clip: Clip, { id, example }: server.Body): unknown {
    return keyed(id, html`<motion-viewer theme="auto" controls="simple" arrange="beside" autoplay loop="on" @ready=${this.ready}
        label="${clip.name}, on its own body and on another">
      <motion-figure src=${clip.glb_url} figure=${clip.figure_url ?? nothing} as="original" label="its own body"></motion-figure>
      <motion-figure src=${example.glb_url} figure=${example.figure_url ?? nothing} as="clay" label="the other body"></motion-figure>
    </motion-viewer>`);
  }

  private form(clip: Clip, choice: Choice): TemplateResult {
    const submit = (event: SubmitEvent) => {
      event.preventDefault();
      void this.make(String(new FormData(event.target as HTMLFormElement).get("name")).trim());
    };
    return html`<form @submit=${submit}>
      <div class="body-choices">
        <fieldset><legend class="label">Body</legend><div class="body-list">${this.bodies.map((body) =>
          radio("body", body.example.name, server.bodyWords(body), body === choice.body, () => this.choose({ ...choice, body })))}</div></fieldset>
        ${clip.cyclic ? nothing : html`<fieldset><legend class="label">What of it</legend>${server.CUTS.map(([cut, words, hint]) =>
          radio("cut", words, hint, cut === choice.cut, () => this.choose({ ...choice, cut })))}</fieldset>`}
        <div class="body-fit" aria-live="polite">${this.told(clip, choice)}</div>
        <label class="field"><span class="label">Name</span>
          <input class="input" name="name" required maxlength="200" autocomplete="off" .value=${nameOf(clip, choice)}></label>
      </div>
      <footer><p class="tiny">${clip.name} stays as it is.</p>
        <button class="button primary" type="submit" ?disabled=${!this.fit || this.making}>${this.making ? "Being made" : "Make the clip"}</button></footer></form>`;
  }

  private told(clip: Clip, { body, cut }: Choice): TemplateResult {
    const { fit, problem } = this;
    if (problem) {
      const again = problem.transient ? () => this.choose({ body, cut }) : undefined;
      const mend = cut === "none" ? nothing : html`<p>Choose the whole motion, or say that all of it is one cycle.</p>`;
      return html`${problemNote(problem, again)}${mend}`;
    }
    if (!fit) return html`<p class="quiet" role="status">It is being tried on.</p>`;
    return html`<p class=${fit.fits ? "" : "note"}>${fit.fits ? nothing : icon("warning")}<span>${fit.sentence}</span></p>
      <dl class="facts-list">${server.lines(clip, body, fit).map(([word, value]) => html`<div><dt>${word}</dt><dd>${value}</dd></div>`)}</dl>`;
  }

  private done(made: server.ClipDetail, { clips, example }: server.Body): TemplateResult {
    return html`<div class="body-choices made"><p role="status"><b>${made.name}</b> is in the library. It moves the same skeleton as
        ${clips === 1 ? example.name : `${clips} other clips, ${example.name} among them`}.</p>
      <div class="buttons"><a class="button primary" href=${made.page_url}>Show it</a><a class="button" href="/studio/spaces">Go to the spaces</a></div></div>`;
  }
}

const nameOf = ({ name }: Clip, { body, cut }: Choice): string =>
  `${name}${cut === "none" ? "" : "_cycle"}_on_${body.example.name}`.slice(0, 200);

const radio = (group: string, words: string, hint: string, on: boolean, choose: () => void): TemplateResult => html`<label class="body-choice">
  <input type="radio" name=${group} .checked=${on} @change=${choose}><span><b>${words}</b><span class="tiny">${hint}</span></span></label>`;
