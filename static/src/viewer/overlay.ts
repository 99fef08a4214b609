/** What is said over the stage: the motion is coming, it did not come, or it cannot be drawn. */
import { t } from "../words";
import { make } from "./dom";

/** Loading shorter than this is not worth a word. */
export const PATIENCE_MS = 300;

export function loadingMessage(): { element: HTMLElement; show(share: number): void } {
  const filled = make("div");
  const bar = make("div", { class: "bar" }, filled);
  const head = make("p", { class: "head" }, t("The motion is on its way"));
  return {
    element: make("div", { class: "message", role: "status" }, head, bar),
    show: (share) => {
      filled.style.width = `${Math.round(100 * share)}%`;
    },
  };
}

export function failureMessage(error: Error, retry: () => void): HTMLElement {
  return make(
    "div",
    { class: "message", role: "alert" },
    make("p", { class: "head" }, t("The motion did not arrive")),
    make("p", {}, error.message),
    make("button", { type: "button", click: retry }, t("Try again")),
  );
}

/** A page may say it in its own words through the slot. */
export function unsupportedMessage(): HTMLElement {
  const advice = t(
    "This page shows moving figures and needs WebGL 2, which this browser does not offer. " +
    "A current Firefox, Chrome, Edge or Safari has it; where it is switched off, “hardware " +
    "acceleration” in the browser’s settings brings it back.",
  );
  const slot = make(
    "slot",
    { name: "unsupported" },
    make("p", {}, make("strong", {}, t("The figure cannot be drawn here."))),
    make("p", {}, advice),
  );
  return make("div", { class: "unsupported", role: "alert" }, slot);
}
