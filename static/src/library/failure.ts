// A file that could not be read: what, where (with the lines around it), and the way on.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { excerpt } from "./excerpt";
import type { ImportItem } from "./imports";

export interface Place {
  line?: number;
  column?: number;
  frame?: number;
  joint?: string;
  channel?: string;
  context?: [number, string][];
}

/** Ways on that the server may offer, as the button that takes them. */
const OFFERS: Record<string, { word: string; options: Record<string, unknown> }> = {
  fill_gaps: { word: "Fill and import", options: { fill_gaps: true } },
  drop_first_frame: { word: "Drop the first frame and import", options: { drop_first_frame: true } },
};

export function failure(
  item: ImportItem,
  retry: (options: Record<string, unknown>) => void,
  leaveOut: () => void,
): TemplateResult {
  const error = item.error;
  const place = (error?.where ?? {}) as Place;
  const offer = OFFERS[error?.offer ?? ""];
  const again = error?.transient ? { word: "Try again", options: {} } : undefined;
  const way = offer ?? again;
  return html`<div class="note note-bad flat" role="alert">
      ${icon("warning")}
      <p><b>${item.file.name} was not imported.</b> ${problem(error?.message ?? "", place)}</p>
    </div>
    <div class="drawer-body failure">
      ${placeWords(place) ? html`<h2 class="figure-title" tabindex="-1">${placeWords(place)}</h2>` : nothing}
      ${place.context?.length ? excerptBlock(place, error?.message ?? "") : nothing}
      ${error?.mend ? html`<p class="quiet">${error.mend}</p>` : nothing}
      <div class="buttons">
        ${way
          ? html`<button class="button primary" data-first @click=${() => retry(way.options)}>${way.word}</button>`
          : nothing}
        <button class="button" ?data-first=${!way} @click=${leaveOut}>Leave it out</button>
      </div>
    </div>`;
}

/** The message with its place said once, as line and column; frame and joint stand in the heading. */
export function problem(message: string, { line, column, frame, joint, channel }: Place): string {
  const bare = message.replace(/^Line \d+(, column \d+)?: /, "");
  const said = [frame === undefined ? "" : `frame ${frame}`, joint, channel].filter(Boolean).join(", ");
  const rest = said && bare.startsWith(`${said}: `) ? bare.slice(said.length + 2) : bare;
  return (line ? `Line ${line}${column ? `, column ${column}` : ""}: ` : "") + rest;
}

const placeWords = ({ frame, joint, channel }: Place): string =>
  [frame === undefined ? "" : `Frame ${frame}`, joint, channel && axisWords(channel)].filter(Boolean).join(", ");

/** "Zrotation" as a person says it. */
const axisWords = (channel: string): string => channel.replace(/^([XYZ])(rotation|position)$/i, "$1 $2");

function excerptBlock({ context = [], line = 0, column }: Place, message: string): TemplateResult {
  const word = /“([^”]+)”/.exec(message)?.[1];
  const lines = excerpt(context, line, column ?? null, word);
  return html`<pre class="excerpt" tabindex="0" aria-label="The file around line ${line}">${lines.map(
    ({ number, before, fault, after }) =>
      html`<span class="line-number">${number}</span>${before}${fault ? html`<mark>${fault}</mark>` : nothing}${after}\n`,
  )}</pre>`;
}
