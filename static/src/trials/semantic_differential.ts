// Trial type: one moving figure, judged on bipolar scales. The middle of every scale is preselected.

export interface Scale {
  id: string;
  left: string;
  right: string;
}

/** What a study sets. */
export interface Parameters {
  /** The question above the scales. */
  question: string;
  hint: string;
  scales: readonly Scale[];
  /** Words for the steps from the left end to the right end, an odd number of them. */
  steps: readonly string[];
  comment_label: string;
  comment_placeholder: string;
}

/** What a person sets: steps from −2 (left) to 2 (right) for five steps, and the scales that were touched at all. */
export interface Form {
  answers: Record<string, number>;
  touched: string[];
  comment: string;
}

export const type = "semantic_differential";

/** What is stored for each trial, with its unit. */
export const data = {
  answers: "steps from the middle, negative to the left",
  touched: "ids of the scales whose step was chosen, rather than left as preselected",
  comment: "text",
  rt_ms: "ms from the clip's first picture to the answer, by the page's monotonic clock",
  time_elapsed_ms: "ms from the session's first trial page on this device to the answer",
  "record.plays": "count of plays begun",
  "record.viewing_ms": "ms during which the clip was moving",
  "record.camera_moves": "count of turns of the camera",
  "record.hidden_ms": "ms during which the page was hidden",
  "record.blur_count": "count of times that the window lost the focus",
  "record.dropped_frames": "count of display frames that came late",
  "record.tier": "quality at which the figure was drawn",
  "record.viewport": "CSS px, and device px per CSS px",
} as const;

/** Steps as numbers around 0. */
export function values(steps: readonly string[]): number[] {
  const middle = (steps.length - 1) / 2;
  return steps.map((_, index) => index - middle);
}

/** What a screen reader says for a step: “rather sad”, “neither”. */
export function nameOf(value: number, scale: Scale, steps: readonly string[]): string {
  const word = steps[value + (steps.length - 1) / 2] ?? "";
  if (value === 0) return word;
  return `${word} ${value < 0 ? scale.left : scale.right}`;
}

export function blank({ scales }: Pick<Parameters, "scales">): Form {
  return { answers: Object.fromEntries(scales.map(({ id }) => [id, 0])), touched: [], comment: "" };
}

/** Choose a step; choosing the preselected middle counts as touching the scale. */
export function choose(form: Form, scale: string, value: number): Form {
  const touched = form.touched.includes(scale) ? form.touched : [...form.touched, scale];
  return { ...form, answers: { ...form.answers, [scale]: value }, touched };
}

export function same(one: Form, other: Form): boolean {
  const keys = Object.keys(one.answers);
  return (
    one.comment.trim() === other.comment.trim() &&
    keys.every((key) => one.answers[key] === other.answers[key]) &&
    one.touched.length === other.touched.length
  );
}

/** An answer as a made-up person would give it: any step, each as likely. `random` gives numbers from 0 up to 1. */
export function simulate({ scales, steps }: Parameters, random: () => number): Form {
  const choices = values(steps);
  const pick = () => choices[Math.floor(random() * choices.length)] ?? 0;
  return scales.reduce((form, { id }) => choose(form, id, pick()), blank({ scales }));
}
