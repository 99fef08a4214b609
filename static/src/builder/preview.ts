// <study-preview>: the participant's page in the size of a phone or a desktop, made small.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { icon } from "../icons";

const SIZES = { phone: [390, 760], desktop: [1280, 800] } as const;

@customElement("study-preview")
export class StudyPreview extends LitElement {
  @property() slug = "";
  /** The part that it begins with. */
  @property() at = "";
  @property() language = "";
  /** Another number loads it anew. */
  @property({ type: Number }) stored = 0;
  /** There are stimuli that only publishing will make. */
  @property({ type: Boolean }) made = false;
  /** The draft cannot be shown; what was shown last stays. */
  @property({ type: Boolean }) waiting = false;
  /** What is shown stays until the newest draft is stored. */
  @property({ type: Boolean }) held = false;
  @state() private size: keyof typeof SIZES = "phone";
  /** A page in a frame would take the focus from the field that is being filled in. */
  @state() private inUse = false;
  private shown = "";
  private readonly watch = new ResizeObserver(() => this.fit());

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.watch.disconnect();
  }

  protected override firstUpdated(): void {
    this.watch.observe(this.querySelector(".preview-room")!);
  }

  protected override willUpdate(changed: Map<PropertyKey, unknown>): void {
    if (["at", "language", "stored"].some((name) => changed.has(name))) this.inUse = false;
  }

  protected override updated(): void {
    this.fit();
  }

  protected override render(): TemplateResult {
    if (!this.waiting && !this.held) this.shown = this.address;
    const choose = (size: keyof typeof SIZES) => html`<button type="button" aria-pressed=${this.size === size} @click=${() => (this.size = size)}>${icon(size)}${size === "phone" ? "Phone" : "Desktop"}</button>`;
    return html`<div class="preview-bar"><div class="segments" role="group" aria-label="Size of the preview">${choose("phone")}${choose("desktop")}</div>
        <button class="button quiet" type="button" ?disabled=${!this.shown} @click=${this.use}>Try it</button></div>
      <div class="preview-room" @pointerenter=${() => (this.inUse = true)}>${this.shown
        ? html`<iframe class=${this.size} title="Preview" src=${this.shown} ?inert=${!this.inUse}></iframe>`
        : html`<p class="preview-empty">The preview comes once there is a part and nothing is missing.</p>`}</div>
      <p class="tiny preview-note" role="status">${this.waiting && this.shown ? html`The preview shows the study as it was before something went missing.` : this.at ? nothing : html`The preview begins with the first part.`}
        ${this.made ? "Motions that publishing will make move here as what they are made from. " : nothing}Participants always see the light look. Preview answers are never counted.</p>`;
  }

  private get address(): string {
    const query = new URLSearchParams({ part: this.at, ...(this.language ? { language: this.language } : {}), of: String(this.stored) });
    return `/research/studies/${this.slug}/preview?${query}`;
  }

  private readonly use = async (): Promise<void> => {
    this.inUse = true;
    await this.updateComplete;
    this.querySelector("iframe")?.focus();
  };

  private fit(): void {
    const room = this.querySelector<HTMLElement>(".preview-room");
    if (!room?.clientWidth) return;
    const [width, height] = SIZES[this.size];
    const scale = Math.min(1, room.clientWidth / width, Math.max(320, room.clientHeight) / height);
    room.style.setProperty("--scale", String(scale));
    room.style.setProperty("--width", `${width}px`);
    room.style.setProperty("--height", `${height}px`);
  }
}
