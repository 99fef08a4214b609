import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { api, ApiError } from "../api";
import type { ListedSpace } from "./server";
import type { SpaceRemoval } from "./space_removal";
import "./space_removal";

const space = (number: number, may_delete = true): ListedSpace => ({
  id: `id${number}`, name: "Walks", number, newest: number === 2, examples: 3, interfaces: ["weights"], simulated: false,
  study: null, study_title: null, may_delete, made_by: "Ada", created_at: "2026-11-22T12:00:00Z",
});

let removal: SpaceRemoval;
beforeEach(() => {
  HTMLDialogElement.prototype.showModal = function () { this.open = true; };
  HTMLDialogElement.prototype.close = function () { this.open = false; this.dispatchEvent(new Event("close")); };
  removal = document.createElement("space-removal");
  document.body.append(removal);
});
afterEach(() => {
  document.body.replaceChildren();
  vi.restoreAllMocks();
});

const submit = async () => {
  removal.querySelector("form")!.dispatchEvent(new SubmitEvent("submit", { cancelable: true }));
  await vi.waitFor(() => expect(removal.querySelector("[disabled]")).toBeNull());
};

test("one version goes, or all of them where all may", async () => {
  const gone = vi.spyOn(api, "delete").mockResolvedValue(undefined);
  const told: string[] = [];
  removal.addEventListener("removed", (event) => told.push((event as CustomEvent<string>).detail));
  await removal.ask(space(2), [space(2), space(1, false)]);
  expect(removal.querySelector("h2")!.textContent).toBe("Delete “Walks”, version 2");
  expect(removal.querySelectorAll("input")).toHaveLength(0);
  await submit();
  await removal.ask(space(2), [space(2), space(1)]);
  const all = removal.querySelectorAll("input")[1]!;
  all.checked = true;
  all.dispatchEvent(new Event("change"));
  await removal.updateComplete;
  await submit();
  expect(gone.mock.calls).toEqual([
    ["/api/v1/spaces/id2", { query: { versions: "one" } }],
    ["/api/v1/spaces/id2", { query: { versions: "all" } }],
  ]);
  expect(told).toEqual(["“Walks”, version 2, is deleted.", "All versions of “Walks” are deleted."]);
});

test("why it stays is told where it was asked", async () => {
  vi.spyOn(api, "delete").mockRejectedValue(new ApiError("space_in_use", "The study needs it.", null, "Take it out first.", 409));
  await removal.ask(space(1), [space(1)]);
  await submit();
  await vi.waitFor(() => expect(removal.querySelector("[role=alert]")?.textContent).toContain("Take it out first."));
  expect(removal.querySelector("dialog")!.open).toBe(true);
});

declare global {
  interface HTMLElementTagNameMap {
    "space-removal": SpaceRemoval;
  }
}
