// Which marks the check row shows: near faults share one, and a label appears where it has room.
import { faultWords, sizeWords, type Finding } from "../checks";

export interface Mark {
  findings: Finding[];
  /** The one that goes farthest beyond its limit. */
  worst: Finding;
  words: string;
  labelled: boolean;
  /** The label stands before the mark: after it the strip ends. */
  before: boolean;
}

/** Pixels: between two marks, of a mark with its gap, of a letter. */
const APART = 26;
const MARK = 22;
const LETTER = 6.6;

export function marks(findings: readonly Finding[], duration: number, width: number): Mark[] {
  const pixels = (time: number) => (duration > 0 ? (time / duration) * width : 0);
  const groups: Finding[][] = [];
  for (const finding of [...findings].sort((a, b) => a.start - b.start)) {
    const last = groups.at(-1);
    if (last && pixels(finding.start) - pixels(last[0]!.start) < APART) last.push(finding);
    else groups.push([finding]);
  }
  let free = 0;
  return groups.map((group, index) => {
    const worst = group.reduce((a, b) => (excess(b) > excess(a) ? b : a));
    const words = wordsOf(worst, group.length - 1);
    const at = pixels(group[0]!.start);
    const next = groups[index + 1] ? pixels(groups[index + 1]![0]!.start) - MARK / 2 : width;
    const needed = MARK + LETTER * words.length;
    const after = next - at >= needed;
    const before = !after && at - free >= needed;
    free = after ? at + needed : at + MARK;
    return { findings: group, worst, words, labelled: after || before, before };
  });
}

/** "left foot slides 7 mm, and 2 more" */
function wordsOf(finding: Finding, others: number): string {
  const fault = `${faultWords(finding)} ${sizeWords(finding.size, finding.unit)}`;
  const more = others > 0 ? `, and ${others} more` : "";
  return fault.charAt(0).toLowerCase() + fault.slice(1) + more;
}

const excess = ({ size, limit }: Finding): number => size / Math.max(limit, 1e-9);
