// The form that corrects what an import guessed: unit, up axis, and which joint plays which role.
import { html, nothing, type TemplateResult } from "lit";
import { roleWords, type Report } from "./model";

const UNITS: [metres: number, word: string][] = [
  [1, "metres"],
  [0.1, "decimetres"],
  [0.01, "centimetres"],
  [0.001, "millimetres"],
  [0.0254, "inches"],
  [0.3048, "feet"],
];
const AXES = ["x", "y", "z", "-x", "-y", "-z"];

export interface Corrections {
  unit?: number;
  up_axis?: string;
  roles?: Record<string, string>;
}

export function correctionsForm(
  report: Report,
  apply: (corrections: Corrections) => void,
  cancel: () => void,
): TemplateResult {
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    apply(changed(report, new FormData(event.target as HTMLFormElement)));
  };
  return html`<form class="corrections" @submit=${submit}>
    <div class="pair">
      <div class="field"><label for="unit">One unit in the file is</label>
        <select class="input" id="unit" name="unit">${unitOptions(report)}</select></div>
      <div class="field"><label for="up_axis">Upward is</label>
        <select class="input" id="up_axis" name="up_axis">
          ${AXES.map((axis) => html`<option value=${axis} ?selected=${axis === report.up_axis}>${axis.replace("-", "−")}</option>`)}
        </select></div>
    </div>
    <table class="roles"><caption class="label">Which joint moves which part</caption>
      <tbody>${rolesOf(report).map((role) => roleRow(report, role))}</tbody></table>
    <div class="buttons">
      <button class="button primary">Read it again</button>
      <button class="button quiet" type="button" @click=${cancel}>Leave as it is</button>
    </div>
  </form>`;
}

/**
 * Only what differs from the report, so that the rest is still found from the file.
 *
 * The server takes the roles as one thing: earlier corrections go along with the new ones. An empty
 * joint takes a guessed role away.
 */
export function changed(report: Report, form: FormData): Corrections {
  const unit = Number(form.get("unit"));
  const axis = String(form.get("up_axis"));
  const chosen = rolesOf(report).map((role) => [role, String(form.get(`role:${role}`) ?? "")] as const);
  const moved = chosen.filter(([role, joint]) => joint !== (report.roles[role] ?? ""));
  return {
    ...(unit !== report.unit ? { unit } : {}),
    ...(axis !== report.up_axis ? { up_axis: axis } : {}),
    ...(moved.length ? { roles: { ...report.options?.roles, ...Object.fromEntries(moved) } } : {}),
  };
}

const rolesOf = (report: Report): string[] => [...Object.keys(report.roles), ...report.missing_roles];

function unitOptions(report: Report) {
  const known = UNITS.some(([metres]) => metres === report.unit);
  const found = known ? nothing : html`<option value=${report.unit} selected>${report.unit_name}</option>`;
  return html`${found}${UNITS.map(
    ([metres, word]) => html`<option value=${metres} ?selected=${metres === report.unit}>${word}</option>`,
  )}`;
}

function roleRow(report: Report, role: string): TemplateResult {
  const joint = report.roles[role];
  const options = report.joint_names.map(
    (name) => html`<option ?selected=${name === joint}>${name}</option>`,
  );
  return html`<tr>
    <th scope="row"><label for="role:${role}">${roleWords(role)}</label></th>
    <td><select class="input" id="role:${role}" name="role:${role}">
      <option value="" ?selected=${!joint}>no joint</option>${options}
    </select></td>
  </tr>`;
}
