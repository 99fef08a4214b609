// An edited clip's page: make it again and compare, and list what the edit broke.
import { html, render, type TemplateResult } from "lit";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import type { MotionViewer } from "../viewer";
import { findingPlace, findingSize, rebuiltWords, type Finding } from "./provenance_words";

type Schemas = components["schemas"];

export function provenance(root: ParentNode = document): void {
  const button = root.querySelector<HTMLButtonElement>("[data-rebuild]");
  const said = root.querySelector<HTMLElement>("[data-rebuilt]");
  if (button && said) button.addEventListener("click", () => void rebuild(button, said));
  const place = root.querySelector<HTMLElement>("[data-quality]");
  if (place) void look(place, root.querySelector<MotionViewer>("motion-viewer"));
}

async function rebuild(button: HTMLButtonElement, said: HTMLElement): Promise<void> {
  const id = button.dataset.rebuild ?? "";
  button.disabled = true;
  render(html`Being made again.`, said);
  try {
    const result = await api.post<Schemas["Rebuilt"]>(`/api/v1/clips/${id}/rebuild`);
    const isOther = result.clip.id !== id;
    const link = isOther ? html` <a href=${result.clip.page_url}>Show it</a>` : "";
    render(html`${rebuiltWords(result.identical, isOther)}${link}`, said);
  } catch (error) {
    render(problem(error), said);
  } finally {
    button.disabled = false;
  }
}

async function look(place: HTMLElement, viewer: MotionViewer | null): Promise<void> {
  // What the server has put there says that somebody is looking; it gives way to the outcome.
  place.replaceChildren();
  render(html`<p class="quiet">Being looked at.</p>`, place);
  try {
    const id = place.dataset.quality ?? "";
    const { report } = await api.get<Schemas["Checked"]>(`/api/v1/clips/${id}/quality`);
    render(report.clean ? clean : findings(report.findings, viewer), place);
  } catch (error) {
    render(html`<p>${problem(error)}</p>`, place);
  }
}

const clean = html`<ul class="report-notes"><li>${icon("check")}
  <p>No sliding feet, bent joints, lost balance or jerks beyond the source’s own.</p></li></ul>`;

const findings = (found: Finding[], viewer: MotionViewer | null): TemplateResult => html`
  <ul class="report-notes findings">${found.map(
    (finding) => html`<li>${icon("warning")}<p>${finding.part}: ${finding.kind}<br>
      <span class="small quiet">${findingSize(finding)}</span></p>
      <button class="link-button tiny place" type="button" @click=${() => viewer?.seek(finding.start)}
        aria-label=${`Show ${findingPlace(finding)}`}>${findingPlace(finding)}</button></li>`,
  )}</ul>`;

function problem(error: unknown): string {
  if (!(error instanceof ApiError)) throw error;
  return [error.message, error.mend].filter(Boolean).join(" ");
}
