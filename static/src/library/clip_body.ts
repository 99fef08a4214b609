// <clip-body>: which clips share a clip's skeleton, and the way onto another one.
// Events, both bubbling: `kept` ClipDetail (it was waiting to be confirmed), `made` ClipDetail.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { asApiError } from "../studio/session";
import * as server from "./bodies";
import type { BodyDialog } from "./body_dialog";
import "./body_dialog";

@customElement("clip-body")
export class ClipBody extends LitElement {
  @property({ attribute: "clip-id" }) clipId = "";
  @state() private clip: server.ClipDetail | null = null;
  @state() private bodies: server.Body[] = [];
  @state() private problem: ApiError | null = null;
  @query("body-dialog") private dialog!: BodyDialog;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override willUpdate(changed: Map<PropertyKey, unknown>): void {
    if (changed.has("clipId")) void this.load();
  }

  private async load(): Promise<void> {
    try {
      [this.clip, this.bodies] = await Promise.all([server.clipOf(this.clipId), server.bodies()]);
      this.problem = null;
    } catch (error) {
      this.problem = asApiError(error);
      return;
    }
    const isAsked = location.hash === "#body" && location.pathname.endsWith(this.clipId);
    if (isAsked) await this.open(new URLSearchParams(location.search).get("onto"));
  }

  /** A clip that may still be read differently is kept first: what is made of it needs it as it is. */
  private async open(onto: string | null = null): Promise<void> {
    try {
      if (this.clip?.state === "to_confirm") {
        this.clip = await server.keep(this.clipId);
        this.bodies = await server.bodies();
        this.tell("kept", this.clip);
      }
      const asked = onto ? await server.clipOf(onto) : undefined;
      await this.updateComplete;
      this.querySelector<HTMLElement>("button")?.focus({ preventScroll: true }); // where the dialog returns to
      if (this.clip) this.dialog.show(this.clip, server.others(this.clip, this.bodies, asked));
    } catch (error) {
      this.problem = asApiError(error);
    }
  }

  private tell(name: string, clip: server.ClipDetail): void {
    this.dispatchEvent(new CustomEvent(name, { detail: clip, bubbles: true }));
  }

  protected override render(): TemplateResult | typeof nothing {
    const { clip, bodies, problem } = this;
    if (problem) return html`<section><h2>Body</h2>${problemNote(problem, () => void this.load())}</section>`;
    if (!clip?.figure_url) return nothing;
    const word = clip.state === "to_confirm" ? "Keep it and put it onto another body" : "Put it onto another body";
    return html`<section id="body"><h2>Body</h2>
      <p class="quiet">${server.sharedBy(clip, bodies)}</p>
      ${server.others(clip, bodies).length
        ? html`<p><button class="link-button" type="button" aria-haspopup="dialog" @click=${() => void this.open()}>${word}</button></p>`
        : nothing}
      <body-dialog @made=${({ detail }: CustomEvent<server.ClipDetail>) => this.tell("made", detail)}></body-dialog></section>`;
  }
}
