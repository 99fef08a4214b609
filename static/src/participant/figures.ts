// The files that a step shows, and the viewer that shows them.

import { html, nothing, type TemplateResult } from "lit";
import type { Figure, Step } from "../trials/kind";
import { t } from "../words";

/** A figure whose files are on this device. */
export interface Shown {
  src: string;
  figure: string | null;
  as?: "reference" | "judged" | "creation";
  label?: string;
  /** Pale, in the same place as the one who is solid. */
  ghost?: boolean;
}

/** Everyone on the page, the reference first: it stands on the left. */
function everyone({ reference, figures }: Step): Figure[] {
  return [...(reference ? [reference] : []), ...figures];
}

export function filesOf(step: Step): string[] {
  return everyone(step).flatMap(({ glb_url, figure_url }) => (figure_url ? [glb_url, figure_url] : [glb_url]));
}

/** @param kept where the files of `filesOf` lie on this device, in their order. */
export function shownOf(step: Step, kept: readonly string[]): Shown[] {
  const at = new Map(filesOf(step).map((url, index) => [url, kept[index] ?? url]));
  const shown = everyone(step).map(({ glb_url, figure_url }): Shown => ({
    src: at.get(glb_url) ?? glb_url,
    figure: figure_url && (at.get(figure_url) ?? figure_url),
  }));
  if (typeof step.seen === "boolean") return matchOf(shown[0]!, step.seen);
  if (!step.reference) return shown;
  return shown.map((figure, index) =>
    index === 0
      ? { ...figure, as: "reference", label: t("For comparison") }
      : { ...figure, as: "judged", label: t("Judge this one") },
  );
}

/** The target and, where it is seen, who is to become like it: the same body, whose own motion comes later. */
function matchOf(target: Shown, seen: boolean): Shown[] {
  const green: Shown = { ...target, as: "judged", label: t("Target") };
  return seen ? [{ ...green, ghost: true }, { ...target, as: "creation", label: t("Your motion") }] : [green];
}

export interface ViewerEvents {
  ready: () => void;
  unsupported: () => void;
  frame: (event: Event) => void;
}

export function viewer(figures: readonly Shown[], cells: boolean, hidden: boolean, on: ViewerEvents): TemplateResult {
  return html`<motion-viewer theme="light" controls=${cells ? "none" : "simple"} arrange=${cells ? "cells" : "ghost"}
    autoplay loop="auto" ?in-step=${figures.some(({ as }) => as === "creation")} class=${hidden ? "away" : ""} @ready=${on.ready} @unsupported=${on.unsupported} @frame=${on.frame}>
    ${figures.map(({ src, figure, as, label, ghost }) => html`<motion-figure src=${src} figure=${figure ?? nothing}
      as=${as ?? nothing} label=${label ?? nothing} ?ghost=${ghost}></motion-figure>`)}</motion-viewer>`;
}
