// A field's value from the page's state, but not while somebody types: what is typed counts from `change` on, and
// whatever is drawn before (an answer of the server, a frame) must not take it away.
import { noChange } from "lit";
import { Directive, directive, type ElementPart } from "lit/directive.js";

type Box = HTMLInputElement | HTMLTextAreaElement;

class Typed extends Directive {
  private box: Box | null = null;
  private typing = false;

  override render(_value: string): typeof noChange {
    return noChange;
  }

  override update(part: ElementPart, [value]: [string]): typeof noChange {
    this.watch(part.element as Box);
    if (!this.typing && this.box!.value !== value) this.box!.value = value;
    return noChange;
  }

  private watch(box: Box): void {
    if (this.box === box) return;
    this.box = box;
    box.addEventListener("input", () => (this.typing = true));
    for (const end of ["change", "blur"]) box.addEventListener(end, () => (this.typing = false));
  }
}

/** `<input ${typed(value)} @change=${set}>`, in place of `.value`. */
export const typed = directive(Typed);
