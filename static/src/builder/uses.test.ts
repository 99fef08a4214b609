import { expect, it } from "vitest";
import { outcome, places, type Added, type Draft } from "./uses";

const draft = (more: Partial<Draft>): Draft => ({
  slug: "gaits", title: "Gaits", state: "draft", version: null, languages: ["en", "ja"], parts: [{ id: "walks", task: "likert", clips: 1 }], ...more,
});
const added = (more: Partial<Added>): Added => ({
  title: "Gaits", part: "walks", added: ["a", "b"], already: [], draft: { saved_at: "", problems: [], can_be_shown: true }, ...more,
});

it("offers each part that asks about clips, by its name only where there are several", () => {
  const two = draft({ state: "open", version: 3, languages: ["en"], parts: [{ id: "walks", task: "ab", clips: 4 }, { id: "to_match", task: "match", clips: 1 }] });
  expect(places([draft({}), two]).map(({ part, about }) => [part, about])).toEqual([
    ["walks", "1 clip · English, 日本語 · not published"],
    ["walks", "Walks · 4 clips · English · open, for version 4"],
    ["to_match", "To match · 1 target · English · open, for version 4"],
  ]);
});

it("offers a study that asks nothing yet", () => {
  expect(places([draft({ parts: [] })])).toMatchObject([{ part: null, about: "no question yet · English, 日本語 · not published" }]);
});

it("tells what was there already, and what participants see of it", () => {
  const [place] = places([draft({})]);
  expect(outcome(place!, added({}), draft({}))).toEqual({
    title: "Added to Gaits", about: "2 new clips.", address: "/research/studies/gaits/edit#walks/stimuli",
  });
  expect(outcome(place!, added({ added: ["a"], already: ["b"] }), draft({ version: 1 })).about).toBe(
    "1 new clip. One was there already. Participants see them once the next version is published.",
  );
});
