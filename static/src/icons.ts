import { svg, html, type TemplateResult } from "lit";

/** An icon of the page's sprite (templates/macros/icons.html); always beside its word, so hidden from readers. */
export const icon = (name: string): TemplateResult =>
  html`<svg class="icon" aria-hidden="true">${svg`<use href="#icon-${name}"></use>`}</svg>`;
