// What a form's fields hold, and what is wrong with it.

import { set, unset, type Form } from "../../trials/kind";
import { t } from "../../words";

export interface Option {
  id: string;
  label: string;
}

export interface Field {
  id: string;
  label: string;
  type: "text" | "long_text" | "number" | "choice" | "choices";
  required: boolean;
  minimum?: number | null;
  maximum?: number | null;
  unit?: string | null;
  options: readonly Option[];
}

/** The server takes no number beyond this, nor below its negative. */
const LARGEST = 1e12;

/** A number as people type it, with a comma or a point; text that is none stays text. */
export function typed(field: Field, text: string, form: Form): Form {
  const trimmed = text.trim();
  if (trimmed === "") return unset(form, field.id);
  if (field.type !== "number") return set(form, field.id, text);
  const number = Number(trimmed.replace(",", "."));
  return set(form, field.id, Number.isFinite(number) ? number : text);
}

/** One option of several put in or taken out; they stay in the order of the study. */
export function toggled(field: Field, option: string, form: Form): Form {
  const before = form.answers[field.id];
  const held = new Set(Array.isArray(before) ? before : []);
  if (!held.delete(option)) held.add(option);
  const now = field.options.map(({ id }) => id).filter((id) => held.has(id));
  return now.length ? set(form, field.id, now) : unset(form, field.id);
}

/** What is wrong with a field, in words, or null. */
export function faultOf(field: Field, form: Form): string | null {
  const value = form.answers[field.id];
  if (value === undefined) return field.required ? missing(field) : null;
  if (field.type !== "number") return null;
  if (typeof value !== "number") return t("Please write a number.");
  const { minimum, maximum } = field;
  const [low, high] = [minimum ?? -LARGEST, maximum ?? LARGEST];
  if (low <= value && value <= high) return null;
  if (minimum == null && maximum != null) return t("Please write a number up to {high}.", { high });
  if (maximum == null && value < low) return t("Please write a number from {low} on.", { low });
  return t("Please write a number from {low} to {high}.", { low, high });
}

function missing({ type }: Field): string {
  return type.startsWith("choice") ? t("Please choose.") : t("Please fill this in.");
}
