// The lines of a file around a fault, cut so that the fault is in sight.

export interface ExcerptLine {
  number: number;
  before: string;
  /** The word at the fault; empty in the lines around it. */
  fault: string;
  after: string;
}

/**
 * Cut every line to at most `width` characters around the fault.
 *
 * Neighbouring lines are cut at the same place, so that what stands under each other in the file
 * still does so here.
 *
 * @param column of the fault in the file's own line, from 1.
 * @param word the word that is at fault, where the message quotes it. The server cuts very long
 *   lines as well (they then begin with …), after which the column alone cannot find it.
 */
export function excerpt(
  context: readonly (readonly [number, string])[],
  line: number,
  column: number | null,
  word = "",
  width = 30,
): ExcerptLine[] {
  const faulty = context.find(([number]) => number === line)?.[1] ?? "";
  const start = faultStart(faulty, column, word);
  const from = Math.max(0, Math.min((start ?? 0) - (width >> 1), faulty.length - width));
  return context.map(([number, text]) => {
    const cut = (a: number, b: number) => text.slice(Math.max(a, from), Math.min(b, from + width));
    const tail = text.length > from + width && !text.endsWith("…") ? " …" : "";
    const head = from > 0 && text.length > from ? "… " : "";
    if (number !== line || start === null) {
      return { number, before: head + cut(0, text.length) + tail, fault: "", after: "" };
    }
    const end = wordEnd(text, start);
    const after = cut(end, text.length) + tail;
    return { number, before: head + cut(0, start), fault: cut(start, end), after };
  });
}

function faultStart(text: string, column: number | null, word: string): number | null {
  if (!text.startsWith("…")) return column === null ? null : wordStart(text, column - 1);
  const starts = [...text.matchAll(/\S+/g)].filter(([found]) => found === word).map(({ index }) => index);
  const middle = text.length / 2; // the server keeps the fault near the middle of what it cuts out
  starts.sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle));
  return starts[0] ?? null;
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
