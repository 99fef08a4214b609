// How long a study takes. Rough on purpose: a figure is watched, then each line asked takes a moment.
import { at, listOf, partsOf, textOf, type Json, type Obj } from "./model";

const WATCHING = 6; // seconds before the first answer to a clip
const A_LINE = 3.2; // seconds for a step on a scale
const READING = 0.35; // seconds a word
const A_FIELD = 7;
const A_GUESS = 20;

/** Whole minutes, one at least. */
export function minutes(study: Json): number {
  const consent = words(at(study, ["welcome"])) + words(at(study, ["consent"]));
  const seconds = partsOf(study).reduce((sum, part) => sum + secondsOf(part), consent * READING);
  return Math.max(1, Math.round(seconds / 60));
}

/** How many trials a participant sees of a part. */
export function trialsOf(part: Obj): number {
  const clips = listOf(part["stimuli"]).length;
  const kind = textOf(at(part, ["task", "kind"]));
  if (kind === "match") return stepsOf(part);
  const sets = listOf(part["sets"]).length;
  const checks = listOf(part["checks"]).reduce<number>((sum, check) => sum + Number(at(check, ["count"]) ?? 1), 0);
  return shown(kind, Number(part["subset"] ?? clips), sets) + checks;
}

/** Every target with each interface, guessed first where the study says so; those for practice are not guessed. */
function stepsOf(part: Obj): number {
  const task = at(part, ["task"]);
  const times = at(task, ["guess_first"]) === false ? 1 : 2;
  return interfacesOf(task) * (targetsOf(part) * times + listOf(at(task, ["practice_targets"])).length);
}

const interfacesOf = (task: Json | undefined): number => listOf(at(task, ["interfaces"])).length || 3;
const targetsOf = (part: Obj): number => Number(part["subset"] ?? listOf(part["stimuli"]).length);

function shown(kind: string, clips: number, sets: number): number {
  if (sets) return sets;
  if (kind === "ab" || kind === "abx") return (clips * (clips - 1)) / 2;
  return kind === "choose" || kind === "parallel" || kind === "ranking" ? Math.min(clips, 1) : clips;
}

function secondsOf(part: Obj): number {
  switch (part["kind"]) {
    case "trials":
      return textOf(at(part, ["task", "kind"])) === "match" ? targetsOf(part) * secondsATarget(at(part, ["task"])) : trialsOf(part) * secondsATrial(part);
    case "form":
      return listOf(part["fields"]).length * A_FIELD;
    case "comment":
      return 15;
    default:
      return 4 + words(part) * READING;
  }
}

function secondsATrial(part: Obj): number {
  const task = at(part, ["task"]);
  const lines = listOf(at(task, ["scales"])).length + listOf(at(task, ["items"])).length;
  const figures = listOf(part["stimuli"]).length;
  switch (textOf(at(task, ["kind"]))) {
    case "choose":
    case "parallel":
    case "ranking":
      return WATCHING + Math.min(figures, 10) * 4;
    case "ab":
    case "abx":
      return WATCHING + 5;
    case "free_text":
      return WATCHING + 20;
    default:
      return WATCHING + lines * A_LINE;
  }
}

/** With every interface: a guess, and a match that takes half its time. */
function secondsATarget(task: Json | undefined): number {
  const guess = at(task, ["guess_first"]) === false ? 0 : A_GUESS;
  return interfacesOf(task) * (guess + Number(at(task, ["seconds"]) ?? 300) / 2);
}

/** The words of all texts in a value, in one of their languages. */
function words(value: Json | undefined): number {
  if (typeof value === "string") return value.split(/\s+/).filter(Boolean).length;
  if (Array.isArray(value)) return value.reduce<number>((sum, one) => sum + words(one), 0);
  if (typeof value !== "object" || value === null) return 0;
  if ("en" in value || "fi" in value || "ja" in value) return words(value["en"] ?? value["fi"] ?? value["ja"]);
  return Object.values(value).reduce<number>((sum, one) => sum + words(one), 0);
}
