import { beforeEach, describe, expect, it, vi } from "vitest";
import { api } from "../api";
import { act, participantActs } from "./acts";
import { exchange } from "./now";
import { sightAt } from "./replay";

function fragment(html: string): DocumentFragment {
  const found = document.createElement("template");
  found.innerHTML = html;
  return found.content;
}

describe("the live page's pieces", () => {
  let place: HTMLElement;
  beforeEach(() => {
    document.body.innerHTML = `<div id="now"><p data-live="a">1</p><p data-live="b"><button>look</button></p></div>`;
    place = document.getElementById("now")!;
  });

  it("exchanges what differs and leaves the rest where it is", () => {
    const kept = place.querySelector("button")!;
    const changed = exchange(place, fragment(`<p data-live="a">2</p><p data-live="b"><button>look</button></p>`));
    expect(changed).toBe(true);
    expect(place.textContent).toBe("2look");
    expect(place.querySelector("button")).toBe(kept);
  });

  it("says that nothing changed where nothing did", () => {
    const changed = exchange(place, fragment(`<p data-live="a">1</p><p data-live="b"><button>look</button></p>`));
    expect(changed).toBe(false);
  });

  it("never takes a piece away from under the keyboard's focus", () => {
    const kept = place.querySelector("button")!;
    kept.focus();
    exchange(place, fragment(`<p data-live="a">1</p><p data-live="b"><button>gone</button></p>`));
    expect(document.activeElement).toBe(kept);
  });

  it("takes all anew when a piece comes or goes", () => {
    exchange(place, fragment(`<p data-live="a">1</p>`));
    expect(place.querySelectorAll("[data-live]").length).toBe(1);
  });
});

describe("what is done with a participant", () => {
  beforeEach(() => {
    document.body.innerHTML = `<div data-api="/api/v1/studies/walks">
      <button data-act="exclude" data-session="s1" data-name="aa">Leave out</button>
      <button data-act="include" data-session="s1" data-name="aa">Count again</button>
      <button data-act="delete" data-session="s1" data-name="aa" data-home="/live">Delete</button></div>
      <dialog id="why"><form><h2></h2><p data-explained></p><div data-reason><textarea></textarea></div>
      <p data-failure hidden></p><button data-do></button><button type="button" data-cancel></button></form></dialog>`;
    HTMLDialogElement.prototype.showModal = function (this: HTMLDialogElement) { this.open = true; };
    HTMLDialogElement.prototype.close = function (this: HTMLDialogElement) { this.open = false; };
  });

  it("asks why before leaving somebody out, and sends the reason", async () => {
    const post = vi.spyOn(api, "post").mockResolvedValue(undefined);
    const done = vi.fn();
    participantActs(document, done);
    document.querySelector<HTMLElement>("[data-act=exclude]")!.click();
    expect(document.querySelector("h2")!.textContent).toBe("Leave participant aa out");
    expect(post).not.toHaveBeenCalled();
    document.querySelector("textarea")!.value = " answered at random ";
    document.querySelector("form")!.dispatchEvent(new Event("submit", { cancelable: true }));
    await vi.waitFor(() => expect(done).toHaveBeenCalledWith(null));
    expect(post).toHaveBeenCalledWith("/api/v1/studies/walks/sessions/s1/exclude", { reason: "answered at random" });
    expect(document.querySelector("dialog")!.open).toBe(false);
  });

  it("counts somebody again at once", async () => {
    const post = vi.spyOn(api, "post").mockResolvedValue(undefined);
    await act(document.querySelector<HTMLElement>("[data-act=include]")!, null);
    expect(post).toHaveBeenLastCalledWith("/api/v1/studies/walks/sessions/s1/include", undefined);
  });

  it("deletes by the address of the participant alone", async () => {
    const gone = vi.spyOn(api, "delete").mockResolvedValue(undefined);
    await act(document.querySelector<HTMLElement>("[data-act=delete]")!, null);
    expect(gone).toHaveBeenCalledWith("/api/v1/studies/walks/sessions/s1");
  });
});

describe("the view of then", () => {
  const way: [number, number, number, number][] = [[0, 170, 7, 1], [100, -170, 17, 2]];

  it("lies between its points, the shorter way around", () => {
    expect(sightAt(way, 50)).toEqual([50, 180, 12, 1.5]);
  });

  it("begins with the first point and stays at the last", () => {
    expect(sightAt(way, -5)).toEqual(way[0]);
    expect(sightAt(way, 5000)).toEqual(way[1]);
  });
});
