import { afterEach, beforeAll, expect, test, vi } from "vitest";
import type { Finding } from "./checks";
import type { TimeStrip } from "./time_strip";

const slip: Finding = { kind: "foot slip", part: "left foot", start: 4.9, end: 5, size: 0.007, unit: "m", limit: 0.005 };

beforeAll(async () => {
  vi.stubGlobal("ResizeObserver", class { observe() {} disconnect() {} });
  await import("./time_strip");
});

afterEach(() => document.body.replaceChildren());

async function strip(): Promise<TimeStrip> {
  const element = document.createElement("time-strip");
  Object.assign(element, {
    duration: 8, frames: 241, time: 4, findings: [slip],
    contacts: { left: [[0, 2], [4, 6]], right: [[2, 4]] },
  });
  document.body.append(element);
  await element.updateComplete;
  return element;
}

function heard(element: TimeStrip, name: string): unknown[] {
  const details: unknown[] = [];
  element.addEventListener(name, (event) => details.push((event as CustomEvent).detail));
  return details;
}

test("the current time is a slider that says its value in words", async () => {
  const slider = (await strip()).querySelector("[role=slider]")!;
  expect(slider.getAttribute("aria-valuetext")).toBe("4.00 of 8.00 seconds, frame 121");
  expect((slider as HTMLElement).style.left).toBe("50%");
});

test("each foot's stands are bars, and said in words", async () => {
  const [left, right] = (await strip()).querySelectorAll<HTMLElement>(".strip-foot");
  expect([...left!.children].map((bar) => (bar as HTMLElement).style.cssText)).toEqual(["left: 0%; width: 25%;", "left: 50%; width: 25%;"]);
  expect(right!.getAttribute("aria-label")).toBe("The right foot stands from 2.0 to 4.0 seconds");
});

test("a key on the slider seeks", async () => {
  const element = await strip();
  const sought = heard(element, "seek");
  element.querySelector("[role=slider]")!.dispatchEvent(new KeyboardEvent("keydown", { key: "End", cancelable: true }));
  expect(sought).toEqual([{ time: 8 }]);
});

test("a click on a mark seeks to its fault and hands it on", async () => {
  const element = await strip();
  const [sought, found] = [heard(element, "seek"), heard(element, "finding")];
  element.querySelector<HTMLElement>(".strip-mark")!.click();
  expect(sought).toEqual([{ time: expect.closeTo(4.9, 9) }]);
  expect(found).toEqual([{ finding: slip }]);
});

test("I and O choose what is repeated, Escape ends it", async () => {
  const element = await strip();
  const slider = element.querySelector("[role=slider]")!;
  const press = (key: string) => slider.dispatchEvent(new KeyboardEvent("keydown", { key, cancelable: true }));
  press("i");
  expect(element.loop).toEqual({ start: 4, end: 8 });
  press("ArrowRight");
  element.time = 6;
  press("o");
  expect(element.loop).toEqual({ start: 4, end: 6 });
  press("Escape");
  expect(element.loop).toBeNull();
});

test("it says that nothing was found, but not before the checks are known", async () => {
  const element = await strip();
  element.findings = [];
  await element.updateComplete;
  expect(element.textContent).toContain("nothing found");
  element.findings = null;
  await element.updateComplete;
  expect(element.textContent).not.toContain("nothing found");
});
