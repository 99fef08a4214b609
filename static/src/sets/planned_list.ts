// The right side before anything is made: each clip with its name, which can be changed.

import { html, nothing, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { icon } from "../icons";
import { clipCount, keyOf, type Choice, type Planned } from "./model";

const SHOWN = 200; // rows with a field each; the others are made just as well

export interface PlannedList {
  choice: Choice;
  items: readonly Planned[];
  leftOut: number;
  rename(key: string, name: string): void;
  leaveOut(key: string): void;
  putBack(): void;
}

export function plannedList(given: PlannedList): TemplateResult {
  const { items, leftOut } = given;
  const there = items.filter(({ clip }) => clip).length;
  const words = [
    there ? `${there === items.length ? "all" : there} in the library already` : "",
    leftOut ? `${leftOut} left out` : "",
  ].filter(Boolean);
  return html`<p class="small quiet" role="status">${words.join(" · ")}
      ${leftOut ? html`<button class="link-button" type="button" @click=${given.putBack}>Put back</button>` : nothing}</p>
    <ol class="set-items">${repeat(items.slice(0, SHOWN), keyOf, (item) => row(item, given))}</ol>
    ${items.length > SHOWN ? html`<p class="quiet">and ${clipCount(items.length - SHOWN)} more, named in the same way.</p>` : nothing}`;
}

function row(item: Planned, { choice, rename, leaveOut }: PlannedList): TemplateResult {
  const key = keyOf(item);
  const proposed = `${item.source_name}, ${item.preset_title.toLowerCase()}`;
  return html`<li>
    <input class="input" aria-label="Name for ${proposed}" maxlength="200" .value=${choice.names.get(key) ?? item.name}
      @input=${(event: InputEvent) => rename(key, (event.target as HTMLInputElement).value)}>
    <span class="tiny">${item.preset_title} · ${item.tags.body ?? item.source_name}${item.clip
      ? html` · <a href="/library/${item.clip}">in the library</a>`
      : nothing}</span>
    <button class="button quiet icon-button" type="button" data-leave-out @click=${(event: Event) => leave(event, () => leaveOut(key))}>
      ${icon("close")}<span class="visually-hidden">Leave out ${proposed}</span></button></li>`;
}

/** The row goes; the focus stays in the list, on the row that takes its place. */
function leave(event: Event, act: () => void): void {
  const item = (event.currentTarget as Element).closest("li");
  const next = item?.nextElementSibling ?? item?.previousElementSibling;
  next?.querySelector<HTMLElement>("[data-leave-out]")?.focus();
  act();
}
