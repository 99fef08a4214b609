// <clip-picker>: a dialog with every motion, found by its words; one is picked, or several together.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { icon } from "../icons";
import { cardOf } from "../library/card";
import { filtersOf, find } from "../library/model";
import type { Clip } from "./server";

@customElement("clip-picker")
export class ClipPicker extends LitElement {
  @property({ attribute: false }) clips: Clip[] = [];
  @property({ type: Boolean }) several = false;
  @state() private chosen: readonly string[] = [];
  @state() private query = "";
  @state() private family = "";
  @state() private open = false;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  show(): void {
    this.open = true;
    this.chosen = [];
    void this.updateComplete.then(() => {
      this.dialog?.showModal();
      this.querySelector<HTMLInputElement>("input[type=search]")?.focus();
    });
  }

  private get dialog(): HTMLDialogElement | null {
    return this.querySelector("dialog");
  }

  protected override render(): TemplateResult | typeof nothing {
    if (!this.open) return nothing;
    const usable = this.clips.filter(({ figure_url, state }) => figure_url && state === "kept");
    const found = find(usable, this.family, this.query);
    const search = (event: InputEvent) => (this.query = (event.target as HTMLInputElement).value);
    return html`<dialog class="picker" aria-label=${this.several ? "Choose clips" : "Choose a clip"} @close=${() => (this.open = false)}>
      <header><h2 class="figure-title">${this.several ? "Choose clips" : "Choose a clip"}</h2>
        <button class="button quiet icon-button" type="button" aria-label="Close" @click=${() => this.dialog?.close()}>${icon("close")}</button></header>
      <div class="library-filters"><label class="search">${icon("search")}<span class="visually-hidden">Search</span>
          <input class="input" type="search" placeholder="Name, style or tag" .value=${this.query} @input=${search}></label>
        <div class="chips" role="group" aria-label="Show">${filtersOf(usable).map(
          ({ id, label, count }) => html`<button class="chip" type="button" aria-pressed=${id === this.family} @click=${() => (this.family = id)}>
            ${label} <span class="count">${count}</span></button>`,
        )}</div></div>
      <div class="picker-clips">${found.length
        ? html`<ul class="clip-grid">${repeat(found, ({ id }) => id, (clip) => this.card(clip))}</ul>`
        : html`<p class="quiet" role="status">${usable.length ? "No motion matches." : "The motions are on their way."}</p>`}</div>
      ${this.several ? this.footer(found) : nothing}
    </dialog>`;
  }

  private footer(found: readonly Clip[]): TemplateResult {
    const ids = found.map(({ id }) => id);
    const all = ids.length > 0 && ids.every((id) => this.chosen.includes(id));
    const toggleAll = () => (this.chosen = all ? this.chosen.filter((id) => !ids.includes(id)) : [...new Set([...this.chosen, ...ids])]);
    const { length } = this.chosen;
    return html`<footer><button class="button quiet" type="button" ?disabled=${!ids.length} @click=${toggleAll}>${all ? "None of these" : `All ${ids.length}`}</button>
      <button class="button primary" type="button" ?disabled=${!length} @click=${() => this.pick(this.chosen)}>Add ${length === 1 ? "1 clip" : `${length} clips`}</button></footer>`;
  }

  private pick(picked: string | readonly string[]): void {
    this.dialog?.close();
    this.dispatchEvent(new CustomEvent("pick", { detail: picked }));
  }

  private card(clip: Clip): TemplateResult {
    const on = this.chosen.includes(clip.id);
    const pick = () => {
      if (!this.several) this.pick(clip.id);
      else this.chosen = on ? this.chosen.filter((id) => id !== clip.id) : [...this.chosen, clip.id];
    };
    return html`<li><button class="clip-card" type="button" aria-pressed=${this.several ? on : nothing} @click=${pick}>
      ${cardOf(clip)}</button></li>`;
  }
}
