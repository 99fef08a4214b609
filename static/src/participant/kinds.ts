// What a step is and asks: its kind from the registries, its part from the session.

import { ApiError } from "../api";
import { trials, type AnyKind } from "../trials";
import type { Asked, Step } from "../trials/kind";
import { t } from "../words";
import { pages } from "./pages";
import type { Session } from "./course";

export function kindOf(step: Step): AnyKind {
  const kind = trials[step.kind] ?? pages[step.kind];
  if (kind) return kind;
  const title = t("This page is older than the study.");
  throw new ApiError("unknown_kind", title, { kind: step.kind }, t("Load it again; your place is kept."), 0);
}

export const isTrial = (step: Step): boolean => step.kind in trials;

/** A page's figures belong to its part; from here on they are its step's, as those of a trial are. */
export function withFigures(session: Session): Session {
  const figuresOf = (step: Step) => (session.parts[step.part]?.["figures"] ?? []) as Session["steps"][number]["figures"];
  return { ...session, steps: session.steps.map((step) => (isTrial(step) ? step : { ...step, figures: figuresOf(step) })) };
}

/** A step with what its part of the study asks. */
export function asked(session: Session, step: Step): Asked<any> {
  return { task: session.parts[step.part] ?? {}, step };
}
