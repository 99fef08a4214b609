// What can be filled in of each kind of part, as data; form.ts draws it, words.ts walks it.
import type { Json, Obj } from "./model";

interface Common {
  /** Where in the object, steps parted by dots. */
  at: string;
  label: string;
  hint?: string;
  /** Left out of the study file while it is empty. */
  optional?: boolean;
  /** Only shown while this holds of the object. */
  when?: (value: Obj) => boolean;
}

export type Field = Common &
  (
    | { type: "words"; long?: boolean }
    | { type: "text"; placeholder?: string }
    | { type: "number"; start?: number; min?: number; max?: number; step?: "any"; unit?: string }
    | { type: "time" }
    /** `start` is what holds where the study file says nothing. */
    | { type: "switch"; start?: boolean }
    | { type: "choice"; options: readonly [value: string, label: string][] }
    | { type: "list"; rows: readonly Field[]; one: string; blank: (index: number, ids: readonly string[]) => Json; inline?: boolean }
    /** A list of texts in several languages. */
    | { type: "lines"; one: string }
    | { type: "group"; fields: readonly Field[]; blank: Obj }
    | { type: "clip" }
    | { type: "clips" }
    | { type: "checks" }
    | { type: "sets" }
    | { type: "groups" }
    | { type: "blocks" }
    | { type: "languages" }
    /** Some of a few, in their order. */
    | { type: "several"; options: readonly [value: string, label: string][] }
    | { type: "space" }
    /** Stimuli drawn in the task's space: how many at first, by which seed, and what they are called. */
    | { type: "targets"; count: number; seed: number; word: string }
  );

export interface Kind {
  title: string;
  /** One line for who chooses among the kinds. */
  about: string;
  fields: readonly Field[];
  blank: Obj;
}

const id: Field = { type: "text", at: "id", label: "Name in the results", hint: "Small letters, digits and underscores." };
const heading: Field = { type: "words", at: "heading", label: "Heading" };
const text: Field = { type: "words", at: "text", label: "Text", long: true, hint: "An empty line begins a new paragraph." };

const question: Field[] = [
  { type: "words", at: "task.question", label: "Question" },
  { type: "words", at: "task.hint", label: "Hint below the question", optional: true },
];
const scales = (label: string): Field => ({
  type: "list", at: "task.scales", label, one: "scale", inline: true,
  rows: [
    { type: "words", at: "left", label: "Left word" },
    { type: "words", at: "right", label: "Right word" },
  ],
  blank: (index, ids) => ({ id: freshId("scale", index, ids), left: "", right: "" }),
});
const items = (label: string, one: string): Field => ({
  type: "list", at: "task.items", label, one, inline: true,
  rows: [{ type: "words", at: "label", label: `The ${one}` }],
  blank: (index, ids) => ({ id: freshId("item", index, ids), label: "" }),
});
const steps = (hint: string): Field => ({ type: "lines", at: "task.steps", label: "Steps", one: "step", hint });
const comment: Field = {
  type: "group", at: "task.comment", label: "Comment box", optional: true,
  blank: { label: "Anything else about this one?" },
  fields: [
    { type: "words", at: "label", label: "Label of the box" },
    { type: "words", at: "placeholder", label: "Grey text inside it", optional: true },
  ],
};

/** The kinds of trial: what is asked about moving figures. */
export const TASKS: Record<string, Kind> = {
  semantic_differential: {
    title: "Opposite words", about: "One figure, steps between two words",
    fields: [
      ...question, scales("Scales"), steps("From the left word to the right one; an odd number."),
      { type: "switch", at: "task.preselected", label: "Middle preselected until touched", start: true },
      { type: "switch", at: "task.shuffle_scales", label: "Scales in another order for each participant" },
      comment,
      { type: "clip", at: "task.reference", label: "Reference figure, in red beside the judged one", optional: true },
    ],
    blank: {
      kind: "semantic_differential", question: "How does this person seem to you?",
      scales: [{ id: "scale_1", left: "", right: "" }], steps: ["very", "somewhat", "neither", "somewhat", "very"],
      preselected: false,
    },
  },
  unipolar: {
    title: "Qualities", about: "One figure, how much of each quality",
    fields: [...question, items("Qualities", "quality"), steps("From none to most."), comment],
    blank: {
      kind: "unipolar", question: "How much does this apply to the movement?",
      items: [{ id: "item_1", label: "" }], steps: ["not at all", "a little", "somewhat", "quite", "very"],
    },
  },
  likert: {
    title: "Statements", about: "One figure, how far one agrees (Likert)",
    fields: [...question, items("Statements", "statement"), steps("From disagreeing to agreeing."), comment],
    blank: {
      kind: "likert", question: "How far do you agree?", items: [{ id: "item_1", label: "" }],
      steps: ["strongly disagree", "disagree", "neither", "agree", "strongly agree"],
    },
  },
  analogue: {
    title: "Sliders", about: "One figure, sliders without steps",
    fields: [...question, scales("Sliders"), comment],
    blank: { kind: "analogue", question: "How does this movement seem to you?", scales: [{ id: "scale_1", left: "", right: "" }] },
  },
  choose: {
    title: "Choose one", about: "Several figures in step, one is chosen",
    fields: [...question, { type: "switch", at: "task.allow_none", label: "“None of them” can be chosen" }, comment],
    blank: { kind: "choose", question: "Which one moves most naturally?" },
  },
  ab: {
    title: "A or B", about: "Two figures, one is chosen",
    fields: [...question, { type: "switch", at: "task.allow_same", label: "“No difference” can be chosen" }, comment],
    blank: { kind: "ab", question: "Which one moves more naturally?" },
  },
  abx: {
    title: "A, B and X", about: "Which of two is the third one equal to?",
    fields: [...question, comment],
    blank: { kind: "abx", question: "Which one moves like the third?" },
  },
  parallel: {
    title: "Side by side", about: "Several figures, a slider below each",
    fields: [...question, { type: "words", at: "task.low", label: "Left end of the sliders" }, { type: "words", at: "task.high", label: "Right end" }, comment],
    blank: { kind: "parallel", question: "How natural is each movement?", low: "not at all", high: "entirely" },
  },
  ranking: {
    title: "Put into order", about: "Several figures, from first to last",
    fields: [...question, { type: "words", at: "task.first", label: "Word for the first place" }, { type: "words", at: "task.last", label: "Word for the last place" }, comment],
    blank: { kind: "ranking", question: "Put these movements into order.", first: "most natural", last: "least natural" },
  },
  free_text: {
    title: "Own words", about: "One figure, described in one’s own words",
    fields: [...question, { type: "switch", at: "task.required", label: "An answer is needed", start: true }],
    blank: { kind: "free_text", question: "How would you describe this movement?", required: true },
  },
  match: {
    title: "Match a motion", about: "A target, made again with the sliders of a space",
    fields: [
      ...question,
      { type: "space", at: "task.space", label: "Authoring space" },
      { type: "several", at: "task.interfaces", label: "Made with", options: [["weights", "Weights of the examples"], ["adjectives", "Adjectives"], ["features", "Motion features"]] },
      { type: "number", at: "task.seconds", label: "Time for each", start: 300, min: 5, max: 3600, unit: "s", hint: "In seconds. After that a target is given up." },
      { type: "number", at: "task.threshold", label: "Alike below", start: 0.06, min: 0.001, max: 1, step: "any", unit: "m", hint: "In metres: how far the joints are from the target’s on average." },
      { type: "switch", at: "task.guess_first", label: "Guess first, without seeing the motion", start: true },
      { type: "switch", at: "task.examples", label: "All examples can be looked at", start: true },
      { type: "targets", at: "task.practice_targets", label: "Targets for practice", count: 3, seed: 2, word: "Practice", optional: true },
      { type: "targets", at: "stimuli", label: "Targets", count: 5, seed: 1, word: "Target" },
      comment,
    ],
    blank: { kind: "match", question: "Make the blue figure move like the green one.", space: "" },
  },
};

/** Those that show several figures at once. */
export const OF_MANY: readonly string[] = ["choose", "ab", "abx", "parallel", "ranking"];
const kindOf = (part: Obj): string => String((part["task"] as Obj | undefined)?.["kind"]);
const isOfMany = (part: Obj): boolean => OF_MANY.includes(kindOf(part));
/** Matching draws its targets, has some of its own for practice, and no answer that a check could tell. */
const isJudging = (part: Obj): boolean => kindOf(part) !== "match";

/** What trials of every kind have below their question. */
export const CLIPS: readonly Field[] = [
  { type: "clips", at: "stimuli", label: "Clips", when: isJudging },
  {
    type: "choice", at: "order", label: "Order",
    options: [["shuffle", "Shuffled for each participant"], ["latin_square", "Balanced Latin square"], ["fixed", "As listed"]],
  },
  { type: "number", at: "practice", label: "Clips first as practice, not analysed", start: 0, min: 0, when: isJudging },
  { type: "number", at: "subset", label: "Clips that each participant sees", min: 1, optional: true, hint: "Empty: all of them." },
  { type: "sets", at: "sets", label: "Which stand together", optional: true, when: isOfMany },
  { type: "choice", at: "block_by", label: "Keep together", optional: true, options: [["", "Nothing"], ["body", "Clips of one body"], ["style", "Clips of one style"]] },
  { type: "number", at: "break_every", label: "Trials until a pause is offered", min: 1, optional: true, hint: "Empty: no pause." },
  { type: "checks", at: "checks", label: "Attention checks", when: isJudging },
];

/** What every part has. */
export const SHOWN: readonly Field[] = [{ type: "groups", at: "groups", label: "Groups that see it", optional: true }, id];

const options: Field = {
  type: "list", at: "options", label: "Answers to choose from", one: "answer", inline: true,
  when: ({ type }) => String(type).startsWith("choice"),
  rows: [
    { type: "words", at: "label", label: "Answer" },
    { type: "switch", at: "screens_out", label: "ends the study" },
  ],
  blank: (index, ids) => ({ id: freshId("option", index, ids), label: "" }),
};
const ofNumbers = ({ type }: Obj): boolean => type === "number";

export const PAGES: Record<string, Kind> = {
  form: {
    title: "Questions about the person", about: "Age, experience, or anything else",
    fields: [
      heading, { ...text, optional: true },
      {
        type: "list", at: "fields", label: "Questions", one: "question",
        rows: [
          { type: "words", at: "label", label: "Question" },
          {
            type: "choice", at: "type", label: "Answer",
            options: [["text", "A line of text"], ["long_text", "A longer text"], ["number", "A number"], ["choice", "One of several"], ["choices", "Any of several"]],
          },
          { type: "number", at: "minimum", label: "At least", step: "any", optional: true, when: ofNumbers },
          { type: "number", at: "maximum", label: "At most", step: "any", optional: true, when: ofNumbers },
          { type: "words", at: "unit", label: "Unit", optional: true, when: ofNumbers },
          options,
          { type: "switch", at: "required", label: "An answer is needed", start: true },
          { type: "text", at: "id", label: "Name in the results" },
        ],
        blank: (index, ids) => ({ id: freshId("question", index, ids), label: "", type: "text", required: true }),
      },
    ],
    blank: { kind: "form", heading: "About you", fields: [{ id: "age", label: "How old are you?", type: "number", minimum: 18, maximum: 120, unit: "years", required: true }] },
  },
  instructions: {
    title: "Instructions", about: "A page to read, with figures that move",
    fields: [
      heading, text,
      {
        type: "list", at: "figures", label: "Figures", one: "figure",
        rows: [{ type: "clip", at: "clip", label: "Clip" }, { type: "words", at: "caption", label: "Line below it", optional: true }],
        blank: () => ({ clip: "" }),
      },
    ],
    blank: { kind: "instructions", heading: "How it works", text: "Watch each figure for as long as you like, then answer." },
  },
  break: {
    title: "Break", about: "A pause, for as long as one likes",
    fields: [heading, text],
    blank: { kind: "break", heading: "Take a break", text: "Rest your eyes. Go on whenever you like." },
  },
  comment: {
    title: "Last words", about: "Free text about the whole",
    fields: [
      { type: "words", at: "question", label: "Question" },
      { type: "words", at: "placeholder", label: "Grey text in the box", optional: true },
      { type: "switch", at: "required", label: "An answer is needed" },
    ],
    blank: { kind: "comment", question: "Is there anything else you would like to tell us?" },
  },
  debriefing: {
    title: "Debriefing", about: "What the study was about, at the end",
    fields: [heading, text],
    blank: { kind: "debriefing", heading: "What this was about", text: "" },
  },
};

/** The study as a whole. */
export const ABOUT: readonly Field[] = [
  { type: "text", at: "title", label: "Title", hint: "Researchers see it; participants see the welcome page’s heading." },
  { type: "languages", at: "languages", label: "Languages" },
  { type: "switch", at: "back", label: "Participants can go back and change an answer", start: true },
  { type: "text", at: "contact", label: "Your mail address, for participants", optional: true, placeholder: "name@example.org" },
  {
    type: "list", at: "groups", label: "Groups, equally large", one: "group", inline: true,
    rows: [{ type: "text", at: "label", label: "What it is called" }],
    blank: (index, ids) => ({ id: freshId("group", index, ids), label: `Group ${index + 1}` }),
  },
  { type: "blocks", at: "blocks", label: "Parts that change places by chance", optional: true },
];

export const WELCOME: readonly Field[] = [
  { type: "words", at: "welcome.heading", label: "Heading" },
  { type: "words", at: "welcome.lead", label: "What it is about", long: true },
  { type: "lines", at: "welcome.facts", label: "Three facts", one: "fact", hint: "How much there is to do, how long it takes, on what devices." },
  { type: "clip", at: "welcome.example", label: "A figure that moves beside the text", optional: true, hint: "Best none of those that are judged." },
];

export const CONSENT: readonly Field[] = [
  { type: "text", at: "consent.version", label: "Version", hint: "Another wording needs another version." },
  { type: "words", at: "consent.heading", label: "Heading" },
  {
    type: "list", at: "consent.terms", label: "Terms", one: "term",
    rows: [{ type: "words", at: "term", label: "Term" }, { type: "words", at: "text", label: "What it means", long: true }],
    blank: () => ({ term: "", text: "" }),
  },
  { type: "words", at: "consent.statement", label: "What participants agree to", long: true },
];

export const THANKS: readonly Field[] = [
  { type: "words", at: "thanks.heading", label: "Heading" },
  { type: "words", at: "thanks.text", label: "Text", long: true, hint: "{clips} becomes the number of clips judged." },
];

/** All fields of a part, by its kind and its task's. */
export function fieldsOf(part: Obj): readonly Field[] {
  if (part["kind"] !== "trials") return [...(PAGES[String(part["kind"])]?.fields ?? []), ...SHOWN];
  const task = TASKS[String((part["task"] as Obj | undefined)?.["kind"])];
  return [...(task?.fields ?? []), ...CLIPS.filter(({ when }) => when?.(part) ?? true), ...SHOWN];
}

/** A name for a new entry of a list that none of the others has. */
function freshId(word: string, index: number, taken: readonly string[]): string {
  let number = index + 1;
  while (taken.includes(`${word}_${number}`)) number += 1;
  return `${word}_${number}`;
}
