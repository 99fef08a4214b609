// What the studio and an authoring space have in common: attempts that may fail, gestures as one entry of the history,
// the keys of undo, and how long a change takes to the screen.
import { LitElement } from "lit";
import { query, state } from "lit/decorators.js";
import type { ApiError } from "../api";
import type { MotionViewer } from "../viewer";
import type { History } from "./history";
import { asApiError } from "./staging";
import type { Drawer } from "./top_bar";

/** What is worked at. */
export interface Work {
  askedAt: number;
  readonly history: Pick<History<unknown>, "hold" | "release">;
  undo(): void;
  redo(): void;
  retry(): void;
}

const FIGURE = 0;
const TYPED_IN = "input:not([type=range]), textarea, select";

export abstract class Workbench<W extends Work> extends LitElement {
  @state() protected session: W | null = null;
  @state() protected failure: ApiError | null = null;
  @state() protected drawer: Drawer | null = null;
  @state() protected busy = false;
  /** What was copied, in words. */
  @state() protected said = "";
  /** The viewer of what is on the stage, once it is ready. */
  @state() protected stageViewer: MotionViewer | null = null;
  @query("motion-viewer") protected viewer!: MotionViewer | null;
  private shownAt = 0;
  private readonly online = () => {
    if (this.failure?.transient) this.reconnected();
    this.session?.retry();
  };
  private readonly keyDown = (event: KeyboardEvent) => this.onKey(event);
  private readonly onPointer = (event: Event) => this.note(event);
  /** For the panels' events, before their controls see them. */
  protected readonly noted = { handleEvent: this.onPointer, capture: true };

  /** The server is there again after something failed. */
  protected abstract reconnected(): void;
  /** A key without Ctrl, while nobody types. */
  protected abstract press(key: string, event: KeyboardEvent): void;

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("online", this.online);
    addEventListener("keydown", this.keyDown);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("online", this.online);
    removeEventListener("keydown", this.keyDown);
  }

  protected async attempt<T>(act: () => Promise<T> | T): Promise<T | undefined> {
    this.busy = true;
    try {
      this.failure = null;
      return await act();
    } catch (error) {
      this.failure = asApiError(error);
      return undefined;
    } finally {
      this.busy = false;
    }
  }

  /** Give the figure another motion. */
  protected put(glb: ArrayBuffer, askedAt: number): void {
    this.viewer?.setMotion(FIGURE, glb);
    this.shownAt = askedAt;
    if (askedAt) performance.measure("manner:applied", { start: askedAt });
  }

  /** The motion of the last change is on the screen. */
  protected onMotion(): void {
    if (this.shownAt) performance.measure("manner:change", { start: this.shownAt });
    this.shownAt = 0;
  }

  /** A pointer's gesture on any control is one entry of the history; when it happened is measured. */
  protected note(event: Event): void {
    if (!this.session) return;
    this.session.askedAt = event.timeStamp;
    if (event.type !== "pointerdown") return;
    const release = () => this.session?.history.release();
    this.session.history.hold();
    addEventListener("pointerup", release, { once: true });
    addEventListener("pointercancel", release, { once: true });
  }

  protected toggle(drawer: Drawer): void {
    this.drawer = this.drawer === drawer ? null : drawer;
  }

  protected closeDrawer(): void {
    this.querySelector<HTMLElement>(".drawer-acts [aria-expanded=true]")?.focus();
    this.drawer = null;
  }

  protected showExports(): void {
    this.drawer = "results";
    void this.updateComplete.then(() => this.querySelector<HTMLElement>("#export")?.focus());
  }

  protected take(clip: string, suffix: string): void {
    const link = document.createElement("a");
    link.href = `/api/v1/clips/${clip}.${suffix}`;
    link.download = "";
    link.click();
  }

  private onKey(event: KeyboardEvent): void {
    const typing = (event.composedPath()[0] as HTMLElement).matches?.(TYPED_IN);
    if (!this.session || typing || this.querySelector("dialog[open]")) return;
    const key = event.key.toLowerCase();
    if (!event.ctrlKey && !event.metaKey) return this.press(key, event);
    if (key !== "z" && key !== "y") return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) this.session.redo();
    else this.session.undo();
  }
}
