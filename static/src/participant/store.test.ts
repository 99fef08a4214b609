import { expect, it } from "vitest";
import { fingerprint, Store } from "./store";
import { DeviceStorage } from "./testing";

it("names a session by a fingerprint, never by its link", () => {
  const device = new DeviceStorage();
  new Store("secret-link", device).set("place", 3);
  expect(device.key(0)).not.toContain("secret-link");
});

it("computes the published FNV-1a hashes", () => {
  expect(fingerprint("")).toBe("cbf29ce484222325");
  expect(fingerprint("a")).toBe("af63dc4c8601ec8c");
  expect(fingerprint("foobar")).toBe("85944171f73967e8");
});

it("gives back what was set, across pages, until it is cleared", () => {
  const device = new DeviceStorage();
  new Store("a", device).set("draft/1", { steps: [1, 2] });
  new Store("b", device).set("draft/1", "other");
  const store = new Store("a", device);
  expect(store.get("draft/1")).toEqual({ steps: [1, 2] });
  store.clear();
  expect(store.keys()).toEqual([]);
  expect(new Store("b", device).get("draft/1")).toBe("other");
});

it("takes a value that is no JSON for none", () => {
  const device = new DeviceStorage();
  device.setItem(`manner/${fingerprint("a")}/place`, "{half");
  expect(new Store("a", device).get("place")).toBeNull();
});
