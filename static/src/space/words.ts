// Texts of a space in the language that its author chose.
import type { Sliders, Words } from "./server";

export const LANGUAGES: Readonly<Record<string, string>> = { en: "English", fi: "Suomi", ja: "日本語" };

/** A text in a language; where it has none, in its first. */
export function wordsIn(words: Words, language: string): string {
  if (typeof words === "string") return words;
  const texts = words as Record<string, string | undefined>;
  return texts[language] ?? Object.values(texts)[0] ?? "";
}

/** The languages in which something of the sliders is said; none where all is said in one way. */
export function languagesOf(...kinds: (Sliders | null | undefined)[]): string[] {
  const texts = kinds.flatMap((sliders) => [
    ...(sliders?.primary.map(({ title }) => title) ?? []),
    ...(sliders?.parameters.flatMap(({ left, right }) => [left, right]) ?? []),
  ]);
  const known = texts.flatMap((words) => (typeof words === "string" ? [] : Object.keys(words)));
  return Object.keys(LANGUAGES).filter((language) => known.includes(language));
}
