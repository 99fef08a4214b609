// <study-builder>: a study is made here, without code: its parts, a form for each, and how it looks.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import type { Clip } from "../library/model";
import { History } from "../studio/history";
import type { ClipPicker } from "../studio/picker";
import { addDialog, publishDialog, refusal, versionsDialog, type Changes } from "./dialogs";
import { ABOUT, CLIPS, CONSENT, fieldsOf, PAGES, SHOWN, TASKS, THANKS, WELCOME } from "./fields";
import { form, idOf, type Editing } from "./form";
import {
  at, duplicated, freeName, inWords, languagesOf, LANGUAGES, listOf, moved, partsOf, put, renamedPart, textOf, withoutPart,
  type Json, type Language, type Obj, type Path, type Problem, type Study,
} from "./model";
import { partsList, problemLinks, selectedBy, type Selected } from "./parts_list";
import { Saving } from "./saving";
import { isMade } from "./stimulus";
import type { StimulusDialog } from "./stimulus_dialog";
import { missingIn } from "./texts";
import "../studio/picker";
import "./preview";
import "./stimulus_dialog";

type View = "parts" | "form" | "preview";

@customElement("study-builder")
export class StudyBuilder extends LitElement {
  @state() private study!: Study;
  @state() private clips: readonly Clip[] = [];
  @state() private problems: readonly Problem[] = [];
  @state() private selected: Selected = "about";
  @state() private language: Language = "en";
  @state() private view: View = "form";
  @state() private canBeShown = false;
  @state() private stored = 0;
  @state() private allClips = false;
  @state() private several = false;
  @state() private publishing = { changes: null as Changes | null, refused: null as ApiError | null, busy: false, done: false };
  private history!: History<Json>;
  private saving!: Saving;
  private picked: (ids: string[]) => void = () => {};

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.open(JSON.parse(document.getElementById("study")!.textContent!) as Study);
    const [asked = "", member] = decodeURIComponent(location.hash.slice(1)).split("/");
    const index = partsOf(this.draft).findIndex(({ id }) => id === asked);
    if (index >= 0 && member) this.goTo(["parts", index, member]);
    else if (index >= 0) this.selected = index;
    else if (asked === "welcome" || asked === "thanks") this.selected = asked;
    else if (partsOf(this.draft).length) this.selected = 0;
    void this.loadClips();
    addEventListener("keydown", this.keys);
    addEventListener("beforeunload", this.leaving);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("keydown", this.keys);
    removeEventListener("beforeunload", this.leaving);
  }

  private open(study: Study): void {
    this.study = study;
    this.problems = study.problems;
    this.canBeShown = study.can_be_shown;
    const draft = (study.draft ?? study.definition ?? {}) as Json;
    this.history = new History<Json>(draft);
    this.saving = new Saving(study.slug, draft, study.saved_at, (saved) => {
      if (saved) {
        this.problems = saved.problems;
        this.canBeShown = saved.can_be_shown;
        this.stored += 1;
      }
      this.requestUpdate();
    });
    this.stored += 1;
  }

  private async loadClips(): Promise<void> {
    try {
      this.clips = (await api.get<components["schemas"]["ClipList"]>("/api/v1/clips")).clips;
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      setTimeout(() => void this.loadClips(), 3000); // stills and the picker wait; all else works
    }
  }

  private get draft(): Json {
    return this.history.present;
  }

  /** What is shown is no version, or no longer. */
  private get isDraft(): boolean {
    return this.study.draft !== null || this.draft !== (this.study.definition as Json);
  }

  private get editable(): boolean {
    return this.study.role !== "viewer";
  }

  private change(next: Json, control: string): void {
    this.history.set(next, control);
    this.keep();
  }

  private keep(): void {
    const parts = partsOf(this.draft).length;
    if (typeof this.selected === "number" && this.selected >= parts) this.selected = parts ? parts - 1 : "about";
    if (!languagesOf(this.draft).includes(this.language)) this.language = languagesOf(this.draft)[0]!;
    this.saving.keep(this.draft);
    this.requestUpdate();
  }

  private readonly set = (path: Path, value: Json | undefined): void => {
    const [first, index, member] = path;
    const renames = first === "parts" && member === "id" && path.length === 3;
    const next = renames ? renamedPart(this.draft, index as number, textOf(value)) : put(this.draft, path, value);
    this.change(next, path.join("."));
  };

  private undo(back: boolean): void {
    if (back) this.history.undo();
    else this.history.redo();
    this.keep();
  }

  private readonly keys = (event: KeyboardEvent): void => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || !this.editable) return;
    event.preventDefault();
    this.undo(!event.shiftKey);
  };

  private readonly leaving = (event: BeforeUnloadEvent): void => {
    if (!this.saving.isStored) event.preventDefault();
  };

  private select(what: Selected): void {
    this.selected = what;
    this.view = "form";
    this.allClips = false;
    const name = typeof what === "number" ? textOf(partsOf(this.draft)[what]?.["id"]) : what;
    history.replaceState(null, "", `#${encodeURIComponent(name)}`);
    void this.updateComplete.then(() => this.querySelector(".part-form")?.scrollTo({ top: 0 }));
  }

  private order(parts: Obj[]): void {
    const open = typeof this.selected === "number" ? partsOf(this.draft)[this.selected] : undefined;
    if (open) this.selected = parts.findIndex(({ id }) => id === open["id"]);
    this.change(put(this.draft, ["parts"], parts), "order");
  }

  private add(kind: string, task?: string): void {
    const parts = partsOf(this.draft);
    const id = freeName(task ? TASKS[task]!.title : PAGES[kind]!.title, parts.map((part) => textOf(part["id"])));
    const part = task ? { id, kind: "trials", task: TASKS[task]!.blank, stimuli: [], order: "shuffle" } : { id, ...PAGES[kind]!.blank };
    const place = typeof this.selected === "number" ? this.selected + 1 : this.selected === "thanks" ? parts.length : kind === "form" || kind === "instructions" ? 0 : parts.length;
    this.change(put(this.draft, ["parts"], [...parts.slice(0, place), part, ...parts.slice(place)]), "add part");
    this.select(place);
  }

  private readonly goTo = (where: Path): void => {
    this.select(selectedBy(where));
    this.allClips = true;
    void this.updateComplete.then(() => {
      for (let end = where.length; end > 0; end -= 1) {
        const found = document.getElementById(idOf(where.slice(0, end)));
        if (found) return found.focus();
      }
    });
  };

  private async openPublish(): Promise<void> {
    this.publishing = { changes: null, refused: null, busy: false, done: false };
    this.dialog("publish-dialog").showModal();
    await this.attempt(async () => {
      await this.saving.now();
      this.publishing = { ...this.publishing, changes: await api.get<Changes>(`/api/v1/studies/${this.study.slug}/changes`) };
    });
  }

  private async publish(): Promise<void> {
    this.publishing = { ...this.publishing, busy: true };
    await this.attempt(async () => {
      const changes = await api.post<Changes>(`/api/v1/studies/${this.study.slug}/publish`);
      this.publishing = { changes, refused: null, busy: false, done: true };
      this.open(await api.get<Study>(`/api/v1/studies/${this.study.slug}`));
    });
  }

  private async attempt(act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.publishing = { ...this.publishing, refused: error, busy: false };
      const found = error.where?.["problems"];
      if (Array.isArray(found)) this.problems = found as Problem[];
    }
  }

  private async discard(): Promise<void> {
    this.open(await api.delete<Study>(`/api/v1/studies/${this.study.slug}/draft`));
    this.dialog("versions-dialog").close();
  }

  private dialog(id: string): HTMLDialogElement {
    return this.querySelector<HTMLDialogElement>(`#${id}`)!;
  }

  private readonly pick = (several: boolean, chosen: (ids: string[]) => void): void => {
    this.several = several;
    this.picked = chosen;
    void this.updateComplete.then(() => this.querySelector<ClipPicker>("clip-picker")?.show());
  };

  private get editing(): Editing {
    return {
      study: this.draft, language: this.language, problems: this.problems, clips: this.clips, allClips: this.allClips,
      editable: this.editable, look: (path) => this.querySelector<StimulusDialog>("stimulus-dialog")?.show(path),
      set: this.set, pick: this.pick, showAllClips: () => (this.allClips = true),
    };
  }

  protected override render(): TemplateResult {
    const { study, problems, selected, editable } = this;
    const part = typeof selected === "number" ? textOf(partsOf(this.draft)[selected]?.["id"]) : selected === "welcome" ? ":welcome" : "";
    const show = (view: View, word: string) => html`<button type="button" aria-pressed=${this.view === view} @click=${() => (this.view = view)}>${word}</button>`;
    return html`${this.header()}
      <div class="segments view-choice" role="group" aria-label="What to show">${show("parts", "Parts")}${show("form", "Edit")}${show("preview", "Preview")}</div>
      <div class=${`builder show-${this.view}`}>
        ${partsList({ study: this.draft, problems, selected, editable, select: (what) => this.select(what), order: (next) => this.order(next), add: () => this.dialog("add-dialog").showModal(), goTo: this.goTo })}
        <section class="part-form" aria-label="Form">${this.failure()}${this.partForm()}</section>
        <study-preview slug=${study.slug} ?made=${partsOf(this.draft).some((part) => listOf(part["stimuli"]).some(isMade))} at=${part} language=${this.language} stored=${this.stored} ?waiting=${!this.canBeShown} ?held=${!this.saving.isStored}></study-preview>
      </div>
      ${addDialog((kind, task) => this.add(kind, task))}
      ${publishDialog({ ...this.publishing, state: study.state, slug: study.slug, mend: this.mend(), publish: () => void this.publish() })}
      ${versionsDialog(study, this.isDraft, editable && study.versions.length ? () => void this.discard() : null)}
      <stimulus-dialog .editing=${this.editing}></stimulus-dialog>
      <clip-picker .clips=${this.clips as Clip[]} ?several=${this.several} @pick=${(event: CustomEvent<string | string[]>) => this.picked([event.detail].flat())}></clip-picker>`;
  }

  /** What keeps the study from being published, each with the way there. */
  private mend(): TemplateResult | null {
    if (!Array.isArray(this.publishing.refused?.where?.["problems"])) return null;
    const leave = (where: Path) => {
      this.dialog("publish-dialog").close();
      this.goTo(where);
    };
    return html`<div class="problems" role="alert"><p>First to be mended:</p>${problemLinks(this.draft, this.problems, leave)}</div>`;
  }

  private header(): TemplateResult {
    const { study, history } = this;
    const [newest] = study.versions;
    const version = this.isDraft ? `draft · version ${(newest?.number ?? 0) + 1}` : `version ${newest?.number}`;
    const act = (word: string, name: string, can: boolean, back: boolean) => html`<button class="button quiet" type="button" ?disabled=${!can} @click=${() => this.undo(back)}>${icon(name)}<span class="word">${word}</span></button>`;
    return html`<header class="builder-top"><h1>${textOf(at(this.draft, ["title"])) || study.title}</h1>
      <span class="tiny saved" role="status">${this.editable ? { saved: "Saved", waiting: "Saving", failed: "Not saved" }[this.saving.state] : "You may look, not change"}</span>
      <button class="tag" type="button" title="Versions and files" @click=${() => this.dialog("versions-dialog").showModal()}>${version}</button>
      ${this.editable ? html`<div class="buttons">${act("Undo", "undo", history.canUndo, true)}${act("Redo", "redo", history.canRedo, false)}
        <button class="button primary" type="button" @click=${() => void this.openPublish()}>Publish</button></div>` : nothing}</header>`;
  }

  private failure(): TemplateResult | typeof nothing {
    const { failure } = this.saving;
    return failure ? refusal(failure) : nothing;
  }

  private partForm(): TemplateResult {
    const { selected, editing } = this;
    return html`${this.languageChoice()}<fieldset class="form" ?disabled=${!this.editable}>${selected === "about"
      ? html`<header><h2>The study</h2></header>${form(ABOUT, [], editing)}`
      : selected === "welcome"
        ? html`<header><h2>Welcome</h2></header>${form(WELCOME, [], editing)}<header><h2>Consent</h2></header>${form(CONSENT, [], editing)}`
        : selected === "thanks"
          ? html`<header><h2>Thanks and code</h2><p class="quiet">The code is added by itself. Which code, the settings say.</p></header>${form(THANKS, [], editing)}`
          : this.formOfPart(selected)}</fieldset>`;
  }

  private formOfPart(index: number): TemplateResult {
    const parts = partsOf(this.draft);
    const part = parts[index]!;
    const task = TASKS[textOf(at(part, ["task", "kind"]))];
    const kind = part["kind"] === "trials" ? task : PAGES[textOf(part["kind"])];
    const act = (word: string, can: boolean, run: () => void, name: string) => html`<button class="button quiet" type="button" ?disabled=${!can} @click=${run}>${icon(name)}${word}</button>`;
    const base = ["parts", index];
    return html`<header><h2>${inWords(part["id"])}</h2><p class="quiet">${kind ? `${kind.title}. ${kind.about}.` : `This kind, ${textOf(part["kind"])}, is not known here.`}</p>
      <div class="buttons part-acts">${act("Up", index > 0, () => this.order(moved(parts, index, index - 1)), "up")}${act("Down", index < parts.length - 1, () => this.order(moved(parts, index, index + 1)), "down")}
        ${act("Duplicate", true, () => this.change(duplicated(this.draft, index), "duplicate"), "copy")}${act("Remove", true, () => this.change(withoutPart(this.draft, index), "remove"), "close")}</div></header>
      ${task ? html`${form(task.fields, base, this.editing)}${form(CLIPS, base, this.editing)}${form(SHOWN, base, this.editing)}` : form(fieldsOf(part), base, this.editing)}`;
  }

  /** Which language's texts the form shows; how many texts each still lacks. */
  private languageChoice(): TemplateResult | typeof nothing {
    const languages = languagesOf(this.draft);
    if (languages.length < 2) return nothing;
    const missing = missingIn(this.draft, this.language);
    const name = (id: Language) => LANGUAGES.find(([one]) => one === id)![1];
    return html`<div class="language-choice"><div class="segments" role="group" aria-label="Language of the texts">${languages.map(
      (id) => html`<button type="button" lang=${id} aria-pressed=${id === this.language} @click=${() => (this.language = id)}>${name(id)}</button>`)}</div>
      ${missing.length ? html`<p class="tiny"><button class="link-button" type="button" @click=${() => this.goTo(missing[0]!.path)}>${missing.length} ${missing.length === 1 ? "text is" : "texts are"} missing</button>; ${name(languages[0]!)} is shown instead.</p>` : nothing}</div>`;
  }
}
