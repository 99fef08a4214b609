// <space-maker>: the analysis becomes an authoring space, frozen under a name.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, type ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { icon } from "../icons";
import { spaces, type ListedSpace } from "../space/server";
import { counted, type Impressions, type SpaceLine } from "./model";
import { attempt } from "./problem";

const MOST_TOLD = 3;

@customElement("space-maker")
export class SpaceMaker extends LitElement {
  @property({ attribute: false }) data!: Impressions;
  /** Sends what is not saved yet: the space is made of what is saved. */
  @property({ attribute: false }) settle: () => Promise<void> = () => Promise.resolve();
  @state() private made: SpaceLine | null = null;
  /** What was made of this study before, the newest first. */
  @state() private earlier: readonly ListedSpace[] = [];
  @state() private problem: ApiError | null = null;
  @state() private busy = false;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void this.look();
  }

  private async look(): Promise<void> {
    const { slug, kind } = this.data;
    await attempt(async () => {
      this.earlier = (await spaces()).filter(({ study, simulated }) => study === slug && simulated === (kind === "simulated"));
    }, () => {}); // the list under Spaces has them all the same
  }

  private async make(event: SubmitEvent): Promise<void> {
    event.preventDefault();
    const name = new FormData(event.target as HTMLFormElement).get("name")?.toString().trim();
    const { slug, part, kind } = this.data;
    if (!name || this.busy) return;
    this.busy = true;
    await attempt(async () => {
      await this.settle();
      this.made = await api.post<SpaceLine>(`/api/v1/studies/${slug}/impressions/${part.id}/space?kind=${kind}`, { name });
    }, (problem) => (this.problem = problem));
    this.busy = false;
    // The way on stands below the button, perhaps out of sight.
    await this.updateComplete;
    if (this.made && !this.problem) this.querySelector<HTMLElement>(".note-good a")?.focus();
  }

  protected override render(): TemplateResult {
    const { clusters, clips, kind, may_edit, title } = this.data;
    return html`<header><h2 class="figure-title" id="space">From these adjectives to sliders</h2>
        <p>An authoring space holds the ${clips.length} clips and where each lies on ${counted(clusters.length, "slider")}, one a cluster, and on every kept pair. It is frozen: later answers do not change it.</p></header>
      ${kind === "simulated" ? html`<p class="small quiet">This space will say that its numbers come from simulated participants.</p>` : nothing}
      ${may_edit
        ? html`<form class="space-form" @submit=${(event: SubmitEvent) => void this.make(event)}>
          <label class="field"><span>Name</span><input class="input" name="name" required maxlength="200" .defaultValue=${title}></label>
          <button class="button primary" ?disabled=${this.busy}>Make authoring space</button></form>`
        : html`<p class="quiet">Editors and owners of the study can make one.</p>`}
      ${this.made ? nothing : this.madeBefore()}
      ${this.problem ? problemNote(this.problem) : nothing}
      ${this.made ? html`<p class="note note-good" role="status">${icon("check")}<span><b>${this.made.name}</b>${this.made.number > 1 ? `, version ${this.made.number},` : ""} is made.
        <a href="/studio/spaces/${this.made.id}">Open it in the studio</a></span></p>` : nothing}`;
  }

  private madeBefore(): TemplateResult | typeof nothing {
    if (!this.earlier.length) return nothing;
    const links = this.earlier.slice(0, MOST_TOLD).map(({ id, name, number }, index) =>
      html`${index ? ", " : ""}<a href="/studio/spaces/${id}">${name}, version ${number}</a>`);
    const more = this.earlier.length - links.length;
    return html`<p class="small quiet">Made of this study before: ${links}${more > 0 ? html` and <a href="/studio/spaces">${more} more</a>` : nothing}.</p>`;
  }
}
