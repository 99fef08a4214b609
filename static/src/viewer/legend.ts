/** Which figure is which: a word in its colour, above the figure or in a row for ghosts. */
import { make } from "./dom";
import type { FigureRole, GhostKind } from "./looks";

/** Who is on view, and how. */
export interface Billing {
  isSeen(index: number): boolean;
  ghostOf(index: number): GhostKind | null;
}

export class Legend {
  readonly element = make("ul", { class: "legend", hidden: true });

  show(figures: { label: string; role: FigureRole }[], billing: Billing): void {
    const entries = figures.map((one, index) => ({ ...one, ghost: billing.ghostOf(index) }));
    const labelled = entries.filter(({ label }, index) => label && billing.isSeen(index));
    this.element.hidden = labelled.length === 0;
    this.element.classList.toggle("row", labelled.some(({ ghost }) => ghost));
    this.element.replaceChildren(
      ...labelled.map(({ label, role, ghost }) =>
        make("li", { class: `${role}${ghost ? " ghost" : ""}` }, label),
      ),
    );
  }

  /** Puts each label over its figure: pixels from the left of the stage. */
  place(columns: number[]): void {
    const above = columns.length === this.element.children.length && columns.length > 1;
    this.element.classList.toggle("above", above);
    this.element.classList.toggle("row", !above);
    [...this.element.children].forEach((item, index) => {
      (item as HTMLElement).style.left = above ? `${columns[index]!.toFixed(0)}px` : "";
    });
  }
}
