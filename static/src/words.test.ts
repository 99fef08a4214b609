import { afterEach, expect, test } from "vitest";
import { language, pseudo, speak, t, tn } from "./words";

afterEach(() => {
  speak(null);
  document.body.innerHTML = "";
});

/** A page as the server sends it. */
function page(words: unknown): void {
  document.body.innerHTML = `<script type="application/json" id="words"></script>`;
  document.getElementById("words")!.textContent = JSON.stringify(words);
}

const FINNISH = {
  language: "fi",
  texts: {
    "Next clip": "Seuraava liike",
    "Clip {number} of {count}": "Liike {number}/{count}",
    "{n} answer": ["{n} vastaus", "{n} vastausta"],
    "Not yet done": "",
  },
};

test("a page without words speaks English", () => {
  expect(t("Next clip")).toBe("Next clip");
  expect(tn("{n} answer", "{n} answers", 1)).toBe("1 answer");
  expect(tn("{n} answer", "{n} answers", 0)).toBe("0 answers");
  expect(language()).toBe("en");
});

test("a text is found by its English words, with its values put in", () => {
  page(FINNISH);
  expect(t("Next clip")).toBe("Seuraava liike");
  expect(t("Clip {number} of {count}", { number: 3, count: 42 })).toBe("Liike 3/42");
  expect(language()).toBe("fi");
});

test("a text without a translation is shown in English rather than not at all", () => {
  page(FINNISH);
  expect(t("Back")).toBe("Back");
  expect(t("Not yet done")).toBe("Not yet done");
});

test("Finnish and English know one and many, Japanese knows one form only", () => {
  speak(FINNISH);
  expect([0, 1, 2].map((n) => tn("{n} answer", "{n} answers", n))).toEqual(["0 vastausta", "1 vastaus", "2 vastausta"]);
  speak({ language: "ja", texts: { "{n} answer": ["{n}件の回答"] } });
  expect([0, 1, 2].map((n) => tn("{n} answer", "{n} answers", n))).toEqual(["0件の回答", "1件の回答", "2件の回答"]);
});

test("numbers are written as the language writes them, texts as they are", () => {
  const count = (language: string) => {
    speak({ language, texts: {} });
    return t("{count} clips", { count: 1234 });
  };
  expect([count("en"), count("fi"), count("ja")]).toEqual(["1,234 clips", "1\u00a0234 clips", "1,234 clips"]);
  expect(t("Named {name}", { name: "1234" })).toBe("Named 1234");
});

test("a name in braces that has no value stays as it is, and a value is not read again", () => {
  expect(t("{one} and {two}", { one: "{two}" })).toBe("{two} and {two}");
});

test("the pseudo catalog marks every text that went through it", () => {
  speak(pseudo());
  expect(t("Clip {number} of {count}", { number: 3, count: 42 })).toBe("⟦Clip 3 of 42⟧");
  expect(tn("{n} answer", "{n} answers", 2)).toMatch(/^⟦.*⟧$/);
});
