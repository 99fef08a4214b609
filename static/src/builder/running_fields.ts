// How a study is run, as fields: the same forms as the builder's.
import type { Field } from "./fields";

const code = (at: string, label: string, optional: boolean): Field => ({ type: "text", at, label, ...(optional ? { optional } : {}) });

export const WHO: readonly Field[] = [
  { type: "switch", at: "open_link", label: "Whoever has the link may take part", start: true },
  { type: "number", at: "quota", label: "How many may complete it", min: 1, optional: true, hint: "Empty: any number." },
  { type: "time", at: "opens_at", label: "Opens", optional: true, hint: "In your own time zone." },
  { type: "time", at: "closes_at", label: "Closes", optional: true, hint: "In your own time zone." },
];

export const PROLIFIC: readonly Field[] = [
  {
    type: "group", at: "prolific", label: "Prolific", optional: true, blank: { complete: "" },
    fields: [
      code("complete", "Completion code", false),
      code("screened_out", "Code for who is screened out", true),
      code("failed_attention", "Code for failed attention checks", true),
    ],
  },
];

export const SONA: readonly Field[] = [
  {
    type: "group", at: "sona", label: "SONA", optional: true, blank: { credit_url: "" },
    fields: [{ type: "text", at: "credit_url", label: "Address that grants the credit", placeholder: "https://…&survey_code={id}", hint: "SONA calls it the completion URL, client-side. {id} stands for the participant." }],
  },
];

export const MTURK: readonly Field[] = [
  {
    type: "group", at: "mturk", label: "Mechanical Turk", optional: true, blank: { sandbox: false },
    fields: [{ type: "switch", at: "sandbox", label: "In the sandbox" }],
  },
];

export const RULES: readonly Field[] = [
  { type: "number", at: "lease_minutes", label: "Minutes without an answer until a place goes to somebody else", min: 1, max: 100000 },
  { type: "number", at: "resume_days", label: "Days in which one can come back and go on", min: 1, max: 3650 },
  { type: "number", at: "fail_after", label: "Failed attention checks that end the study", min: 1, max: 100, optional: true, hint: "Empty: none do." },
  { type: "number", at: "retention_days", label: "Days after the last answer until everything personal is deleted", min: 1, max: 36500, optional: true, hint: "Empty: never." },
];
