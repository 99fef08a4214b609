// <use-in-study clip="…">: the button by which a clip comes into a study, and its dialog. Where there are several
// clips, or where one is made only now, `ids` gives them; none, where the page has said why it has none.
// Pages that hold it load styles/dialogs.css.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import { counted } from "../library/model";
import { refusal } from "./dialogs";
import type { Study } from "./model";
import { address, outcome, places, type Added, type Draft, type Outcome, type Place } from "./uses";

type Template = components["schemas"]["TemplateLine"];

const SIMPLEST = { id: "", title: "One question", summary: "How natural is it? One slider, to begin with." };

@customElement("use-in-study")
export class UseInStudy extends LitElement {
  @property() clip = "";
  /** The clips as they stand when the button is pressed. */
  @property({ attribute: false }) ids: () => readonly string[] | Promise<readonly string[]> = () => [this.clip];
  @property({ type: Boolean }) disabled = false;
  /** What the button looks like. */
  @property() look = "button";
  @state() private chosen: readonly string[] = [];
  @state() private drafts: Draft[] | null = null;
  @state() private templates: Template[] = [];
  @state() private template = SIMPLEST.id;
  @state() private refused: ApiError | null = null;
  @state() private done: Outcome | null = null;
  @state() private busy = false;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  /** Ask which study. */
  async open(): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    try {
      this.chosen = await this.ids();
    } finally {
      this.busy = false;
    }
    if (!this.chosen.length) return;
    Object.assign(this, { drafts: null, done: null, refused: null, template: SIMPLEST.id });
    await this.updateComplete;
    this.dialog?.showModal();
    await this.attempt(() => this.load());
    this.querySelector<HTMLElement>(".use-dialog .kinds button, .use-dialog select")?.focus();
  }

  private async load(): Promise<void> {
    const [{ drafts }, { templates }] = await Promise.all([
      api.get<{ drafts: Draft[] }>("/api/v1/study-drafts"),
      api.get<{ templates: Template[] }>("/api/v1/study-templates"),
    ]);
    Object.assign(this, { drafts, templates });
  }

  private async add(place: Place): Promise<void> {
    await this.attempt(async () => {
      const added = await api.post<Added>(`/api/v1/studies/${place.slug}/draft/clips`, { clips: this.chosen, part: place.part });
      this.done = outcome(place, added, this.drafts?.find(({ slug }) => slug === place.slug));
    });
  }

  private readonly begin = async (event: SubmitEvent): Promise<void> => {
    event.preventDefault();
    const title = String(new FormData(event.target as HTMLFormElement).get("title")).trim();
    await this.attempt(async () => {
      const wanted = { title, clips: this.chosen, ...(this.template ? { template: this.template } : {}) };
      const study = await api.post<Study>("/api/v1/studies", wanted);
      const parts = (study.draft?.["parts"] ?? []) as { id: string; kind: string }[];
      const about = `A new study with ${counted(this.chosen.length, "clip")}. Look through its texts before you publish it.`;
      this.done = { title: `Added to ${study.title}`, about, address: address(study.slug, parts.find(({ kind }) => kind === "trials")!.id) };
    });
  };

  private async attempt(act: () => Promise<void>): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    this.refused = null;
    try {
      await act();
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.refused = error;
    }
    this.busy = false;
    if (!this.done) return;
    await this.updateComplete;
    this.querySelector<HTMLElement>("dialog a")?.focus();
  }

  private get dialog(): HTMLDialogElement | null {
    return this.querySelector("dialog");
  }

  protected override render(): TemplateResult {
    const close = () => this.dialog?.close();
    // A drawer around it would close by the same key.
    const stay = (event: KeyboardEvent) => event.stopPropagation();
    return html`<button class=${this.look} type="button" aria-haspopup="dialog" ?disabled=${this.disabled} aria-busy=${this.busy} @click=${() => void this.open()}>${icon("studies")}Use in a study</button>
      <dialog class="builder-dialog use-dialog" aria-label="Use in a study" @keydown=${stay}>
        <header><h2 class="figure-title">${this.done?.title ?? "Use in a study"}</h2>
          <button class="button quiet icon-button" type="button" aria-label="Close" @click=${close}>${icon("close")}</button></header>
        ${this.refused ? refusal(this.refused) : nothing}
        ${this.done ? this.told(this.done, close) : this.choices()}</dialog>`;
  }

  private told({ about, address }: Outcome, close: () => void): TemplateResult {
    return html`<p role="status">${about}</p>
      <div class="buttons"><a class="button primary" href=${address}>Open its clips</a><button class="button" type="button" @click=${close}>Stay here</button></div>`;
  }

  private choices(): TemplateResult | typeof nothing {
    if (!this.drafts) return this.refused ? nothing : html`<p class="quiet" role="status">Your studies are on their way.</p>`;
    const found = places(this.drafts);
    return html`<p class="quiet">${this.chosen.length === 1 ? "The clip is" : `The ${this.chosen.length} clips are`} added to those that are judged there.</p>
      ${found.length ? html`<h3>Your studies</h3><ul class="kinds wide">${found.map((place) => html`<li><button type="button" ?disabled=${this.busy} @click=${() => void this.add(place)}>
        <b>${place.title}</b><span>${place.about}</span></button></li>`)}</ul>` : nothing}
      <h3>A new study</h3>${this.newStudy()}`;
  }

  private newStudy(): TemplateResult {
    const kinds = [SIMPLEST, ...this.templates];
    const kind = kinds.find(({ id }) => id === this.template)!;
    const choose = (event: Event) => (this.template = (event.target as HTMLSelectElement).value);
    return html`<form @submit=${this.begin}>
      <label class="field"><span class="label">Begins with</span><select class="input" @change=${choose}>${kinds.map(
        ({ id, title }) => html`<option value=${id} ?selected=${id === this.template}>${title}</option>`)}</select></label>
      <label class="field"><span class="label">Title</span><input class="input" name="title" required maxlength="200" autocomplete="off"></label>
      <button class="button" type="submit" ?disabled=${this.busy}>Begin</button>
      <p class="hint">${kind.summary}${kind.id ? " Asked about your clips in the place of these." : nothing}</p></form>`;
  }
}
