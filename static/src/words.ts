// The interface's words in the page's language. The English text is the key of its translation.

/** A text, with `{name}` replaced by its value. */
export function t(text: string, values: Record<string, string | number> = {}): string {
  return filled(text, values);
}

/** A text that depends on a number; `{n}` is the number. */
export function tn(one: string, many: string, n: number, values: Record<string, string | number> = {}): string {
  return filled(n === 1 ? one : many, { n, ...values });
}

function filled(text: string, values: Record<string, string | number>): string {
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => String(values[name] ?? whole));
}
