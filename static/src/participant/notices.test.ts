import { render, type TemplateResult } from "lit";
import { afterEach, beforeEach, expect, test } from "vitest";
import { ApiError } from "../api";
import { pseudo, speak } from "../words";
import { clipOnItsWay, lineNote, otherTab, previewOver, savedMark, sending, stuck, type Line } from "./notices";

beforeEach(() => speak(pseudo()));
afterEach(() => speak(null));

const LINE: Line = { waiting: 0, offline: false, refusal: null };
const refusal = new ApiError("busy", "⟦told by the server⟧", null, null, 503);
const nothing = () => {};

/** What a notice says that did not go through the catalog. */
function unmarked(notice: TemplateResult): string {
  const place = document.createElement("div");
  render(notice, place);
  const labels = [...place.querySelectorAll("[aria-label]")].map((part) => part.getAttribute("aria-label"));
  expect(place.textContent).toContain("⟦");
  return [place.textContent, ...labels].join(" ").replace(/⟦[^⟧]*⟧/g, "").trim();
}

const NOTICES: Record<string, () => TemplateResult | symbol> = {
  saving: () => savedMark({ ...LINE, waiting: 1 }, 3),
  saved: () => savedMark(LINE, 3),
  "kept here": () => savedMark({ ...LINE, waiting: 1, offline: true }, 3),
  "no connection, nothing waits": () => lineNote({ ...LINE, offline: true }),
  "no connection, one waits": () => lineNote({ ...LINE, offline: true, waiting: 1 }),
  refused: () => lineNote({ ...LINE, refusal }),
  "on its way": () => clipOnItsWay(0.5, false, nothing),
  "slowly on its way": () => clipOnItsWay(0.5, true, nothing),
  "the last one": () => sending({ ...LINE, waiting: 1 }, nothing),
  "the last ones": () => sending({ ...LINE, waiting: 7 }, nothing),
  "being counted": () => sending(LINE, nothing),
  "not sent": () => sending({ ...LINE, refusal }, nothing),
  "other tab": otherTab,
  "preview over": () => previewOver(nothing),
  stuck: () => stuck("⟦title⟧", "⟦text⟧", "/help"),
};

test.each(Object.entries(NOTICES))("%s: every word goes through the catalog", (_, notice) => {
  expect(unmarked(notice() as TemplateResult)).toBe("");
});
