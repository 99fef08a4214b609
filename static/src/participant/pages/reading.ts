// Pages that only say something: instructions, a break, the debriefing. Their answer is empty.

import { html } from "lit";
import type { CellParts, Kind } from "../../trials/kind";
import { empty } from "../../trials/kind";
import { paragraphs } from "./text";

/** What a study sets. */
export interface Parameters {
  heading: string;
  text: string;
}

export const reading: Kind<Parameters> = {
  layout: "page",
  data: {},
  blank: empty,
  isComplete: () => true,
  remaining: () => null,
  simulate: empty,
  panel: ({ task }) => html`<h1>${task.heading}</h1><div class="prose">${paragraphs(task.text)}</div>`,
  cell: ({ step }, place): CellParts => {
    const caption = step.figures[place]?.caption;
    return { head: "", ...(caption ? { foot: html`<p class="caption">${caption}</p>` } : {}) };
  },
};
