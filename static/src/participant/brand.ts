// The mark and the name, as templates/macros/icons.html draws them.

import { html, type TemplateResult } from "lit";

export const brand = (): TemplateResult =>
  html`<span class="brand"><svg class="mark" viewBox="0 0 18 28" aria-hidden="true">
    <path d="M3.6 26.4 9.9 9.6c2.3 5 2.9 7 3.2 9.6l1 7"/><circle cx="11" cy="4.6" r="3.4"/></svg> Manner</span>`;
