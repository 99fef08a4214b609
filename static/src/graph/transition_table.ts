// The transitions one by one: where they leave and enter, how well they fit; shown, removed, added, restored.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import {
  centimetres, clipWords, degrees, sameKey, seconds, type GraphDetail, type Key, type Transition,
} from "./model";

export interface TableState {
  graph: GraphDetail;
  from: string;
  to: string;
  most: number;
  /** What is looked at, or taken just now. */
  chosen: Key | null;
}

export interface TableActs {
  filter(from: string, to: string): void;
  more(): void;
  show(transition: Transition): void;
  remove(transition: Transition): void;
  restore(key: Key): void;
  add(key: Key): void;
}

export function transitionTable(state: TableState, acts: TableActs): TemplateResult {
  const { graph, from, to, most } = state;
  const all = graph.transitions.filter((t) => (!from || t.source === from) && (!to || t.target === to));
  const chosen = (side: "from" | "to") => (event: Event) => {
    const { value } = event.target as HTMLSelectElement;
    acts.filter(side === "from" ? value : from, side === "to" ? value : to);
  };
  return html`<div class="table-filters">
      ${clipSelect("From", graph, from, chosen("from"), "any clip")}
      ${clipSelect("To", graph, to, chosen("to"), "any clip")}
      <p class="quiet" role="status">${all.length} of ${graph.transitions.length}</p>
    </div>
    ${all.length
      ? html`<div class="table-scroll"><table class="transitions">
          <thead><tr><th scope="col">From</th><th scope="col" class="number">At</th><th scope="col">To</th><th scope="col" class="number">At</th>
            <th scope="col" class="number">Distance</th><th scope="col" class="number">Turn</th><th scope="col"><span class="visually-hidden">Acts</span></th></tr></thead>
          <tbody>${all.slice(0, most).map((one) => row(one, state, acts))}</tbody>
        </table></div>`
      : html`<p class="quiet">No transition leads there. ${from || to ? "Choose other clips" : "Raise the threshold"}, or add one by hand.</p>`}
    ${all.length > most ? html`<button class="button" type="button" @click=${acts.more}>Show more</button>` : nothing}
    ${graph.kind === "own" ? html`${addition(graph, acts)}${removals(graph, acts)}` : nothing}`;
}

function row(one: Transition, { graph, chosen }: TableState, acts: TableActs): TemplateResult {
  const frameTime = graph.members[0]!.frame_time;
  const at = (frame: number) => html`<td class="number" title="frame ${frame}">${seconds(frame, frameTime)}</td>`;
  const words = `${clipWords(one.source)} at ${seconds(one.source_frame, frameTime)} to ${clipWords(one.target)}`;
  const isChosen = chosen !== null && sameKey(chosen, one);
  return html`<tr class=${isChosen ? "chosen" : ""} data-choose @click=${() => acts.show(one)}>
    <th scope="row">${clipWords(one.source)}${one.added ? html` <span class="tag">added</span>` : nothing}</th>${at(one.source_frame)}
    <td>${clipWords(one.target)}</td>${at(one.target_frame)}
    <td class="number">${centimetres(one.distance)}</td><td class="number">${degrees(one.turn)}</td>
    <td class="acts">
      <button class="link-button" type="button" aria-label="Show ${words}" @click=${(event: Event) => act(event, () => acts.show(one))}>${icon("play")}Show</button>
      ${graph.kind === "own"
        ? html`<button class="link-button" type="button" aria-label="Remove ${words}" @click=${(event: Event) => act(event, () => acts.remove(one))}>Remove</button>`
        : nothing}
    </td></tr>`;
}

/** The whole row shows its transition; a button in it does its own act alone. */
function act(event: Event, done: () => void): void {
  event.stopPropagation();
  done();
}

function addition(graph: GraphDetail, acts: TableActs): TemplateResult {
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    const data = new FormData(event.target as HTMLFormElement);
    acts.add({
      source: String(data.get("source")),
      source_frame: Number(data.get("source_frame")),
      target: String(data.get("target")),
      target_frame: Number(data.get("target_frame")),
    });
  };
  const frame = (name: string, label: string) => html`<label class="field"><span class="label">${label}</span>
    <input class="input" type="number" name=${name} min="0" step="1" value="0" required></label>`;
  return html`<form class="add-transition" aria-label="Add a transition" @submit=${submit}>
    ${clipSelect("Leave", graph, graph.members[0]!.name, undefined, "", "source")} ${frame("source_frame", "at frame")}
    ${clipSelect("for", graph, graph.members.at(-1)!.name, undefined, "", "target")} ${frame("target_frame", "at frame")}
    <button class="button" type="submit">Add transition</button>
  </form>`;
}

function removals(graph: GraphDetail, acts: TableActs): TemplateResult | typeof nothing {
  const { removed } = graph;
  if (!removed.length) return nothing;
  const frameTime = graph.members[0]!.frame_time;
  return html`<details class="removals"><summary>${removed.length} removed by hand</summary><ul class="rows">
    ${removed.map(
      (key) => html`<li><span>${clipWords(key.source)} at ${seconds(key.source_frame, frameTime)} to ${clipWords(key.target)} at
        ${seconds(key.target_frame, frameTime)}</span>
        <button class="link-button" type="button" @click=${() => acts.restore(key)}>Restore</button></li>`,
    )}</ul></details>`;
}

function clipSelect(
  label: string, graph: GraphDetail, chosen: string, change?: (event: Event) => void, any = "", name = "",
): TemplateResult {
  return html`<label class="field"><span class="label">${label}</span>
    <select class="input" name=${name || nothing} @change=${change ?? nothing}>
      ${any ? html`<option value="" ?selected=${!chosen}>${any}</option>` : nothing}
      ${graph.members.map((member) => html`<option value=${member.name} ?selected=${member.name === chosen}>${clipWords(member.name)}</option>`)}
    </select></label>`;
}
