// Keeps the draft on the server: a moment after the last change, one request at a time, again after a failure.
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { debounced, Latest } from "../studio/latest";
import type { Json } from "./model";

export type Saved = components["schemas"]["SavedDraft"];

const AFTER = 700;
const AGAIN_AFTER = 3000;
const CHANGED_ELSEWHERE = 409;

export class Saving {
  state: "saved" | "waiting" | "failed" = "saved";
  failure: ApiError | null = null;
  private newest: Json;
  private stored: Json;
  private readonly sends = new Latest<Json>((draft) => this.send(draft));
  private readonly soon = debounced<Json>((draft) => this.sends.ask(draft), AFTER);
  private waiting: (() => void)[] = [];

  /**
   * @param seen `saved_at` of the draft that is being edited.
   * @param changed hears of every new state; of a draft that was stored, what is wrong with it.
   */
  constructor(
    private readonly slug: string,
    draft: Json,
    private seen: string | null,
    private readonly changed: (saved?: Saved) => void,
  ) {
    this.newest = this.stored = draft;
  }

  keep(draft: Json): void {
    this.newest = draft;
    if (this.failure?.status === CHANGED_ELSEWHERE) return; // the other draft is not written over
    this.state = "waiting";
    this.soon(draft);
    this.changed();
  }

  /** Once everything is stored; rejects where it cannot be. */
  async now(): Promise<void> {
    if (this.newest === this.stored) return;
    this.sends.ask(this.newest);
    await new Promise<void>((done) => this.waiting.push(done));
    if (this.failure) throw this.failure;
  }

  get isStored(): boolean {
    return this.newest === this.stored;
  }

  private async send(draft: Json): Promise<void> {
    if (draft === this.stored) return this.settle();
    try {
      const address = `/api/v1/studies/${this.slug}/draft`;
      const saved = await api.put<Saved>(address, draft, { query: { seen: this.seen } });
      this.seen = saved.saved_at;
      this.stored = draft;
      this.failure = null;
      this.state = draft === this.newest ? "saved" : "waiting";
      this.changed(saved);
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.failure = error;
      this.state = "failed";
      if (error.transient) setTimeout(() => this.sends.ask(this.newest), AGAIN_AFTER);
      this.changed();
    }
    this.settle();
  }

  private settle(): void {
    for (const done of this.waiting.splice(0)) done();
  }
}
