// <space-list>: every authoring space, and the form that makes one from clips.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { icon } from "../icons";
import type { ClipPicker } from "../studio/picker";
import type { Clip } from "../studio/server";
import * as studio from "../studio/server";
import { asApiError } from "../studio/session";
import { fitted, fittingSteps, fittingWords } from "./fitting";
import * as server from "./server";
import { byName, examplesWords, madeWords, originWords } from "./list_words";
import type { SpaceRemoval } from "./space_removal";
import "./space_removal";
import "../studio/picker";
import "../viewer";

/** Fewer span nothing, more are not taken. */
const LEAST = 2;
const MOST = 64;

@customElement("space-list")
export class SpaceList extends LitElement {
  @state() private spaces: server.ListedSpace[] | undefined;
  @state() private clips: Clip[] = [];
  @state() private chosen: readonly string[] = [];
  @state() private problem: ApiError | null = null;
  @state() private refused: ApiError | null = null;
  @state() private making = false;
  @state() private told = "";
  @query(".make-dialog") private dialog!: HTMLDialogElement;
  @query("space-removal") private removal!: SpaceRemoval;
  @query("clip-picker") private picker!: ClipPicker;

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void this.load();
  }

  private async load(): Promise<void> {
    try {
      this.spaces = await server.spaces();
      this.problem = null;
    } catch (error) {
      this.problem = asApiError(error);
    }
  }

  private async begin(): Promise<void> {
    this.refused = null;
    this.dialog.showModal();
    try {
      this.clips = await studio.clips();
    } catch (error) {
      this.refused = asApiError(error);
    }
  }

  private async make(name: string): Promise<void> {
    this.making = true;
    this.refused = null;
    try {
      location.assign(`/studio/spaces/${(await server.make(name, this.chosen)).id}`);
    } catch (error) {
      this.refused = asApiError(error);
      this.making = false;
    }
  }

  /** Copies that fit the first take the places of those that do not. */
  private async fit(): Promise<void> {
    this.making = true;
    this.refused = null;
    try {
      const [first, ...others] = this.chosenClips;
      for (const clip of others) {
        const copy = await fitted(clip, first!, this.clips.map(({ name }) => name));
        if (copy === clip) continue;
        this.clips = [...this.clips, copy];
        this.chosen = this.chosen.map((id) => (id === clip.id ? copy.id : id));
      }
    } catch (error) {
      this.refused = asApiError(error);
    }
    this.making = false;
  }

  private get chosenClips(): Clip[] {
    return this.chosen.flatMap((id) => this.clips.filter((clip) => clip.id === id));
  }

  /** The way on where the chosen ones do not fit each other. */
  private misfits(): TemplateResult | typeof nothing {
    const [first, ...others] = this.chosenClips;
    const steps = others.map((clip) => fittingSteps(clip, first!)).filter(({ length }) => length);
    if (!steps.length) return nothing;
    const words = steps.reduce((longest, one) => (one.length > longest.length ? one : longest));
    return html`<div class="note">${icon("info")}<div><p>${steps.length} of them ${steps.length === 1 ? "does" : "do"} not fit ${first!.name}.</p>
      <p><button class="link-button" type="button" ?disabled=${this.making} @click=${() => void this.fit()}>Use copies that fit</button>
        <span class="tiny">${fittingWords(words)}</span></p></div></div>`;
  }

  protected override render(): TemplateResult {
    const { spaces, problem } = this;
    return html`<header class="page-header"><h1 tabindex="-1">Spaces</h1><div class="buttons">
        <button class="button ${spaces?.length === 0 ? "primary" : ""}" type="button" @click=${() => void this.begin()}>${icon("plus")}Make a space from clips</button></div></header>
      <p class="lede">In a space you make a motion by saying how it feels: example motions are mixed as the sliders ask.</p>
      <p class="removed" role="status">${this.told}</p>
      ${problem ? problemNote(problem, () => void this.load()) : spaces ? this.list(spaces) : html`<p class="quiet" role="status">The spaces are on their way.</p>`}
      ${this.form()}
      <space-removal @removed=${({ detail }: CustomEvent<string>) => void this.renew(detail)}></space-removal>
      <clip-picker several .clips=${this.clips} @pick=${({ detail }: CustomEvent<readonly string[]>) => this.add(detail)}></clip-picker>`;
  }

  private list(spaces: readonly server.ListedSpace[]): TemplateResult {
    if (!spaces.length) {
      return html`<div class="empty"><h2 class="figure-title">No space yet</h2>
        <p>Ask people about clips in a study with pairs of adjectives: its tab <i>Impressions</i> makes a space of their answers.
          Or make one from clips, without asking anybody: its sliders are then features of their motion.</p>
        <div class="buttons"><a class="button" href="/research/studies">Go to the studies</a></div></div>`;
    }
    return html`<ul class="rows space-rows">${byName(spaces).map((versions) => this.named(versions))}</ul>`;
  }

  /** A name with its newest version, and the older ones below. */
  private named(versions: readonly server.ListedSpace[]): TemplateResult {
    const [newest, ...older] = versions;
    return html`<li><h2 class="figure-title"><a href="/studio/spaces/${newest!.id}">${newest!.name}</a></h2>
      ${this.line(newest!, versions, html`version ${newest!.number}`)}
      ${older.length ? html`<details><summary>${older.length} older ${older.length === 1 ? "version" : "versions"}</summary>
        ${older.map((space) => this.line(space, versions, html`<a href="/studio/spaces/${space.id}" aria-label="${space.name}, version ${space.number}">version ${space.number}</a>`))}</details>` : nothing}</li>`;
  }

  private line(space: server.ListedSpace, versions: readonly server.ListedSpace[], version: TemplateResult): TemplateResult {
    const { study, study_title, may_delete, name, number } = space;
    return html`<p class="space-line"><span class="tag">${version}</span> <span>${examplesWords(space)}</span>
      <span>${study_title ? html`from <a href="/research/studies/${study}">${study_title}</a>` : originWords(space)}</span> <span>${madeWords(space)}</span>
      ${may_delete ? html`<button class="link-button" type="button" aria-haspopup="dialog" aria-label="Delete ${name}, version ${number}"
        @click=${() => void this.removal.ask(space, versions)}>Delete</button>` : nothing}</p>`;
  }

  /** The button that had the focus may be gone. */
  private async renew(told: string): Promise<void> {
    await this.load();
    this.told = told;
    this.querySelector<HTMLElement>("h1")?.focus();
  }

  private add(clips: readonly string[]): void {
    this.chosen = [...new Set([...this.chosen, ...clips])];
  }

  private form(): TemplateResult {
    const { chosen, making, refused } = this;
    const named = new Map(this.clips.map(({ id, name }) => [id, name]));
    const submit = (event: SubmitEvent) => {
      event.preventDefault();
      void this.make(String(new FormData(event.target as HTMLFormElement).get("name")).trim());
    };
    const fits = chosen.length >= LEAST && chosen.length <= MOST;
    return html`<dialog class="space-dialog make-dialog" aria-labelledby="make-title"><form @submit=${submit}>
      <header><h2 class="figure-title" id="make-title">Make a space from clips</h2>
        <button class="button quiet" type="button" @click=${() => this.dialog.close()}>Close</button></header>
      <p class="quiet">Clips of one skeleton, one cycle each where they walk. Nobody has to rate them: the sliders are features of their motion.</p>
      <label class="field"><span class="label">Name</span><input class="input" name="name" required maxlength="200" autocomplete="off"></label>
      <div class="field"><span class="label" id="chosen-title">Clips</span>
        ${chosen.length ? html`<ul class="chosen-clips" aria-labelledby="chosen-title" tabindex="0">${chosen.map((id) => html`<li><span>${named.get(id) ?? id}</span>
          <button class="link-button" type="button" aria-label="Leave out ${named.get(id)}" @click=${() => (this.chosen = chosen.filter((one) => one !== id))}>Leave out</button></li>`)}</ul>` : nothing}
        <button class="button" type="button" @click=${() => this.picker.show()}>${icon("plus")}Choose clips</button></div>
      ${refused ? problemNote(refused) : nothing}${this.misfits()}
      <footer><p class="tiny" role="status">${chosen.length} chosen, ${LEAST} to ${MOST} make a space.</p>
        <button class="button primary" type="submit" ?disabled=${!fits || making}>${making ? "Being made" : "Make the space"}</button></footer>
    </form></dialog>`;
  }
}
