// <clip-library>: every motion at its best frame; search, filters, import and its reports.
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import { drawer } from "./drawer";
import { DropZone } from "./drop_zone";
import { ImportQueue, type ImportItem } from "./imports";
import { filtersOf, find, type Clip, type Imported } from "./model";
import type { Corrections } from "./corrections";
import { cardOf } from "./card";
import { chosenBar, isUsable } from "./chosen";
import "../viewer/thumbnails";

@customElement("clip-library")
export class ClipLibrary extends LitElement {
  @property({ type: Boolean, attribute: "signed-in" }) signedIn = false;
  @state() private clips: Clip[] | undefined;
  @state() private problem: ApiError | undefined;
  @state() private query = "";
  @state() private family = "";
  /** The import whose report or failure the drawer shows. */
  @state() private open: ImportItem | undefined;
  @state() private correcting = false;
  /** The clips that are chosen to do something with; null while clips are opened, not chosen. */
  @state() private chosen: readonly string[] | null = null;
  private readonly queue = new ImportQueue(this, (item) => this.settle(item));
  private readonly dropZone = new DropZone(this, (files) => this.take(files));

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
      this.clips = (await api.get<components["schemas"]["ClipList"]>("/api/v1/clips")).clips;
      this.problem = undefined;
    } catch (error) {
      this.problem = asApiError(error);
    }
    const asked = this.clips?.find(({ id }) => id === location.hash.slice(1));
    if (asked?.state === "to_confirm") void this.reopen(asked);
  }

  /** Show the report of a clip that an earlier visit left to be confirmed. */
  private async reopen(clip: Clip): Promise<void> {
    try {
      const { report } = await api.get<components["schemas"]["ClipDetail"]>(`/api/v1/clips/${clip.id}?motion=false`);
      if (report) this.show(this.queue.found({ clip, report, already_there: false }));
    } catch (error) {
      this.problem = asApiError(error);
    }
  }

  private take(files: Iterable<File>): void {
    if (this.signedIn) void this.queue.add(files);
    else location.assign("/research/sign-in?next=/library");
  }

  private settle(item: ImportItem): void {
    if (item.result) this.replace(item.result.clip);
    if (!this.open) this.show(item);
  }

  private show(item: ImportItem | undefined): void {
    this.open = item;
    this.correcting = false;
  }

  /** Put a clip in the place of the one that it follows; it stands first when it is new. */
  private replace(clip: Clip, before: string = clip.id): void {
    const others = (this.clips ?? []).filter(({ id }) => id !== before && id !== clip.id);
    this.clips = [clip, ...others];
  }

  /** A clip of the drawer was kept, or another was made of it, without leaving the report. */
  private follow({ detail }: CustomEvent<Clip>): void {
    if (this.open?.result?.clip.id === detail.id) this.open.result = { ...this.open.result, clip: detail };
    this.replace(detail);
  }

  private done(item: ImportItem): void {
    this.queue.remove(item);
    this.show(this.queue.items.find(({ state }) => state === "imported" || state === "failed"));
  }

  private async keep(item: ImportItem): Promise<void> {
    await this.attempt(async ({ clip }) => {
      await api.post(`/api/v1/clips/${clip.id}/confirm`);
      this.replace({ ...clip, state: "kept" });
      this.done(item);
    });
  }

  private async discard(item: ImportItem): Promise<void> {
    await this.attempt(async ({ clip }) => {
      await api.delete(`/api/v1/clips/${clip.id}`);
      this.clips = this.clips?.filter(({ id }) => id !== clip.id);
      this.done(item);
    });
  }

  private async correct(item: ImportItem, corrections: Corrections): Promise<void> {
    await this.attempt(async ({ clip }) => {
      if (Object.keys(corrections).length) {
        item.result = await api.patch<Imported>(`/api/v1/clips/${clip.id}`, corrections);
        this.replace(item.result.clip, clip.id);
      }
      this.correcting = false;
    });
  }

  private async attempt(act: (imported: Imported) => Promise<void>): Promise<void> {
    if (!this.open?.result) return;
    try {
      this.problem = undefined;
      await act(this.open.result);
    } catch (error) {
      this.problem = asApiError(error);
    }
  }

  protected override updated(changed: PropertyValues): void {
    if (!changed.has("open" as keyof this) && changed.get("correcting" as keyof this) === undefined) return;
    this.querySelector(".drawer")?.scrollTo(0, 0);
    this.querySelector<HTMLElement>(this.wantsFocus())?.focus({ preventScroll: !this.open });
  }

  /** Where a person goes on: a focus that falls off the page would be lost to a keyboard. */
  private wantsFocus(): string {
    if (!this.open) return ".file-button input";
    return this.correcting ? ".corrections select" : ".drawer [data-first]";
  }

  protected override render(): TemplateResult {
    return html`<div class="library-main">
        <header class="page-header"><h1>Library</h1><div class="buttons">${this.chooseButton()}${this.importButton()}</div></header>
        ${this.problem ? problemNote(this.problem, () => void this.load()) : nothing}
        ${this.clips?.length ? this.filters(this.clips) : nothing}
        ${this.progress()}
        ${this.clips ? this.grid(this.clips) : html`<p class="quiet" role="status">The motions are on their way.</p>`}
      </div>
      ${this.open ? this.drawer(this.open) : nothing}
      ${this.dropZone.over ? html`<div class="drop-hint"><p class="figure-title">Drop BVH files to import them</p></div>` : nothing}`;
  }

  private importButton(word = "Import motions"): TemplateResult {
    if (!this.signedIn) {
      return html`<a class="button" href="/research/sign-in?next=/library">${icon("import")}Sign in to import</a>`;
    }
    const choose = (event: Event) => {
      const input = event.target as HTMLInputElement;
      this.take([...(input.files ?? [])]);
      input.value = "";
    };
    return html`<label class="button primary file-button">${icon("import")}${word}
      <input type="file" accept=".bvh" multiple @change=${choose} @keydown=${openByEnter}></label>`;
  }

  private chooseButton(): TemplateResult | typeof nothing {
    if (!this.signedIn || !this.clips?.length) return nothing;
    return html`<button class="button quiet" type="button" aria-pressed=${this.chosen !== null} @click=${() => (this.chosen = this.chosen ? null : [])}>Choose clips</button>`;
  }

  private filters(clips: Clip[]): TemplateResult {
    const filter = (event: InputEvent) => (this.query = (event.target as HTMLInputElement).value);
    return html`<div class="library-filters">
      <label class="search">${icon("search")}<span class="visually-hidden">Search</span>
        <input class="input" type="search" placeholder="Name, style or tag" .value=${this.query} @input=${filter}></label>
      <div class="chips" role="group" aria-label="Show">
        ${filtersOf(clips).map(
          ({ id, label, count }) => html`<button class="chip" aria-pressed=${id === this.family}
            @click=${() => (this.family = id)}>${label} <span class="count">${count}</span></button>`,
        )}
      </div>
    </div>`;
  }

  private progress(): TemplateResult | typeof nothing {
    const busy = this.queue.busy;
    if (!busy.length) return nothing;
    const words = { waiting: "waiting", sending: "on its way", reading: "being read" };
    return html`<ul class="imports" role="status">
      ${busy.map(
        ({ file, state, share }) => html`<li><span>${file.name}</span>
          <span class="tiny">${words[state as keyof typeof words]}</span>
          <progress max="1" .value=${share} aria-label="${file.name}"></progress></li>`,
      )}
    </ul>`;
  }

  private grid(clips: Clip[]): TemplateResult {
    if (!clips.length) return this.empty();
    const found = find(clips, this.family, this.query);
    if (!found.length) {
      return html`<div class="empty" role="status"><h2 class="figure-title">No motion matches</h2>
        <p>Nothing here is called or tagged “${this.query}”.</p>
        <div class="buttons"><button class="button" @click=${() => ((this.query = ""), (this.family = ""))}>Show all ${clips.length}</button></div></div>`;
    }
    const { chosen } = this;
    return html`<ul class="clip-grid">${repeat(found, ({ id }) => id, (clip) => (chosen ? this.choice(clip, chosen) : this.card(clip)))}</ul>
      ${chosen ? chosenBar(chosen, found, (next) => (this.chosen = next)) : nothing}`;
  }

  private card(clip: Clip): TemplateResult {
    const fresh = clip.state === "to_confirm";
    const open = (event: Event) => {
      if (!fresh) return;
      event.preventDefault();
      const waiting = this.queue.items.find(({ result }) => result?.clip.id === clip.id);
      if (waiting) this.show(waiting);
      else void this.reopen(clip);
    };
    return html`<li><a class="clip-card ${fresh ? "fresh" : ""}" href=${clip.page_url} @click=${open}>${cardOf(clip)}</a></li>`;
  }

  private choice(clip: Clip, chosen: readonly string[]): TemplateResult {
    const on = chosen.includes(clip.id);
    const toggle = () => (this.chosen = on ? chosen.filter((id) => id !== clip.id) : [...chosen, clip.id]);
    return html`<li><button class="clip-card" type="button" aria-pressed=${on} ?disabled=${!isUsable(clip)} @click=${toggle}>${cardOf(clip)}</button></li>`;
  }

  private empty(): TemplateResult {
    return html`<div class="empty">
      <h2 class="figure-title">No motions yet</h2>
      <p>BVH files come in here, one or many at once. Each one gets a report of what was repaired.</p>
      <div class="buttons">${this.importButton()}</div></div>`;
  }

  private drawer(item: ImportItem): TemplateResult {
    return drawer(item, {
      correcting: this.correcting,
      others: this.queue.items.filter((other) => other !== item && other.state !== "waiting").length,
      keep: () => void this.keep(item),
      discard: () => void this.discard(item),
      leaveOut: () => this.done(item),
      follow: (event) => this.follow(event),
      close: () => this.show(undefined),
      change: (on) => (this.correcting = on),
      correct: (corrections) => void this.correct(item, corrections),
      retry: (options) => {
        this.show(undefined);
        void this.queue.retry(item, options);
      },
    });
  }
}

function asApiError(error: unknown): ApiError {
  if (error instanceof ApiError) return error;
  throw error;
}

const problemNote = (problem: ApiError, again: () => void) => html`<div class="note note-bad" role="alert">
  ${icon("warning")}<div><p><b>${problem.message}</b></p>${problem.mend ? html`<p>${problem.mend}</p>` : nothing}
  <p><button class="link-button" @click=${again}>Load the library again</button></p></div></div>`;

/** A file field opens by the space bar alone; it looks like a button, and buttons open by Enter too. */
function openByEnter(event: KeyboardEvent): void {
  if (event.key !== "Enter") return;
  event.preventDefault();
  (event.target as HTMLInputElement).click();
}
