// What a match shows of its clock and of how near it came.

import { html, type TemplateResult } from "lit";
import { ref } from "lit/directives/ref.js";
import { t } from "../../words";

/** Of the bar's length, where a motion counts as alike. */
const MARK = 0.75;

/** `mm:ss`; a second that has begun counts. */
export function minutes(ms: number): string {
  const seconds = Math.max(0, Math.ceil(ms / 1000));
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
}

export const countdown = (left: number): TemplateResult =>
  html`<p class="match-clock"><span>${t("Time left")}</span> <strong role="timer" aria-live="off">${minutes(left)}</strong></p>`;

/** “It matches. It took 1 min 12 s.” */
export function lasted(ms: number): string {
  const whole = Math.round(ms / 1000);
  const [m, s] = [Math.floor(whole / 60), whole % 60];
  return m ? t("It matches. It took {m} min {s} s.", { m, s }) : t("It matches. It took {s} s.", { s });
}

/** How full the bar is: full where nothing differs, at the mark on the threshold, never quite empty. */
export function nearness(distance: number, threshold: number): number {
  return 1 / (1 + (distance / threshold) * (1 / MARK - 1));
}

/** A bar from far to close. @param distance metres, null while nothing is measured. */
export function closeness(distance: number | null, threshold: number): TemplateResult {
  const share = distance === null ? 0 : nearness(distance, threshold);
  const centimetres = (metres: number) => Math.round(1000 * metres) / 10;
  const said = distance === null ? t("not measured yet")
    : t("{distance} cm apart, alike below {threshold} cm", { distance: centimetres(distance), threshold: centimetres(threshold) });
  return html`<div class="closeness"><span aria-hidden="true">${t("far")}</span>
    <div class="closeness-bar ${distance !== null && distance < threshold ? "alike" : ""}" role="meter" aria-label=${t("How close the two are")}
      aria-valuemin="0" aria-valuemax="1" aria-valuenow=${share.toFixed(2)} aria-valuetext=${said} ${ref((element) => fill(element, share))}><i></i><b></b></div>
    <span aria-hidden="true">${t("close")}</span></div>`;
}

/** The content policy allows no style in markup, so it is set on the element. */
function fill(element: Element | undefined, share: number): void {
  const { style } = (element ?? {}) as Partial<HTMLElement>;
  style?.setProperty("--share", share.toFixed(4));
  style?.setProperty("--mark", String(MARK));
}
