// <space-removal>: asks whether a space shall be deleted, which of its versions, and says why it cannot be.
// Event: `removed`, a sentence.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { asApiError } from "../studio/session";
import * as server from "./server";

@customElement("space-removal")
export class SpaceRemoval extends LitElement {
  @state() private space: server.ListedSpace | null = null;
  /** How many versions the name has, if all of them may go together. */
  @state() private several = 0;
  @state() private which: server.Versions = "one";
  @state() private problem: ApiError | null = null;
  @state() private busy = false;
  @query("dialog") private dialog!: HTMLDialogElement | null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  async ask(space: server.ListedSpace, versions: readonly server.ListedSpace[]): Promise<void> {
    const together = versions.length > 1 && versions.every(({ may_delete }) => may_delete);
    Object.assign(this, { space, several: together ? versions.length : 0, which: "one", problem: null, busy: false });
    await this.updateComplete;
    this.dialog?.showModal();
  }

  private async go({ id, name, number }: server.ListedSpace): Promise<void> {
    this.busy = true;
    this.problem = null;
    try {
      await server.remove(id, this.which);
      const gone = this.which === "all" ? `All versions of “${name}” are deleted.` : `“${name}”, version ${number}, is deleted.`;
      this.dialog?.close();
      this.dispatchEvent(new CustomEvent("removed", { detail: gone }));
    } catch (error) {
      this.problem = asApiError(error);
    }
    this.busy = false;
  }

  protected override render(): TemplateResult | typeof nothing {
    const { space, several, which, problem, busy } = this;
    if (!space) return nothing;
    const submit = (event: SubmitEvent) => {
      event.preventDefault();
      void this.go(space);
    };
    const choice = (value: server.Versions, words: string) => html`<label class="choice"><input type="radio" name="which" .checked=${which === value}
      @change=${() => { this.which = value; this.problem = null; }}><span>${words}</span></label>`;
    const only = `Version ${space.number} only`;
    return html`<dialog class="space-dialog make-dialog" aria-labelledby="removal-title" @close=${() => (this.space = null)}><form @submit=${submit}>
      <header><h2 class="figure-title" id="removal-title">Delete “${space.name}”${several ? "" : `, version ${space.number}`}</h2></header>
      ${several ? html`<fieldset class="which"><legend class="visually-hidden">Which versions</legend>
        ${choice("one", only)}${choice("all", several === 2 ? "Both versions" : `All ${several} versions`)}</fieldset>` : nothing}
      <p class="quiet">Its clips stay, and so does every clip that was made in it. It cannot be brought back.</p>
      ${problem ? problemNote(problem) : nothing}
      <footer><button class="button" type="button" autofocus @click=${() => this.dialog?.close()}>Keep it</button>
        <button class="button danger" type="submit" ?disabled=${busy}>${busy ? "Being deleted" : which === "all" ? several === 2 ? "Delete both" : `Delete all ${several} versions` : "Delete"}</button></footer>
    </form></dialog>`;
  }
}
