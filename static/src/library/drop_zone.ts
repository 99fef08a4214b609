// Files dragged onto the page.
import type { LitElement, ReactiveController } from "lit";

export class DropZone implements ReactiveController {
  over = false;
  private depth = 0;

  constructor(
    private readonly host: LitElement,
    private readonly take: (files: File[]) => void,
  ) {
    host.addController(this);
  }

  hostConnected(): void {
    for (const name of EVENTS) window.addEventListener(name, this.handle);
  }

  hostDisconnected(): void {
    for (const name of EVENTS) window.removeEventListener(name, this.handle);
  }

  private readonly handle = (event: DragEvent): void => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault(); // or the browser would leave the page and show the file
    // Entering a child comes before leaving its parent, so only the count says whether one is out.
    if (event.type === "dragenter") this.depth++;
    if (event.type === "dragleave") this.depth--;
    if (event.type === "drop") {
      this.depth = 0;
      this.take([...event.dataTransfer.files]);
    }
    const over = this.depth > 0;
    if (over !== this.over) {
      this.over = over;
      this.host.requestUpdate();
    }
  };
}

const EVENTS = ["dragenter", "dragover", "dragleave", "drop"] as const;
