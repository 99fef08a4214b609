// Keeps the live page up to date, piece by piece: what has not changed keeps its focus and its place.
import { api, ApiError } from "../api";
import { darkMode, draw, type Spec } from "../results/chart";

const EVERY = 5000;

type Charts = Record<string, { light: Spec; dark: Spec }>;

/** What two states of the page have in common stays; what differs is exchanged. */
export function exchange(place: ParentNode & Node, fresh: ParentNode): boolean {
  const now = pieces(place);
  const then = pieces(fresh);
  const same = now.size === then.size && [...then.keys()].every((name) => now.has(name));
  if (!same) {
    for (const piece of then.values()) stamp(piece);
    place.replaceChildren(...fresh.childNodes);
    return true;
  }
  let changed = false;
  for (const [name, piece] of then) {
    const old = now.get(name)!;
    if (stamp(old) === stamp(piece) || old.contains(document.activeElement)) continue;
    old.replaceWith(piece);
    changed = true;
  }
  return changed;
}

/** Of a piece, what the server sent: drawn charts are the page's own. */
const sent = new WeakMap<Element, string>();

function stamp(piece: Element): string {
  const known = sent.get(piece) ?? piece.innerHTML;
  sent.set(piece, known);
  return known;
}

function pieces(place: ParentNode): Map<string, HTMLElement> {
  const found = [...place.querySelectorAll<HTMLElement>("[data-live]")];
  return new Map(found.map((piece) => [piece.dataset.live!, piece]));
}

export class LiveNow {
  private charts: Charts;
  private readonly dark = darkMode();
  private asking = false;
  /** What each place shows, and the drawing under way: one after the other, none twice. */
  private readonly shown = new WeakMap<HTMLElement, string>();
  private drawing = Promise.resolve();

  constructor(
    private readonly place: HTMLElement,
    private readonly told: HTMLElement | null,
  ) {
    for (const piece of pieces(place).values()) stamp(piece);
    this.charts = chartsIn(place);
    this.dark.addEventListener("change", () => void this.drawAll());
    setInterval(() => void this.ask(), EVERY);
    document.addEventListener("visibilitychange", () => void this.ask());
    void this.drawAll();
  }

  /** Fetch the newest state; `always` even while a dialog is open or nobody looks. */
  async ask(always = false): Promise<void> {
    const { address } = this.place.dataset;
    if (!address || this.asking || (!always && (document.hidden || document.querySelector("dialog[open]")))) return;
    this.asking = true;
    try {
      this.take(await api.page(address));
      this.say("Updates by itself");
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.say(error.transient ? "No connection just now; the numbers are older" : error.message);
    } finally {
      this.asking = false;
    }
  }

  private take(fresh: DocumentFragment): void {
    this.charts = chartsIn(fresh);
    exchange(this.place, fresh);
    void this.drawAll();
  }

  private say(text: string): void {
    if (this.told && this.told.textContent !== text) this.told.textContent = text;
  }

  private drawAll(): Promise<void> {
    this.drawing = this.drawing.then(() => this.drawChanged());
    return this.drawing;
  }

  private async drawChanged(): Promise<void> {
    const mode = this.dark.matches ? "dark" : "light";
    for (const place of this.place.querySelectorAll<HTMLElement>("[data-chart]")) {
      const chart = this.charts[place.dataset.chart ?? ""]?.[mode];
      const wanted = JSON.stringify(chart);
      if (!chart || !place.isConnected || this.shown.get(place) === wanted) continue;
      this.shown.set(place, wanted);
      await draw(place, chart);
    }
  }
}

function chartsIn(place: ParentNode): Charts {
  return JSON.parse(place.querySelector("#live-charts")?.textContent ?? "{}") as Charts;
}
