// The interface's words in the page's language. The English text is the key of its translation; the server puts the
// translations that scripts need into the page (`<script type="application/json" id="words">`). A page without them is
// in English.

/** A text, or its forms for one and for more. */
export type Translation = string | readonly string[];

export interface Catalog {
  language: string;
  texts: Record<string, Translation>;
}

type Values = Record<string, string | number>;
const ENGLISH: Catalog = { language: "en", texts: {} };
let catalog: Catalog | null = null;

/** A text, with `{name}` replaced by its value; a number is written as the language writes it. */
export function t(text: string, values: Values = {}): string {
  const found = words().texts[text];
  return filled(typeof found === "string" && found ? found : text, values);
}

/** A text that depends on a whole number; `{n}` is the number. */
export function tn(one: string, many: string, n: number, values: Values = {}): string {
  const { texts, language } = words();
  const found = texts[one];
  const translated = typeof found === "string" ? [found] : (found ?? []);
  const forms = translated.length && translated.every(Boolean) ? translated : [one, many];
  const isOne = new Intl.PluralRules(language).select(n) === "one";
  return filled((isOne ? forms[0] : forms.at(-1)) ?? many, { n, ...values });
}

/** The page's language, such as `fi`. */
export function language(): string {
  return words().language;
}

/** Use these words instead of the page's, or the page's again; for tests. */
export function speak(words: Catalog | null): void {
  catalog = words;
}

/**
 * A catalog in which every text is marked as “⟦text⟧”, for tests: what is shown without the marks has not gone
 * through `t` or `tn`.
 */
export function pseudo(): Catalog {
  const texts = new Proxy({}, { get: (_, text) => (typeof text === "string" ? `⟦${text}⟧` : undefined) });
  return { language: "en", texts };
}

function words(): Catalog {
  catalog ??= fromPage();
  return catalog;
}

function fromPage(): Catalog {
  const text = document.getElementById("words")?.textContent;
  return text ? (JSON.parse(text) as Catalog) : ENGLISH;
}

function filled(text: string, values: Values): string {
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => {
    const value = values[name];
    return typeof value === "number" ? value.toLocaleString(language()) : (value ?? whole);
  });
}
