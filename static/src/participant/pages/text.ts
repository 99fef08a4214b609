// Paragraphs of a study's text, parted by empty lines.

import { html, type TemplateResult } from "lit";

export function paragraphs(text: string | null | undefined): TemplateResult[] {
  const found = (text ?? "").split(/\n\s*\n/).map((paragraph) => paragraph.trim());
  return found.filter(Boolean).map((paragraph) => html`<p>${paragraph}</p>`);
}
