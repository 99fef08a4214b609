import { render } from "lit";
import { beforeEach, describe, expect, it } from "vitest";
import { empty, set, type Change, type Form, type Step } from "../../trials/kind";
import { seeded } from "../testing";
import { pages } from ".";
import { faultOf, toggled, typed, type Field } from "./form_fields";
import { paragraphs } from "./text";

const field = (changes: Partial<Field>): Field => ({ id: "f", label: "F?", type: "text", required: true, options: [], ...changes });
const options = ["one", "two", "three"].map((id) => ({ id, label: id }));
const FIELDS = [
  field({ id: "age", type: "number", minimum: 18, maximum: 99 }),
  field({ id: "hand", type: "choice", options }),
  field({ id: "uses", type: "choices", options }),
  field({ id: "town" }),
  field({ id: "more", type: "long_text", required: false }),
];
const step: Step = { index: 0, part: "p", kind: "form", figures: [] };
const asked = { task: { heading: "You", text: null, fields: FIELDS }, step };

let place: HTMLElement;
let form: Form;
beforeEach(() => {
  place = document.createElement("div");
  document.body.replaceChildren(place);
  form = empty();
});

function draw(pressed = false): void {
  const change: Change = (act) => { form = act(form); draw(pressed); };
  render(pages["form"]!.panel({ ...asked, form, change, pressed }), place);
}

describe("a form", () => {
  it("says nothing about what is missing before the person wants to go on, and then everything", () => {
    draw();
    expect(document.querySelectorAll(".field-error")).toHaveLength(0);
    draw(true);
    expect([...document.querySelectorAll(".field-error")].map(({ id }) => id)).toEqual(["error-age", "error-hand", "error-uses", "error-town"]);
    expect(document.querySelector("#box-town")?.getAttribute("aria-describedby")).toBe("error-town");
  });

  it("is filled in by hand until it is complete", () => {
    draw();
    const write = (id: string, text: string) => {
      const input = document.querySelector<HTMLInputElement>(`#box-${id}`)!;
      input.value = text;
      input.dispatchEvent(new Event("input"));
    };
    write("age", "31");
    write("town", "Turku");
    document.querySelector<HTMLInputElement>('[name="hand"][value="two"]')!.click();
    document.querySelector<HTMLInputElement>('[name="uses"][value="three"]')!.click();
    document.querySelector<HTMLInputElement>('[name="uses"][value="one"]')!.click();
    expect(form.answers).toEqual({ age: 31, town: "Turku", hand: "two", uses: ["one", "three"] });
    expect(pages["form"]!.isComplete(asked, form)).toBe(true);
  });

  it("made up, is complete", () => {
    const random = seeded(2);
    for (let person = 0; person < 50; person++) {
      expect(pages["form"]!.isComplete(asked, pages["form"]!.simulate(asked, random))).toBe(true);
    }
  });
});

describe("a field for a number", () => {
  const age = field({ type: "number", minimum: 18, maximum: 99 });

  it("takes a comma and a point, and keeps what is no number to say so", () => {
    expect(typed(age, " 3,5 ", empty()).answers).toEqual({ f: 3.5 });
    expect(typed(age, "3.5", empty()).answers).toEqual({ f: 3.5 });
    expect(faultOf(age, typed(age, "old", empty()))).toBe("Please write a number.");
  });

  it("tells its limits", () => {
    const at = (value: number) => faultOf(age, set(empty(), "f", value));
    expect([17, 18, 99].map(at)).toEqual(["Please write a number from 18 to 99.", null, null]);
    expect(faultOf(field({ type: "number", maximum: 9 }), set(empty(), "f", 10))).toBe("Please write a number up to 9.");
    expect(faultOf(field({ type: "number", minimum: 9 }), set(empty(), "f", 8))).toBe("Please write a number from 9 on.");
    // Without a limit of the study, the server's.
    expect(faultOf(field({ type: "number" }), set(empty(), "f", 1e12))).toBeNull();
    expect(faultOf(field({ type: "number" }), set(empty(), "f", 1e13))).toMatch(/^Please write a number from .*1.*000 to/);
    expect(faultOf(field({ type: "number", minimum: 9 }), set(empty(), "f", 1e13))).toMatch(/^Please write a number from 9 to/);
  });
});

it("a field that is emptied again has no answer", () => {
  expect(typed(field({}), "  ", set(empty(), "f", "x"))).toEqual(empty());
  const choices = field({ type: "choices", options });
  expect(toggled(choices, "two", set(empty(), "f", ["two"]))).toEqual(empty());
  expect(faultOf(field({ required: false }), empty())).toBeNull();
});

it("an empty line parts two paragraphs", () => {
  expect(paragraphs("One.\nStill one.\n\n  \nTwo.\n")).toHaveLength(2);
  expect(paragraphs(null)).toEqual([]);
});

it("a page to read hands in nothing", () => {
  for (const kind of ["instructions", "break", "debriefing"]) {
    expect(pages[kind]!.blank(asked)).toEqual(empty());
    expect(pages[kind]!.isComplete(asked, empty())).toBe(true);
  }
});
