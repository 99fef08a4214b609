// What the cards of the library and of its pickers show of a clip.
import { html, nothing, type TemplateResult } from "lit";
import { caption, type Clip } from "./model";

export const cardOf = (clip: Clip): TemplateResult => html`<span class="clip-stage"><motion-thumbnail src=${clip.glb_url} figure=${clip.figure_url ?? nothing} poster-time=${clip.poster_time}></motion-thumbnail>
    ${clip.state === "to_confirm" ? html`<span class="tag tag-accent">new</span>` : nothing}</span>
  <span class="clip-name">${clip.name}</span><span class="tiny">${caption(clip)}</span>`;
