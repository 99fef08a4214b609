/** The part of a viewer that shows the stage: what it is called and how it is reached. */
import { t } from "../words";
import { make } from "./dom";

const help = () => t(
  "Space plays and pauses, R replays, left and right arrow step by frames, Home and End go to the " +
  "ends. Alt with the arrow keys turns the view, 0 resets it.",
);
const interactive = () => ({
  tabindex: "0",
  "aria-roledescription": t("moving figure"),
  "aria-describedby": "help",
});

export function helpText(): HTMLElement {
  return make("p", { class: "hidden", id: "help" }, help());
}

/** A still is a picture; anything else answers to the keyboard and can be reached by it. */
export function describeArea(area: HTMLElement, isStatic: boolean): void {
  area.setAttribute("role", isStatic ? "img" : "application");
  for (const [name, value] of Object.entries(interactive())) {
    if (isStatic) area.removeAttribute(name);
    else area.setAttribute(name, value);
  }
}

export function nameArea(area: HTMLElement, viewer: Element): void {
  const label = viewer.getAttribute("label") ?? viewer.getAttribute("aria-label");
  area.setAttribute("aria-label", label ?? t("Stage with a moving figure"));
}
