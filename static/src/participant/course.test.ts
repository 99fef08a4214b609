import { describe, expect, it } from "vitest";
import { Outbox } from "../outbox";
import { choose, type Form } from "../trials/semantic_differential";
import { NOTHING_YET } from "./clock";
import { Course, UNWATCHED, type GivenAnswer, type Session } from "./course";
import { Store } from "./store";
import { DeviceStorage } from "./testing";

const measures = { rt_ms: 1, time_elapsed_ms: 1, client_time: "2026-01-01T00:00:00Z", record: {} };

function session(responses: Session["responses"] = {}): Session {
  return {
    study: {
      title: "", question: "", hint: "", comment_label: "", comment_placeholder: "",
      scales: [{ id: "sad_happy", left: "sad", right: "happy" }],
      steps: ["very", "rather", "neither", "rather", "very"],
    },
    state: "active",
    trials: [0, 1, 2, 3].map((index) => ({ index, glb_url: `/${index}`, figure_url: null, cyclic: true })),
    responses,
    next: Object.keys(responses).length,
  };
}

function open(device = new DeviceStorage(), responses: Session["responses"] = {}) {
  const store = new Store("token", device);
  const sent: GivenAnswer[] = [];
  const outbox = new Outbox<GivenAnswer>({ store, send: () => new Promise(() => {}) });
  const put = outbox.put.bind(outbox);
  outbox.put = (answer) => { sent.push(answer); put(answer); };
  return { course: new Course(session(responses), store, outbox), sent, device };
}

const said = (form: Form, value: number) => choose(form, "sad_happy", value);

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
    course.keepDraft({ form: said(course.draft().form, -2), attention: NOTHING_YET, viewing: UNWATCHED });
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
    new Store("token", device).set("place", 3);
    expect(open(device).course.index).toBe(0);
  });
});
