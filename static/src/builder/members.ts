// <study-members>: who works on a study, and as what.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import { refusal } from "./dialogs";

type Members = components["schemas"]["MemberList"];
type Role = Members["role"];

const ROLES: readonly [Role, string][] = [["viewer", "Viewer: sees everything"], ["editor", "Editor: also changes the study"], ["owner", "Owner: also decides about members"]];

@customElement("study-members")
export class StudyMembers extends LitElement {
  @property() slug = "";
  @state() private list: Members | null = null;
  @state() private refused: ApiError | null = null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override firstUpdated(): void {
    void this.attempt(async () => void (this.list = await api.get<Members>(this.address())));
  }

  private address(email?: string): string {
    const members = `/api/v1/studies/${this.slug}/members`;
    return email ? `${members}/${encodeURIComponent(email)}` : members;
  }

  private async attempt(act: () => Promise<void>): Promise<boolean> {
    this.refused = null;
    try {
      await act();
      return true;
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.refused = error;
      this.requestUpdate();
      return false;
    }
  }

  private readonly put = (email: string, role: Role): Promise<boolean> =>
    this.attempt(async () => void (this.list = await api.put<Members>(this.address(email), { role })));

  private async leaveOut(email: string, you: boolean): Promise<void> {
    await this.attempt(async () => {
      await api.delete(this.address(email));
      if (you) return location.assign("/research");
      this.list = await api.get<Members>(this.address());
    });
  }

  protected override render(): TemplateResult {
    const { list } = this;
    const add = async (event: SubmitEvent) => {
      event.preventDefault();
      const form = event.target as HTMLFormElement;
      const given = new FormData(form);
      if (await this.put(String(given.get("email")), given.get("role") as Role)) form.reset();
    };
    const roles = (chosen: Role) => ROLES.map(([role, label]) => html`<option value=${role} ?selected=${role === chosen}>${label}</option>`);
    return html`${this.refused ? refusal(this.refused) : nothing}
      ${list?.everybodys ? html`<p class="quiet">This study belongs to every researcher of this server. With the first member it becomes yours and theirs.</p>` : nothing}
      <ul class="members rows">${list?.members.map((member) => html`<li><div><b>${member.name}</b>${member.you ? " (you)" : nothing}<p class="tiny">${member.email}</p></div>
        <select class="input" aria-label=${`Role of ${member.name}`} ?disabled=${list.role !== "owner"} .value=${live(member.role)} @change=${(event: Event) => void this.put(member.email, (event.target as HTMLSelectElement).value as Role)}>${roles(member.role)}</select>
        ${list.role === "owner" || member.you ? html`<button class="button quiet" type="button" @click=${() => void this.leaveOut(member.email, member.you)}>${member.you ? "Leave" : "Remove"}<span class="visually-hidden"> ${member.name}</span></button>` : nothing}</li>`)}</ul>
      ${list?.role === "owner" ? html`<form class="add-member" @submit=${add}><label class="field"><span class="label">Mail address of a researcher here</span><input class="input" type="email" name="email" required autocomplete="off"></label>
        <label class="field"><span class="label">Role</span><select class="input" name="role">${roles("viewer")}</select></label>
        <button class="button" type="submit">${icon("plus")}Add</button></form>` : nothing}`;
  }
}
