// <graph-list>: all motion graphs, and the form for a new one.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import { find, framesPerSecond, seconds, type Clip } from "../library/model";
import { clipWords, type GraphDetail, type GraphView } from "./model";
import { problemNote } from "./problem";

const MOST = 12;

@customElement("graph-list")
export class GraphList extends LitElement {
  @state() private graphs: GraphView[] | undefined;
  @state() private clips: Clip[] | undefined;
  @state() private problem: ApiError | null = null;
  @state() private refused: ApiError | null = null;
  @state() private chosen: readonly string[] = [];
  @state() private query = "";
  @state() private making = false;

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
      this.graphs = (await api.get<{ graphs: GraphView[] }>("/api/v1/graphs")).graphs;
      this.problem = null;
    } catch (error) {
      this.problem = asApiError(error);
    }
  }

  private async open(): Promise<void> {
    this.chosen = [];
    this.refused = null;
    this.querySelector("dialog")?.showModal();
    try {
      this.clips ??= (await api.get<components["schemas"]["ClipList"]>("/api/v1/clips")).clips;
    } catch (error) {
      this.refused = asApiError(error);
    }
  }

  private async make(name: string): Promise<void> {
    this.making = true;
    try {
      const clips = Object.fromEntries(this.chosen.map((id) => [this.nameFor(id), id]));
      const made = await api.post<GraphDetail>("/api/v1/graphs", { name, clips });
      location.assign(`/graphs/${made.id}`);
    } catch (error) {
      this.refused = asApiError(error);
      this.making = false;
    }
  }

  /** Clips are told apart by name within a graph; of two with one name, the later gets its number. */
  private nameFor(id: string): string {
    const clip = (one: string) => this.clips!.find((other) => other.id === one)!;
    const before = this.chosen.slice(0, this.chosen.indexOf(id)).filter((one) => clip(one).name === clip(id).name);
    return before.length ? `${clip(id).name} ${before.length + 1}` : clip(id).name;
  }

  protected override render(): TemplateResult {
    return html`<header class="page-header"><h1>Graphs</h1>
        <button class="button primary" type="button" @click=${() => void this.open()}>New graph</button></header>
      <p class="lede">A motion graph knows where clips look and move alike, so that one can go over into another. Walk through it with your own hands.</p>
      ${this.problem ? problemNote(this.problem, () => void this.load()) : nothing}
      ${this.graphs ? this.list(this.graphs) : this.problem ? nothing : html`<p class="quiet" role="status">The graphs are on their way.</p>`}
      ${this.dialog()}`;
  }

  private list(graphs: GraphView[]): TemplateResult {
    if (!graphs.length) {
      return html`<div class="empty"><h2 class="figure-title">No graphs yet</h2>
        <p>Choose clips of one body that walk, stand or turn: what can follow what is found by itself.</p></div>`;
    }
    return html`<ul class="rows graph-rows">${graphs.map(
      (graph) => html`<li><a href=${graph.page_url}>${graph.name}</a>
        ${graph.kind === "sample" ? html`<span class="tag">comes with the server</span>` : nothing}
        <p class="tiny">${graph.clips.map(clipWords).join(", ")}</p></li>`,
    )}</ul>`;
  }

  private dialog(): TemplateResult {
    const submit = (event: SubmitEvent) => {
      event.preventDefault();
      void this.make(String(new FormData(event.target as HTMLFormElement).get("name")));
    };
    const close = () => this.querySelector("dialog")?.close();
    return html`<dialog class="graph-dialog" aria-labelledby="new-graph">
      <form @submit=${submit}>
        <header><h2 id="new-graph" class="figure-title">New graph</h2>
          <button class="button quiet" type="button" @click=${close}>${icon("close")}<span>Close</span></button></header>
        <label class="field"><span class="label">Name</span><input class="input" name="name" required maxlength="200" autocomplete="off"></label>
        <label class="field"><span class="label">Clips</span>
          <input class="input" type="search" placeholder="Name, style or tag" .value=${this.query}
            @input=${(event: Event) => (this.query = (event.target as HTMLInputElement).value)}></label>
        ${this.choices()}
        ${this.refused ? problemNote(this.refused) : nothing}
        <footer><p class="tiny" role="status">${this.chosen.length} of up to ${MOST} chosen. They need one skeleton and one frame rate.</p>
          <button class="button primary" type="submit" ?disabled=${!this.chosen.length || this.making}>${this.making ? "Comparing clips" : "Make the graph"}</button></footer>
      </form></dialog>`;
  }

  private choices(): TemplateResult {
    if (!this.clips) return html`<p class="quiet" role="status">The clips are on their way.</p>`;
    const found = find(this.clips, "", this.query);
    const toggle = (id: string) => {
      this.chosen = this.chosen.includes(id) ? this.chosen.filter((one) => one !== id) : [...this.chosen, id];
    };
    return html`<div class="graph-choices" role="group" aria-label="Clips" tabindex="0">${found.map((clip) => {
      const on = this.chosen.includes(clip.id);
      return html`<label class="choice"><input type="checkbox" .checked=${on} ?disabled=${!on && this.chosen.length >= MOST} @change=${() => toggle(clip.id)}>
        <span>${clip.name}<span class="tiny"> ${[clip.tags["body"], seconds(clip.duration), framesPerSecond(clip.frame_time)].filter(Boolean).join(" · ")}</span></span></label>`;
    })}${found.length ? nothing : html`<p class="quiet">Nothing here is called or tagged “${this.query}”.</p>`}</div>`;
  }
}

function asApiError(error: unknown): ApiError {
  if (error instanceof ApiError) return error;
  throw error;
}
