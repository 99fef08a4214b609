// A study file as it is being edited: plain JSON, changed only by making another. No DOM in here.
import type { components } from "../api-types";
import type { Json } from "../studio/recipe";

export type { Json };
export type Obj = { [name: string]: Json };
export type Path = readonly (string | number)[];
export type Study = components["schemas"]["StudyDetail"];
export type Problem = components["schemas"]["Problem"];
export type Language = "en" | "fi" | "ja";

export const LANGUAGES: readonly [Language, string][] = [["en", "English"], ["fi", "Suomi"], ["ja", "日本語"]];

export const isObj = (value: Json | undefined): value is Obj =>
  typeof value === "object" && value !== null && !Array.isArray(value);
export const listOf = (value: Json | undefined): Json[] => (Array.isArray(value) ? value : []);
export const objOf = (value: Json | undefined): Obj => (isObj(value) ? value : {});
export const textOf = (value: Json | undefined): string => (typeof value === "string" ? value : "");

/** What stands at a place; undefined where nothing does. */
export function at(root: Json | undefined, path: Path): Json | undefined {
  let found = root;
  for (const step of path) {
    if (Array.isArray(found) && typeof step === "number") found = found[step];
    else if (isObj(found) && typeof step === "string") found = found[step];
    else return undefined;
  }
  return found;
}

/** The same with another value at a place; undefined takes the member, or the list's entry, out. */
export function put(root: Json | undefined, path: Path, value: Json | undefined): Json {
  const [step, ...rest] = path;
  if (step === undefined) return value ?? null;
  if (typeof step === "number") {
    const list = [...listOf(root)];
    if (!rest.length && value === undefined) list.splice(step, 1);
    else list[step] = rest.length ? put(list[step], rest, value) : value!;
    return list;
  }
  const { [step]: old, ...others } = objOf(root);
  if (!rest.length && value === undefined) return others;
  const next = rest.length ? put(old, rest, value) : value!;
  return old === undefined ? { ...others, [step]: next } : { ...objOf(root), [step]: next };
}

/** The same list with one entry at another place. */
export function moved<T>(list: readonly T[], from: number, to: number): T[] {
  const rest = [...list];
  rest.splice(Math.max(0, Math.min(to, list.length - 1)), 0, ...rest.splice(from, 1));
  return rest;
}

export const samePath = (one: Path, other: Path): boolean =>
  one.length === other.length && one.every((step, index) => step === other[index]);

/** The problems of a place itself: of a text also those of its languages. */
export const problemsAt = (problems: readonly Problem[], path: Path, deep = false): Problem[] =>
  problems.filter(({ where }) => samePath(where.slice(0, path.length), path) && (deep || where.length === path.length));

/** A problem's message where its place stands beside it, so that its name need not. */
export function said({ where, message }: Problem, what: string): string {
  return message.replace(`“${where.at(-1)}” `, `${what} `);
}

export const partsOf = (study: Json): Obj[] => listOf(at(study, ["parts"])).map(objOf);

export function languagesOf(study: Json): Language[] {
  const known = LANGUAGES.map(([id]) => id as string);
  const found = listOf(at(study, ["languages"])).filter((one) => known.includes(one as string)) as Language[];
  return found.length ? found : ["en"];
}

/** A text in one language; "" where it has none of its own. A plain text is the first language's. */
export function wordsIn(words: Json | undefined, language: Language, first: Language): string {
  if (isObj(words)) return textOf(words[language]);
  return language === first ? textOf(words) : "";
}

/** A text with another wording in one language. It stays a plain text as long as one language is all. */
export function wordsWith(words: Json | undefined, language: Language, first: Language, text: string): Json {
  if (!isObj(words) && language === first) return text;
  const before: Obj = isObj(words) ? words : { [first]: textOf(words) };
  const next = text || language === first ? { ...before, [language]: text } : (put(before, [language], undefined) as Obj);
  const only = Object.keys(next);
  return only.length === 1 && only[0] === first ? next[first]! : next;
}

/** "emotion_trial" as a person reads it. */
export function inWords(name: Json | undefined): string {
  const words = textOf(name).replaceAll("_", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** A name that none of these has: the wanted one, or with a number. */
export function freeName(wanted: string, taken: readonly string[]): string {
  const base = wanted.toLowerCase().replace(/[^a-z0-9]+/g, "_").replace(/^[^a-z]+|_+$/g, "").slice(0, 50) || "part";
  let name = base;
  for (let number = 2; taken.includes(name); number += 1) name = `${base}_${number}`;
  return name;
}

/** A copy of a part under a name of its own, after the original. */
export function duplicated(study: Json, index: number): Json {
  const parts = partsOf(study);
  const part = parts[index]!;
  const base = textOf(part["id"]).replace(/_\d+$/, "");
  const copy = { ...part, id: freeName(base, parts.map(({ id }) => textOf(id))) };
  return put(study, ["parts"], [...parts.slice(0, index + 1), copy, ...parts.slice(index + 1)]);
}

/** The study with another name for a part, also where blocks name it. */
export function renamedPart(study: Json, index: number, name: string): Json {
  const before = partsOf(study)[index]?.["id"] ?? null;
  const blocks = listOf(at(study, ["blocks"])).map((block) => listOf(block).map((one) => (one === before ? name : one)));
  const renamed = put(study, ["parts", index, "id"], name);
  return blocks.length ? put(renamed, ["blocks"], blocks) : renamed;
}

/** The study without a part; blocks of fewer than two parts go with it. */
export function withoutPart(study: Json, index: number): Json {
  const gone = partsOf(study)[index]?.["id"] ?? null;
  const rest = put(study, ["parts", index], undefined);
  const blocks = listOf(at(study, ["blocks"])).map((block) => listOf(block).filter((one) => one !== gone));
  return blocks.length ? put(rest, ["blocks"], blocks.filter((block) => block.length > 1)) : rest;
}
