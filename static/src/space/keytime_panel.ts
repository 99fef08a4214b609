// Under the time strip while an example is looked at: its events, found again or saved as the space's next version.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import type { Keytime } from "./keytime_rows";
import type { SpaceSession } from "./session";
import "./keytime_rows";

export interface KeytimeActs {
  move(moved: Keytime): void;
  find(): void;
  save(): void;
}

export function keytimePanel(session: SpaceSession, index: number, busy: boolean, { move, find, save }: KeytimeActs): TemplateResult {
  const keytimes = session.keytimesOf(index);
  const known = Object.keys(keytimes).length > 0;
  const changed = session.changedKeytimes;
  return html`<div class="keytimes" role="group" aria-label="Events of ${session.space.clips[index]!.name}">
    ${known
      ? html`<keytime-rows .keytimes=${keytimes} .duration=${session.space.clips[index]!.duration} @keytime=${({ detail }: CustomEvent<Keytime>) => move(detail)}></keytime-rows>`
      : html`<p class="quiet">No events are known here: the example is warped evenly.</p>`}
    <div class="keytime-acts"><button class="link-button" type="button" ?disabled=${busy} @click=${find}>${known ? "Find the events again" : "Find the events"}</button>
      ${changed ? html`<button class="button primary" type="button" ?disabled=${busy} @click=${save}>${icon("check")}Save as ${session.nextVersion}</button>` : nothing}</div></div>`;
}
