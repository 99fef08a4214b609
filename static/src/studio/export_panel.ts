// Ways to take a motion along: as a file, as its recipe, as a call of the API, into a study.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import "../builder/use_in_study";
import { asCurl, asPython, asRecipe, type Variant } from "./exports";

export type Suffix = "bvh" | "glb" | "json";

export interface ExportActs {
  /** What is on the stage, as a recipe. */
  variant(): Promise<Variant>;
  download(suffix: Suffix): void;
  copied(text: string): void;
  /** The clip that is on the stage, saved first; none where it cannot be. */
  saved(): Promise<readonly string[]>;
}

/** `said`: what was copied, in words. `more` stands beside its use in a study. */
export function exportPanel(
  { said, busy }: { said: string; busy: boolean }, { variant, download, copied, saved }: ExportActs, more: TemplateResult | typeof nothing = nothing,
): TemplateResult {
  const copy = (write: (variant: Variant) => string, what: string) => async () => {
    await navigator.clipboard.writeText(write(await variant()));
    copied(`${what} copied`);
  };
  const file = (suffix: Suffix, words: string) => html`<button class="button" type="button"
    ?disabled=${busy} title=${words} @click=${() => download(suffix)}>${icon("download")}${suffix.toUpperCase()}</button>`;
  const server = location.origin;
  return html`<section class="exports" id="export" tabindex="-1"><header><h2>Export</h2><span class="tiny" role="status">${said}</span></header>
    <div class="files" role="group" aria-label="Download">${file("glb", "With its figure, for 3D programs")}${file("bvh", "For animation programs")}${file("json", "Everything as numbers")}</div>
    <ul>
      <li><button class="link-button" type="button" @click=${copy(asRecipe, "Recipe")}>${icon("copy")}Copy as recipe</button></li>
      <li><button class="link-button" type="button" @click=${copy((one) => asCurl(one, server), "Call")}>${icon("copy")}Copy as curl call</button></li>
      <li><button class="link-button" type="button" @click=${copy((one) => asPython(one, server), "Program")}>${icon("copy")}Copy as Python</button></li>
    </ul>
    <p class="hint">The calls read an <a href="/research/keys">API key</a> from MANNER_KEY.</p>
    <div class="make-of-it"><use-in-study look="link-button make-set" .ids=${saved} ?disabled=${busy}></use-in-study>${more}</div></section>`;
}
