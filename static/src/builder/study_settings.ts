// <study-settings>: whether a study is open, who may come from where, and who works on it.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import { icon } from "../icons";
import { refusal } from "./dialogs";
import { form, type Editing } from "./form";
import { asCsv, linkRow, mturkLink, prolificLink, sonaLink } from "./links";
import { at, put, type Json, type Path, type Problem, type Study } from "./model";
import { MTURK, PROLIFIC, RULES, SONA, WHO } from "./running_fields";
import "./members";

const STATES = [["open", "Open"], ["paused", "Paused"], ["closed", "Closed"]] as const;

@customElement("study-settings")
export class StudySettings extends LitElement {
  @property() home = "";
  @state() private study!: Study;
  @state() private running!: Json;
  @state() private problems: Problem[] = [];
  @state() private refused: ApiError | null = null;
  @state() private said = "";

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.open(JSON.parse(document.getElementById("study")!.textContent!) as Study);
    addEventListener("beforeunload", (event) => this.isChanged && event.preventDefault());
  }

  private open(study: Study): void {
    this.study = study;
    this.running = study.running as Json;
    this.problems = [];
  }

  private get isChanged(): boolean {
    return this.running !== (this.study.running as Json);
  }

  private get address(): string {
    return `/api/v1/studies/${this.study.slug}`;
  }

  private async attempt(said: string, act: () => Promise<void>): Promise<void> {
    this.refused = null;
    this.problems = [];
    this.said = "";
    try {
      await act();
      this.said = said;
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.problems = problemsOf(error);
      this.refused = error;
    }
  }

  private readonly save = (event: Event): void => {
    event.preventDefault();
    void this.attempt("Saved", async () => this.open(await api.put<Study>(`${this.address}/running`, this.running)));
  };

  private setState(state: string): void {
    void this.attempt("Saved", async () => {
      const filled = this.isChanged ? this.running : null;
      this.open(await api.post<Study>(`${this.address}/state`, { state }));
      if (filled) this.running = filled; // what is filled in below is not lost
    });
  }

  private readonly invite = (event: SubmitEvent): void => {
    event.preventDefault();
    const given = new FormData(event.target as HTMLFormElement);
    const labels = String(given.get("labels")).split(/[\n,;]/).map((label) => label.trim()).filter(Boolean);
    void this.attempt("The links are in your downloads", async () => {
      const wanted = labels.length ? { labels } : { count: Number(given.get("count")) };
      const { invitations } = await api.post<{ invitations: { label: string; url: string }[] }>(`${this.address}/invitations`, wanted);
      download(`${this.study.slug}-links.csv`, asCsv(invitations));
    });
  };

  private async duplicate(): Promise<void> {
    await this.attempt("", async () => {
      const made = await api.post<Study>(`${this.address}/duplicate`);
      location.assign(`/research/studies/${made.slug}/edit`);
    });
  }

  private async deleteStudy(): Promise<void> {
    await this.attempt("", async () => {
      await api.delete(this.address);
      location.assign("/research");
    });
  }

  protected override render(): TemplateResult {
    const { study } = this;
    const editable = study.role !== "viewer";
    return html`<p class="tiny settings-said" role="status">${editable ? this.said : "You may look, not change"}</p>
      ${this.refused && !this.problems.length ? refusal(this.refused) : nothing}
      ${this.stateSection(editable)}
      <form class="settings" @submit=${this.save} novalidate><fieldset class="settings-form" ?disabled=${!editable}>${this.sections()}</fieldset>
        ${editable && (this.isChanged || this.problems.length) ? html`<div class="settings-save"><button class="button primary" type="submit" ?disabled=${!this.isChanged}>Save</button>
          ${this.problems.length ? html`<p class="fault" role="alert">${icon("warning")}<span>Not saved. Mend the marked fields.</span></p>` : html`<p class="tiny">Not saved yet.</p>`}</div>` : nothing}</form>
      ${editable ? this.invitations() : nothing}
      <section class="section" aria-labelledby="members-title"><header><h2 id="members-title">People</h2></header><study-members slug=${study.slug}></study-members></section>
      ${this.ending(editable)}`;
  }

  private stateSection(editable: boolean): TemplateResult {
    const { state, slug } = this.study;
    if (state === "draft") {
      return html`<div class="note">${icon("info")}<p>This study was not published yet. <a href=${`/research/studies/${slug}/edit`}>Publish it in the builder</a>, and it opens.</p></div>`;
    }
    return html`<section class="study-open"><div class="segments" role="group" aria-label="State of the study">${STATES.map(([one, word]) => html`<button type="button" aria-pressed=${state === one} ?disabled=${!editable} @click=${() => this.setState(one)}>${word}</button>`)}</div>
      <p class="quiet">${{ open: "New participants can begin.", paused: "Nobody new can begin for now. Who has begun can go on.", closed: "Nobody new can begin. Who has begun can go on." }[state]}</p></section>`;
  }

  private sections(): TemplateResult {
    const editing = this.editing;
    const study = `${this.home}/studies/${this.study.slug}`;
    const has = (name: string) => Boolean(at(this.running, [name]));
    return html`<section><h2>Who may come, and when</h2><div class="settings-form">${linkRow({ label: "The study’s address", address: study })}${form(WHO, [], editing)}</div></section>
      <section><h2>Recruiting services</h2><p class="quiet">Participants of these bring their own identity, and one of them gets one session.</p><div class="settings-form">
        ${form(PROLIFIC, [], editing)}${has("prolific") ? linkRow(prolificLink(study)) : nothing}
        ${form(SONA, [], editing)}${has("sona") ? linkRow(sonaLink(study)) : nothing}
        ${form(MTURK, [], editing)}${has("mturk") ? linkRow(mturkLink(study)) : nothing}</div></section>
      <section><h2>Rules</h2><div class="settings-form">${form(RULES, [], editing)}</div></section>`;
  }

  private get editing(): Editing {
    return {
      study: this.running, language: "en", problems: this.problems, clips: [], allClips: false, editable: true, look: () => {},
      set: (path: Path, value: Json | undefined) => (this.running = put(this.running, path, value)),
      pick: () => {}, showAllClips: () => {},
    };
  }

  private invitations(): TemplateResult {
    return html`<section class="section" aria-labelledby="links-title"><header><h2 id="links-title">Personal links</h2><p>One link for each participant. They work while the study is open, also where the address alone lets nobody in. Coming back on the same link leads to the same place.</p></header>
      <form class="invite" @submit=${this.invite}><label class="field"><span class="label">How many</span><input class="input short" type="number" name="count" min="1" max="1000" value="20"></label>
        <label class="field grow"><span class="label">Or your own names for them, one a line</span><textarea class="input" name="labels" rows="2" spellcheck="false"></textarea></label>
        <button class="button" type="submit">${icon("download")}Make links</button></form></section>`;
  }

  private ending(editable: boolean): TemplateResult {
    const { study } = this;
    const files = (format: string, word: string) => html`<a class="button quiet" href=${`${this.address}/file?format=${format}`} download>${icon("download")}${word}</a>`;
    return html`<section class="section" aria-labelledby="file-title"><header><h2 id="file-title">The study as a file</h2></header>
      <div class="buttons">${files("yaml", "YAML")}${files("json", "JSON")}<button class="button quiet" type="button" @click=${() => void this.duplicate()}>${icon("copy")}Duplicate</button></div>
      ${editable && study.state === "draft" && study.role === "owner" ? html`<details class="revoke"><summary class="button quiet">Delete this study</summary><form @submit=${(event: Event) => (event.preventDefault(), void this.deleteStudy())}><p>Nothing of it is kept. This cannot be undone.</p><button class="button danger" type="submit">Delete “${study.title}”</button></form></details>` : nothing}</section>`;
  }
}

/** The fields that the server's refusal names. */
function problemsOf({ where }: ApiError): Problem[] {
  const fields = (where?.["fields"] ?? []) as { field: string; problem: string }[];
  return fields.map(({ field, problem }) => {
    const [name, rest] = problem.replace("Value error, ", "").split(/: (.*)/s);
    const rule = !field && rest ? { where: [name!], message: rest } : { where: field.split("."), message: problem };
    const pattern = field.endsWith("credit_url") ? "Write an address that begins with https://" : "Use letters, digits, hyphens and underscores.";
    return { ...rule, message: rule.message.replace(/^String should match pattern.*/, pattern), mend: null };
  });
}

function download(name: string, text: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
