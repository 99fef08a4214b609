// <new-study>: the button of the studies' list, and what a study can begin with.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import { refusal } from "./dialogs";
import type { Study } from "./model";

type Template = components["schemas"]["TemplateLine"];
type NewStudyRequest = components["schemas"]["NewStudy"];
interface Fault {
  line: number;
  column: number;
  where: string;
  message: string;
  mend: string;
}

@customElement("new-study")
export class NewStudy extends LitElement {
  @state() private templates: Template[] | null = null;
  @state() private refused: ApiError | null = null;
  @state() private busy = false;

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  private async open(): Promise<void> {
    this.refused = null;
    this.querySelector("dialog")?.showModal();
    await this.attempt(async () => {
      this.templates ??= (await api.get<{ templates: Template[] }>("/api/v1/study-templates")).templates;
    });
  }

  private async make(wanted: Partial<NewStudyRequest>): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    await this.attempt(async () => {
      const made = await api.post<Study>("/api/v1/studies", wanted);
      location.assign(`/research/studies/${made.slug}/edit`);
    });
    this.busy = false;
  }

  private async attempt(act: () => Promise<void>): Promise<void> {
    this.refused = null;
    try {
      await act();
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.refused = error;
    }
  }

  private readonly upload = async (event: Event): Promise<void> => {
    const input = event.target as HTMLInputElement;
    const file = input.files?.[0];
    input.value = "";
    if (file) await this.make({ file: { name: file.name, text: await file.text() } });
  };

  protected override render(): TemplateResult {
    const close = () => this.querySelector("dialog")?.close();
    const empty = (event: SubmitEvent) => {
      event.preventDefault();
      void this.make({ title: String(new FormData(event.target as HTMLFormElement).get("title")) });
    };
    return html`<button class="button primary" type="button" @click=${() => void this.open()}>${icon("plus")}New study</button>
      <dialog class="builder-dialog" aria-labelledby="new-study-title">
        <header><h2 class="figure-title" id="new-study-title">New study</h2><button class="button quiet icon-button" type="button" aria-label="Close" @click=${close}>${icon("close")}</button></header>
        ${this.refused ? html`${refusal(this.refused)}${this.faults(this.refused)}` : nothing}
        <h3>From a template</h3>
        ${this.templates ? html`<ul class="kinds wide">${this.templates.map(({ id, title, summary, minutes }) => html`<li><button type="button" ?disabled=${this.busy} @click=${() => void this.make({ template: id })}>
          <b>${title}</b><span>${summary}</span><span>About ${minutes} minutes</span></button></li>`)}</ul>` : html`<p class="quiet" role="status">The templates are on their way.</p>`}
        <h3>Empty</h3>
        <form class="new-empty" @submit=${empty}><label class="visually-hidden" for="new-title">Title</label>
          <input class="input" id="new-title" name="title" required maxlength="200" autocomplete="off" placeholder="Title of the study">
          <button class="button" type="submit" ?disabled=${this.busy}>Begin</button></form>
        <h3>From a file</h3>
        <p class="quiet small">A study file in YAML or JSON, such as one that was downloaded from another server.</p>
        <p class="new-file"><label class="button file-button">${icon("import")}Choose a file<input type="file" accept=".yaml,.yml,.json,application/json" @change=${this.upload}></label></p>
      </dialog>`;
  }

  /** What is wrong in a file, line by line. */
  private faults({ where }: ApiError): TemplateResult | typeof nothing {
    const faults = where?.["faults"] as Fault[] | undefined;
    if (!faults?.length) return nothing;
    return html`<ul class="file-faults">${faults.map((fault) => html`<li><b>Line ${fault.line}, column ${fault.column}</b>${fault.where ? ` · ${fault.where}` : nothing}
      <p>${fault.message} ${fault.mend}</p></li>`)}</ul>`;
  }
}
