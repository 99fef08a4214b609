import { render } from "lit";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { ApiError } from "../../api";
import { empty, type Form, type Made, type View, type Workshop } from "../kind";
import { match } from "../match";
import { rests, type Parameters } from "./model";

const task: Parameters = {
  seconds: 60, threshold: 0.06, start: 0.5, example_figures: [],
  sliders: { weights: ["e0", "e1"].map((id) => ({ id, title: id, left: "", right: "" })) },
};
interface Asking { values: Record<string, number>; answer: (made: Partial<Made>) => void; refuse: (error: unknown) => void }

let form: Form;
let asked: Asking[];
let shown: number;
let seen: boolean;
let place: HTMLElement;

const workshop: Workshop = {
  make: (_, values) => new Promise((answer, refuse) => asked.push({
    values: { ...values }, refuse, answer: (made) => answer({ glb: new ArrayBuffer(0), distance: 0.2, solved: false, ...made }),
  })),
  show: () => Promise.resolve(void shown++),
  arrange: () => {},
};

function draw(): void {
  const change: View<Parameters>["change"] = (act) => { form = act(form); draw(); };
  const step = { index: 3, part: "p", kind: "match", figures: [], interface: "weights", seen };
  render(match.panel({ task, step, form, change, pressed: false, workshop }), place);
}

const sliders = () => [...place.querySelectorAll<HTMLInputElement>("input[type=range]")];
const settled = async () => { await vi.advanceTimersByTimeAsync(0); };
/** Until the next motion may be asked for. */
const soon = async () => { await vi.advanceTimersByTimeAsync(50); };
const over = () => rests({ task, step: { index: 3, part: "p", kind: "match", figures: [], seen } }, form);

async function drag(index: number, value: number): Promise<void> {
  const slider = sliders()[index]!;
  slider.value = String(value);
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  await settled();
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setInterval", "clearInterval", "setTimeout", "clearTimeout", "performance"] });
  [form, asked, shown, seen] = [empty(), [], 0, true];
  place = document.createElement("div");
  document.body.replaceChildren(place);
});

afterEach(() => {
  document.body.replaceChildren();
  vi.useRealTimers();
});

async function begun(): Promise<void> {
  draw();
  await settled();
  asked[0]!.answer({});
  await settled();
}

it("the clock waits for the first picture of both, and the sliders with it", async () => {
  draw();
  await settled();
  expect(asked.map(({ values }) => values)).toEqual([{ e0: 0.5, e1: 0.5 }]);
  expect(place.querySelector("fieldset")!.disabled).toBe(true);
  await vi.advanceTimersByTimeAsync(10_000);
  expect(place.querySelector("[role=timer]")!.textContent).toBe("1:00");
  asked[0]!.answer({});
  await vi.advanceTimersByTimeAsync(5_000);
  expect(shown).toBe(1);
  expect(place.querySelector("fieldset")!.disabled).toBe(false);
  expect(place.querySelector("[role=timer]")!.textContent).toBe("0:55");
});

it("one motion is under way at a time, and the newest position goes next", async () => {
  await begun();
  await soon();
  for (const value of [0.1, 0.2, 0.3]) await drag(0, value);
  expect(asked.length).toBe(2);
  asked[1]!.answer({});
  await settled();
  expect(asked.length).toBe(2); // twenty a second at most, however fast they come
  await soon();
  expect(asked.slice(1).map(({ values }) => values["e0"])).toEqual([0.1, 0.3]);
});

it("a match stops the clock, with the sliders where the matching motion was made", async () => {
  await begun();
  await vi.advanceTimersByTimeAsync(2_000);
  await drag(0, 0.1);
  await drag(0, 0.9);
  asked[1]!.answer({ distance: 0.01, solved: true });
  await settled();
  expect(form.answers).toEqual({ e0: 0.1, e1: 0.5, seconds: 2 });
  expect(sliders()[0]!.value).toBe("0.1");
  expect(place.textContent).toContain("It matches. It took 2 s.");
  await vi.advanceTimersByTimeAsync(60_000);
  expect(form.answers["seconds"]).toBe(2);
});

it("when the time is up, what the sliders show is measured once more and handed in", async () => {
  await begun();
  await vi.advanceTimersByTimeAsync(59_000);
  await drag(1, 0.7);
  await vi.advanceTimersByTimeAsync(2_000);
  expect(over()).toBe(false);
  asked[1]!.answer({});
  await settled();
  asked[2]!.answer({});
  await settled();
  expect(form.answers).toEqual({ e0: 0.5, e1: 0.7, seconds: 60 });
  expect(place.textContent).toContain("Time is up.");
});

it("those who do not see the clock hear of it twice", async () => {
  task.seconds = 90;
  await begun();
  const said = new Set<string>();
  for (let second = 0; second < 89; second++) {
    await vi.advanceTimersByTimeAsync(1_000);
    said.add(place.querySelector("[role=status]")!.textContent!.trim());
  }
  task.seconds = 60;
  expect([...said]).toEqual(["", "One minute left.", "Ten seconds left."]);
});

it("the clock stands still while the line is down, and goes on with the next motion", async () => {
  await begun();
  await vi.advanceTimersByTimeAsync(5_000);
  await drag(0, 0.1);
  asked[1]!.refuse(new ApiError("offline", "no", null, null, 0));
  await vi.advanceTimersByTimeAsync(30_000);
  expect(place.textContent).toContain("The clock stands still");
  expect(place.querySelector("[role=timer]")!.textContent).toBe("0:55");
  await drag(0, 0.2);
  asked.at(-1)!.answer({});
  await settled();
  asked.at(-1)!.answer({});
  await vi.advanceTimersByTimeAsync(5_000);
  expect(place.textContent).not.toContain("The clock stands still");
  expect(place.querySelector("[role=timer]")!.textContent).toBe("0:50");
  expect(asked.at(-1)!.values["e0"]).toBe(0.2);
});

it("after a reload the clock and the sliders are where they were", async () => {
  form = { answers: { e0: 0.1, e1: 0.5 }, touched: ["e0"], comment: "", trace: { ms: 20_000, path: [[5_000, "e0", 0.1]] } };
  await begun();
  expect(asked[0]!.values).toEqual({ e0: 0.1, e1: 0.5 });
  await vi.advanceTimersByTimeAsync(1_000);
  expect(place.querySelector("[role=timer]")!.textContent).toBe("0:39");
  await drag(1, 0.6);
  expect(form.trace!.path).toEqual([[5_000, "e0", 0.1], [21_000, "e1", 0.6]]);
});

it("a finished match that one comes back to rests, and shows its motion again", async () => {
  form = { answers: { e0: 0.1, e1: 0.5, seconds: 12 }, touched: ["e0"], comment: "" };
  await begun();
  expect(asked[0]!.values).toEqual({ e0: 0.1, e1: 0.5 });
  expect(place.querySelector("fieldset")!.disabled).toBe(true);
  await vi.advanceTimersByTimeAsync(120_000);
  expect(form.answers["seconds"]).toBe(12);
  expect(place.textContent).toContain("It took 12 s.");
});

it("a guess asks for no motion", async () => {
  seen = false;
  draw();
  await settled();
  await vi.advanceTimersByTimeAsync(3_000);
  await drag(0, 0.1);
  expect(asked).toEqual([]);
  expect(form.answers).toEqual({ e0: 0.1, e1: 0.5, seconds: 3 });
  await drag(0, 0.2);
  expect(form.answers["e0"]).toBe(0.2);
});

it("while the answer before is on its way the page asks again, and says nothing", async () => {
  draw();
  await settled();
  asked[0]!.refuse(new ApiError("too_early", "An earlier step has no answer yet.", null, null, 409));
  await vi.advanceTimersByTimeAsync(300);
  expect(place.querySelector("[role=alert], .note")).toBeNull();
  asked[1]!.answer({});
  await settled();
  expect(place.querySelector("fieldset")!.disabled).toBe(false);
});

it("a refusal is told with a way on", async () => {
  await begun();
  await soon();
  await drag(0, 0.1);
  asked[1]!.refuse(new ApiError("session_ended", "The study has ended for you.", null, "Load the page again.", 409));
  await settled();
  expect(place.querySelector("[role=alert]")!.textContent).toContain("The study has ended for you.");
  place.querySelector<HTMLButtonElement>("[role=alert] button")!.click();
  await soon();
  asked[2]!.answer({});
  await settled();
  expect(place.querySelector("[role=alert]")).toBeNull();
});
