import { describe, expect, it } from "vitest";
import { Outbox } from "../outbox";
import { set, type Form } from "../trials/kind";
import { NOTHING_YET } from "./clock";
import { Course, type GivenAnswer, type Session } from "./course";
import { UNWATCHED } from "./measures";
import { Store } from "./store";
import { DeviceStorage } from "./testing";

const measures = { rt_ms: 1, time_elapsed_ms: 1, client_time: "2026-01-01T00:00:00Z", record: {} };

const scale = { id: "sad_happy", left: "sad", right: "happy" };
const TRIAL = { kind: "semantic_differential", scales: [scale], steps: ["very", "rather", "neither", "rather", "very"], preselected: true };
const SLIDER = { kind: "analogue", scales: [scale] };

function session(responses: Session["responses"] = {}, back = true): Session {
  const figures = [{ glb_url: "/clip", figure_url: null, cyclic: true }];
  return {
    study: { title: "", language: "en", languages: [], back, preview: false },
    state: "active",
    parts: { walks: TRIAL, pause: { kind: "break", heading: "", text: "" }, sliders: SLIDER },
    steps: [
      { index: 0, part: "walks", kind: "semantic_differential", figures },
      { index: 1, part: "pause", kind: "break", figures: [] },
      { index: 2, part: "walks", kind: "semantic_differential", figures },
      { index: 3, part: "sliders", kind: "analogue", figures },
    ],
    responses,
    next: Object.keys(responses).length,
  };
}

function open(device = new DeviceStorage(), responses: Session["responses"] = {}, back = true) {
  const store = new Store("token", device);
  const sent: GivenAnswer[] = [];
  const outbox = new Outbox<GivenAnswer>({ store, send: () => new Promise(() => {}) });
  const put = outbox.put.bind(outbox);
  outbox.put = (answer) => { sent.push(answer); put(answer); };
  return { course: new Course(session(responses, back), store, outbox), sent, device };
}

const said = (form: Form, value: number) => set(form, "sad_happy", value);

describe("a person", () => {
  it("goes from the first trial to the end", () => {
    const { course, sent } = open();
    while (!course.finished) course.answer(said(course.draft().form, 1), measures);
    expect(sent.map(({ trial_index, revision }) => [trial_index, revision])).toEqual([[0, 1], [1, 1], [2, 1], [3, 1]]);
  });

  it("comes back to the same trial after a reload, with answers that have not gone out yet", () => {
    const { course, device } = open();
    course.answer(said(course.draft().form, 1), measures);
    expect(open(device).course.index).toBe(1);
  });

  it("comes back on another device where the server says", () => {
    const stored = { revision: 1, answers: { sad_happy: 2 }, touched: ["sad_happy"], comment: "" };
    expect(open(new DeviceStorage(), { 0: stored, 1: stored }).course.index).toBe(2);
  });

  it("finds the half-filled trial again, also after having gone back from it", () => {
    const { course, device } = open();
    course.answer(said(course.draft().form, 1), measures);
    course.keepDraft({ form: said(course.draft().form, -2), attention: NOTHING_YET, viewing: UNWATCHED, figures: [], start: {} });
    course.goTo(0);
    const again = open(device).course;
    expect(again.index).toBe(0);
    again.goTo(1);
    expect(again.draft().form).toMatchObject({ answers: { sad_happy: -2 }, touched: ["sad_happy"] });
  });

  it("makes a new revision by changing an answer, and none by only looking", () => {
    const { course, sent } = open();
    course.answer(said(course.draft().form, 1), measures);
    course.goTo(0);
    course.answer(course.draft().form, measures);
    expect(sent).toHaveLength(1);
    course.goTo(0);
    course.answer(said(course.draft().form, -1), measures);
    expect(sent[1]).toMatchObject({ trial_index: 0, revision: 2, answers: { sad_happy: -1 } });
    expect(course.index).toBe(1);
  });

  it("is led back to what the server lacks", () => {
    const { course } = open();
    while (!course.finished) course.answer(said(course.draft().form, 1), measures);
    course.reopen([2]);
    expect(course.index).toBe(2);
  });

  it("cannot be put beyond the first open trial by an old note on the device", () => {
    const device = new DeviceStorage();
    new Store("token", device).set("place", { index: 3, answered: 0 });
    expect(open(device).course.index).toBe(0);
  });

  it("reads pages between the trials, which do not count", () => {
    const { course, sent } = open();
    expect([course.trial, course.trials]).toEqual([1, 3]);
    course.answer(said(course.draft().form, 1), measures);
    course.answer(course.draft().form, measures);
    expect(sent[1]).toMatchObject({ trial_index: 1, answers: {}, touched: [] });
    expect([course.index, course.trial]).toEqual([2, 2]);
  });

  it("looking at a draft begins at the part that is being edited", () => {
    const view = session();
    const looking = { ...view, next: 3, study: { ...view.study, preview: true } };
    const store = new Store("preview", null);
    const outbox = new Outbox<GivenAnswer>({ store, send: () => Promise.resolve() });
    expect(new Course(looking, store, outbox).index).toBe(3);
  });

  it("can go back only where the study lets it", () => {
    const { course } = open();
    expect(course.before).toBeNull();
    course.answer(said(course.draft().form, 1), measures);
    expect(course.before).toBe(0);
    const onward = open(new DeviceStorage(), {}, false).course;
    onward.answer(said(onward.draft().form, 1), measures);
    expect(onward.before).toBeNull();
  });

  it("coming back to a slider sees a position before touching it, and that is noted", () => {
    const { course } = open();
    while (course.index < 3) course.answer(said(course.draft().form, 1), measures);
    expect(course.draft().start).toEqual({});
    course.answer(said(course.draft().form, 63), measures);
    course.goTo(3);
    expect(course.draft().start).toEqual({ sad_happy: 63 });
    course.goTo(0);
    expect(course.draft().start).toEqual({});
  });
});
