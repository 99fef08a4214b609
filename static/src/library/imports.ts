// Files on their way into the library: one after the other, each with its progress and its outcome.
import type { ReactiveController, ReactiveControllerHost } from "lit";
import { api, ApiError } from "../api";
import type { Imported } from "./model";

export interface ImportItem {
  id: number;
  file: File;
  options: Record<string, unknown>;
  state: "waiting" | "sending" | "reading" | "imported" | "failed";
  /** Part of the bytes that has gone out, 0 to 1. */
  share: number;
  result?: Imported;
  error?: ApiError;
}

type Upload = typeof api.upload;

export class ImportQueue implements ReactiveController {
  items: ImportItem[] = [];
  private running = false;
  private lastId = 0;

  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly onSettled: (item: ImportItem) => void,
    private readonly upload: Upload = api.upload,
  ) {
    host.addController(this);
  }

  hostConnected(): void {}

  /** Take files in; true once all have settled. */
  async add(files: Iterable<File>): Promise<void> {
    for (const file of files) {
      this.items.push({ id: ++this.lastId, file, options: {}, state: "waiting", share: 0 });
    }
    await this.run();
  }

  /** Try a refused file again, with what the person decided about it. */
  async retry(item: ImportItem, options: Record<string, unknown>): Promise<void> {
    delete item.error;
    Object.assign(item, { options: { ...item.options, ...options }, state: "waiting", share: 0 });
    await this.run();
  }

  /** An import of an earlier visit, which is still to be confirmed. */
  found(result: Imported): ImportItem {
    const file = new File([], result.clip.name);
    const item: ImportItem = { id: ++this.lastId, file, options: {}, state: "imported", share: 1, result };
    this.items.push(item);
    return item;
  }

  remove(item: ImportItem): void {
    this.items = this.items.filter((other) => other !== item);
    this.host.requestUpdate();
  }

  get busy(): ImportItem[] {
    return this.items.filter(({ state }) => state !== "imported" && state !== "failed");
  }

  private async run(): Promise<void> {
    this.host.requestUpdate();
    if (this.running) return;
    this.running = true;
    for (let next; (next = this.items.find(({ state }) => state === "waiting")); ) {
      await this.send(next);
    }
    this.running = false;
  }

  private async send(item: ImportItem): Promise<void> {
    const form = new FormData();
    form.set("file", item.file, item.file.name);
    if (Object.keys(item.options).length) form.set("options", JSON.stringify(item.options));
    this.set(item, { state: "sending" });
    try {
      const result = await this.upload<Imported>("/api/v1/imports", form, (share) =>
        this.set(item, { share, state: share < 1 ? "sending" : "reading" }),
      );
      this.set(item, { state: "imported", result });
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.set(item, { state: "failed", error });
    }
    this.onSettled(item);
  }

  private set(item: ImportItem, change: Partial<ImportItem>): void {
    Object.assign(item, change);
    this.host.requestUpdate();
  }
}
