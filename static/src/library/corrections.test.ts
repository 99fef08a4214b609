import { expect, test } from "vitest";
import { changed } from "./corrections";
import type { Report } from "./model";

const report = {
  unit: 0.01, unit_name: "centimetres", up_axis: "y", missing_roles: ["neck"],
  roles: { hips: "Hips", head: "Head" }, joint_names: ["Hips", "Neck", "Head"],
} as unknown as Report;

function filled(values: Record<string, string>): FormData {
  const form = new FormData();
  const all = { unit: "0.01", up_axis: "y", "role:hips": "Hips", "role:head": "Head", "role:neck": "", ...values };
  for (const [name, value] of Object.entries(all)) form.set(name, value);
  return form;
}

test("a form that was left as it is asks for nothing", () => {
  expect(changed(report, filled({}))).toEqual({});
});

test("only what differs is sent", () => {
  expect(changed(report, filled({ unit: "1" }))).toEqual({ unit: 1 });
  expect(changed(report, filled({ up_axis: "-z" }))).toEqual({ up_axis: "-z" });
});

test("a role is moved or, by an empty joint, taken away; the others are left to be found", () => {
  expect(changed(report, filled({ "role:neck": "Neck", "role:head": "" }))).toEqual({
    roles: { neck: "Neck", head: "" },
  });
});

test("roles that were corrected before go along with the new ones", () => {
  const again = { ...report, options: { roles: { hips: "Hips" } } } as unknown as Report;
  expect(changed(again, filled({ "role:neck": "Neck" }))).toEqual({ roles: { hips: "Hips", neck: "Neck" } });
});
