// What can be done with clips that are chosen in the library.
import { html, type TemplateResult } from "lit";
import { counted, type Clip } from "./model";
import "../builder/use_in_study";

/** A clip that can be judged: it is kept, and a figure can stand on its skeleton. */
export const isUsable = ({ figure_url, state }: Clip): boolean => Boolean(figure_url) && state === "kept";

/** The bar below the clips. `found` are those that are shown; others may be chosen as well. */
export function chosenBar(chosen: readonly string[], found: readonly Clip[], choose: (ids: readonly string[] | null) => void): TemplateResult {
  const ids = found.filter(isUsable).map(({ id }) => id);
  const all = ids.length > 0 && ids.every((id) => chosen.includes(id));
  const toggleAll = () => choose(all ? chosen.filter((id) => !ids.includes(id)) : [...new Set([...chosen, ...ids])]);
  return html`<div class="chosen-bar" role="group" aria-label="What is chosen">
    <p role="status"><b>${counted(chosen.length, "clip")}</b> chosen</p>
    <div class="buttons"><button class="button quiet" type="button" ?disabled=${!ids.length} @click=${toggleAll}>${all ? "None of these" : `All ${ids.length}`}</button>
      <use-in-study look="button primary" .ids=${() => chosen} ?disabled=${!chosen.length}></use-in-study>
      <button class="button" type="button" @click=${() => choose(null)}>Done</button></div></div>`;
}
