// Events of a cycle: when each foot stands, and those of a mix. No DOM in here.
import type { Contacts } from "../studio/time_strip";
import type { Keytimes } from "./server";
import type { SpaceSession } from "./session";

const START = "left_strike";
const SIDES = ["left", "right"] as const;

const wrapped = (time: number, duration: number): number => ((time % duration) + duration) % duration;

/** When each foot stands: from its strike to its leaving, over the end of the cycle where need be. */
export function contactsOf(keytimes: Keytimes, duration: number): Contacts {
  const stands = (side: string): [number, number][] => {
    const [strike, off] = [keytimes[`${side}_strike`], keytimes[`${side}_off`]];
    if (strike === undefined || off === undefined) return [];
    return strike <= off ? [[strike, off]] : [[0, off], [strike, duration]];
  };
  const [left, right] = SIDES.map(stands) as [[number, number][], [number, number][]];
  return { left, right };
}

/** The events of a mix, which begins with the left strike: the weighted means of the examples' own. */
export function mixedKeytimes(examples: readonly { keytimes: Keytimes; duration: number; weight: number }[]): Keytimes {
  const used = examples.filter(({ weight }) => weight > 0);
  if (!used.length || used.some(({ keytimes }) => keytimes[START] === undefined)) return {};
  const names = Object.keys(used[0]!.keytimes).filter((name) => used.every(({ keytimes }) => name in keytimes));
  const mean = (name: string) => used.reduce((sum, { keytimes, duration, weight }) =>
    sum + weight * wrapped(keytimes[name]! - keytimes[START]!, duration), 0);
  return Object.fromEntries(names.map((name) => [name, mean(name)]));
}

/** When the feet of the motion on the stage stand. */
export function mixedContacts(session: SpaceSession): Contacts {
  const { looking, space, weights } = session;
  if (looking !== null) return contactsOf(session.keytimesOf(looking), space.clips[looking]!.duration);
  const examples = space.clips.map(({ duration }, index) => ({ keytimes: session.keytimesOf(index), duration, weight: weights[index] ?? 0 }));
  const duration = examples.reduce((sum, one) => sum + one.weight * one.duration, 0);
  return contactsOf(mixedKeytimes(examples), duration);
}

export interface KeytimeRow {
  title: string;
  events: { name: string; word: string }[];
}

/** Events by what their names begin with: `left_strike` and `left_off` stand in the row “Left events”. */
export function rowsOf(keytimes: Keytimes): KeytimeRow[] {
  const rows = new Map<string, KeytimeRow>();
  for (const name of Object.keys(keytimes).sort()) {
    const [first, ...rest] = name.split("_");
    const foot = SIDES.includes(first as "left") && rest.length > 0;
    const title = foot ? `${first === "left" ? "Left" : "Right"} events` : "Events";
    const row = rows.get(title) ?? { title, events: [] };
    row.events.push({ name, word: foot ? rest.join(" ") : name.replaceAll("_", " ") });
    rows.set(title, row);
  }
  return [...rows.values()];
}

const STEP = 0.01;
const LEAP = 0.05;

/** Where a key takes a moment; null for a key that means nothing here. */
export function steppedTime(time: number, key: string, far: boolean): number | null {
  const step = far ? LEAP : STEP;
  if (key === "ArrowLeft" || key === "ArrowDown") return time - step;
  if (key === "ArrowRight" || key === "ArrowUp") return time + step;
  return key === "Home" ? 0 : null;
}
