// What a person steers by: keys that are held, and buttons that stay pressed.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import type { Direction } from "./model";

const KEYS: Record<string, Direction> = {
  ArrowUp: "ahead", KeyW: "ahead",
  ArrowLeft: "left", KeyA: "left",
  ArrowRight: "right", KeyD: "right",
  ArrowDown: "stop", KeyS: "stop",
};

/** The buttons in the order in which they are reached; their places are a matter of style. */
const BUTTONS: [Direction, word: string, keys: string][] = [
  ["left", "Left", "ArrowLeft A"],
  ["ahead", "Walk", "ArrowUp W"],
  ["right", "Right", "ArrowRight D"],
  ["stop", "Stop", "ArrowDown S"],
];

/**
 * Follows the keyboard: a direction holds while its key does; then the button's counts again.
 *
 * Turning goes before walking, so that both may be held.
 */
export class HeldKeys {
  private readonly held = new Set<Direction>();

  constructor(private readonly changed: (direction: Direction | null) => void) {}

  connect(): void {
    window.addEventListener("keydown", this.down, true);
    window.addEventListener("keyup", this.up, true);
    window.addEventListener("blur", this.release);
  }

  disconnect(): void {
    window.removeEventListener("keydown", this.down, true);
    window.removeEventListener("keyup", this.up, true);
    window.removeEventListener("blur", this.release);
    this.held.clear();
  }

  private readonly down = (event: KeyboardEvent): void => {
    const direction = KEYS[event.code];
    if (!direction || event.altKey || event.ctrlKey || event.metaKey || isField(event)) return;
    event.preventDefault();
    event.stopPropagation(); // the viewer has uses of its own for arrows
    if (event.repeat || this.held.has(direction)) return;
    this.held.add(direction);
    this.tell();
  };

  private readonly up = (event: KeyboardEvent): void => {
    const direction = KEYS[event.code];
    if (direction && this.held.delete(direction)) this.tell();
  };

  private readonly release = (): void => {
    if (!this.held.size) return;
    this.held.clear();
    this.tell();
  };

  private tell(): void {
    const order: Direction[] = ["stop", "left", "right", "ahead"];
    this.changed(order.find((direction) => this.held.has(direction)) ?? null);
  }
}

/** Whether the key means something where it was pressed: letters in text, arrows in any field. */
function isField(event: KeyboardEvent): boolean {
  const target = event.composedPath()[0] as HTMLElement;
  if (target instanceof HTMLInputElement && target.type === "range") return event.key.startsWith("Arrow");
  return ["INPUT", "SELECT", "TEXTAREA"].includes(target.tagName);
}

/** The pad: one button a direction that the graph knows. */
export function pad(
  known: Partial<Record<Direction, string>>,
  active: Direction | null,
  choose: (direction: Direction) => void,
): TemplateResult {
  return html`<div class="steering-pad" role="group" aria-label="Steer">
    ${BUTTONS.map(([direction, word, keys]) =>
      known[direction]
        ? html`<button type="button" class="steer steer-${direction}" aria-pressed=${active === direction}
            aria-keyshortcuts=${keys} @click=${() => choose(direction)}>${icon("arrow")}<span>${word}</span></button>`
        : nothing,
    )}
  </div>`;
}
