import { describe, expect, it } from "vitest";
import { minutes, trialsOf } from "./estimate";
import { fieldsOf, PAGES, TASKS } from "./fields";
import { asCsv } from "./links";
import { at, duplicated, freeName, moved, put, renamedPart, withoutPart, wordsIn, wordsWith, type Json, type Obj } from "./model";
import { selectedBy } from "./parts_list";
import { missingIn, textsOf } from "./texts";

const part = (id: string): Obj => ({ id, kind: "break", heading: "Rest", text: "Go on." });
const study = (...parts: Obj[]): Obj => ({ languages: ["en", "fi"], parts });

describe("a study as JSON", () => {
  it("changes at a place and nowhere else, and the one before stays as it was", () => {
    const before = study(part("a"), part("b"));
    const after = put(before, ["parts", 1, "heading"], "Pause");
    expect(at(after, ["parts", 1, "heading"])).toBe("Pause");
    expect(at(before, ["parts", 1, "heading"])).toBe("Rest");
    expect(at(after, ["parts", 0])).toBe(at(before, ["parts", 0]));
  });

  it("makes what is missing on the way, and takes out what becomes undefined", () => {
    const made = put({}, ["task", "comment"], { label: "More?" });
    expect(made).toEqual({ task: { comment: { label: "More?" } } });
    expect(put(made, ["task", "comment"], undefined)).toEqual({ task: {} });
    expect(put(["a", "b"], [0], undefined)).toEqual(["b"]);
    expect(at("text", ["parts", 0])).toBeUndefined();
  });

  it("keeps the order of its members, so that a file stays readable", () => {
    expect(Object.keys(put({ a: 1, b: 2, c: 3 }, ["b"], 4) as Obj)).toEqual(["a", "b", "c"]);
  });

  it("moves entries within the list, and no further than its ends", () => {
    expect(moved(["a", "b", "c"], 0, 2)).toEqual(["b", "c", "a"]);
    expect(moved(["a", "b", "c"], 2, 0)).toEqual(["c", "a", "b"]);
    expect(moved(["a", "b"], 0, 9)).toEqual(["b", "a"]);
  });

  it("gives copies names of their own", () => {
    const two = duplicated(duplicated(study(part("rest")), 0), 0);
    expect((at(two, ["parts"]) as Obj[]).map(({ id }) => id)).toEqual(["rest", "rest_3", "rest_2"]);
    expect(freeName("Über 30!", [])).toBe("ber_30");
    expect(freeName("42", [])).toBe("part");
  });

  it("carries a part's new name, and its end, over to the blocks", () => {
    const blocks = { ...study(part("a"), part("b"), part("c")), blocks: [["a", "b"]] };
    expect(at(renamedPart(blocks, 0, "first"), ["blocks"])).toEqual([["first", "b"]]);
    expect(at(withoutPart(blocks, 1), ["blocks"])).toEqual([]);
    expect(at(withoutPart(blocks, 2), ["blocks"])).toEqual([["a", "b"]]);
  });
});

describe("texts in several languages", () => {
  it("stay plain as long as one language is all", () => {
    expect(wordsWith("sad", "en", "en", "gloomy")).toBe("gloomy");
    expect(wordsWith({ en: "sad", fi: "surullinen" }, "fi", "en", "")).toBe("sad");
  });

  it("keep the first language when another is added", () => {
    const words = wordsWith("sad", "fi", "en", "surullinen");
    expect(words).toEqual({ en: "sad", fi: "surullinen" });
    expect(wordsIn(words, "fi", "en")).toBe("surullinen");
    expect(wordsIn("sad", "fi", "en")).toBe("");
  });

  it("are found in every kind of part, with those that a language lacks", () => {
    for (const [kind, { blank }] of [...Object.entries(PAGES), ...Object.entries(TASKS)]) {
      const isTask = kind in TASKS;
      const whole = study(isTask ? { id: kind, kind: "trials", task: blank, stimuli: [] } : { id: kind, ...blank });
      const found = textsOf(whole);
      expect(found.length, kind).toBeGreaterThan(0);
      expect(missingIn(whole, "fi").length, kind).toBe(found.filter(({ words }) => words).length);
      expect(missingIn(whole, "en"), kind).toEqual([]);
    }
  });
});

describe("the fields of every kind", () => {
  it.each([...Object.keys(PAGES), ...Object.keys(TASKS)])("name each place once and have words: %s", (kind) => {
    const blank = kind in TASKS ? { kind: "trials", task: TASKS[kind]!.blank } : PAGES[kind]!.blank;
    const fields = fieldsOf(blank);
    expect(new Set(fields.map(({ at: place }) => place)).size).toBe(fields.length);
    expect(fields.every(({ label }) => label)).toBe(true);
  });
});

describe("how long it takes", () => {
  const trials = (kind: string, count: number, more: Obj = {}): Obj => ({
    kind: "trials", task: TASKS[kind]!.blank, stimuli: Array.from({ length: count }, (_, index) => `clip_${index}`), ...more,
  });

  it("counts what a participant sees: pairs, subsets, clips that come again", () => {
    expect(trialsOf(trials("likert", 40))).toBe(40);
    expect(trialsOf(trials("likert", 40, { subset: 10 }))).toBe(10);
    expect(trialsOf(trials("ab", 5))).toBe(10);
    expect(trialsOf(trials("choose", 10))).toBe(1);
    expect(trialsOf(trials("match", 5, { task: { kind: "match", practice_targets: [1, 2, 3] } }))).toBe(39);
    expect(trialsOf(trials("match", 5, { task: { kind: "match", guess_first: false, interfaces: ["weights"] } }))).toBe(5);
    expect(trialsOf(trials("likert", 40, { checks: [{ kind: "repeated", count: 2 }, { kind: "catch" }] }))).toBe(43);
  });

  it("grows with every clip and is never less than a minute", () => {
    const lengths = [0, 10, 20, 40].map((count) => minutes({ parts: [trials("semantic_differential", count)] } as Json));
    expect(lengths[0]).toBe(1);
    expect([...lengths].sort((one, other) => one - other)).toEqual(lengths);
    expect(lengths[3]!).toBeGreaterThan(lengths[1]!);
  });
});

describe("around the study", () => {
  it("leads from a problem to the page that has its field", () => {
    expect(selectedBy(["parts", 3, "task", "question"])).toBe(3);
    expect(selectedBy(["consent", "version"])).toBe("welcome");
    expect(selectedBy(["thanks", "text"])).toBe("thanks");
    expect(selectedBy(["title"])).toBe("about");
  });

  it("writes personal links as a table that no spreadsheet takes for formulas", () => {
    const table = asCsv([{ label: '=1+"2"', url: "https://x/?invite=a,b" }]);
    expect(table).toBe('label,url\r\n"\'=1+""2""","https://x/?invite=a,b"\r\n');
  });
});
