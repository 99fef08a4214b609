// <measured-figure>: a clip's figure at its best frame beside a 1.7 m rule.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import "../viewer";
import type { MotionViewer } from "../viewer";
import type { Clip } from "./model";
import { ruler, TALLEST } from "./ruler";

@customElement("measured-figure")
export class MeasuredFigure extends LitElement {
  @property({ attribute: false }) clip!: Clip;
  /** Where 0 m and 1.7 m lie, px from the top; unknown until the figure stands. */
  @state() private marks: { floor: number; top: number } | undefined;
  @query("motion-viewer") private viewer!: MotionViewer;
  private readonly resized = new ResizeObserver(() => this.measure());

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.resized.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resized.disconnect();
  }

  private readonly measure = (): void => {
    const floor = this.viewer?.project(0, 0, 0);
    const top = this.viewer?.project(0, TALLEST, 0);
    if (floor && top) this.marks = { floor: floor.y, top: top.y };
  };

  protected override render(): TemplateResult {
    const { clip, marks } = this;
    return html`<motion-viewer src=${clip.glb_url} figure=${clip.figure_url ?? nothing} poster-time=${clip.poster_time}
        static theme="auto" controls="none" @ready=${this.measure}></motion-viewer>
      ${marks ? ruler(this.clientHeight, marks.floor, marks.top) : nothing}`;
  }
}
