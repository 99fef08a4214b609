// The lines of a file around a fault, cut so that the fault is in sight.

export interface ExcerptLine {
  number: number;
  before: string;
  /** The word at the fault; empty in the lines around it. */
  fault: string;
  after: string;
}

/**
 * Cut every line to at most `width` characters around the fault's column (both count from 1).
 *
 * Neighbouring lines are cut at the same place, so that what stands under each other in the file
 * still does so here.
 */
export function excerpt(
  context: readonly (readonly [number, string])[],
  line: number,
  column: number | null,
  width = 44,
): ExcerptLine[] {
  const faulty = context.find(([number]) => number === line)?.[1] ?? "";
  const start = column === null ? 0 : wordStart(faulty, column - 1);
  const from = Math.max(0, Math.min(start - Math.floor(width / 2), faulty.length - width));
  return context.map(([number, text]) => {
    const cut = (a: number, b: number) => text.slice(Math.max(a, from), Math.min(b, from + width));
    const tail = text.length > from + width ? " …" : "";
    const head = from > 0 && text.length > from ? "… " : "";
    if (number !== line || column === null) {
      return { number, before: head + cut(0, text.length) + tail, fault: "", after: "" };
    }
    const end = wordEnd(text, start);
    return { number, before: head + cut(0, start), fault: cut(start, end), after: cut(end, text.length) + tail };
  });
}

const wordStart = (text: string, index: number): number => {
  let start = Math.min(index, text.length);
  while (start > 0 && /\S/.test(text[start - 1] ?? "") && /\S/.test(text[start] ?? " ")) start--;
  return start;
};

const wordEnd = (text: string, start: number): number => {
  let end = start;
  while (end < text.length && /\S/.test(text[end] ?? "")) end++;
  return end;
};
