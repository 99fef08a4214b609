import { describe, expect, it } from "vitest";
import { readClip } from "./clip";
import { GlbError, parseGlb } from "./glb";

/** A file of one joint that turns a quarter about y, with 16-bit rotations as Manner writes them. */
function turningJoint(cut = 0): ArrayBuffer {
  const quarter = Math.round(Math.SQRT1_2 * 32767);
  const binary = new ArrayBuffer(8 + 24 + 16);
  new Float32Array(binary, 0, 2).set([0, 0.5]);
  new Float32Array(binary, 8, 6).set([0, 1, 0, 0, 1, 2]);
  new Int16Array(binary, 32, 8).set([0, 0, 0, 32767, 0, quarter, 0, quarter]);
  const json = {
    asset: { version: "2.0", extras: { manner: { frame_time: 0.5, frames: 2, cyclic: false, names: ["hips"] } } },
    nodes: [{ name: "hips" }],
    animations: [{
      channels: [
        { sampler: 0, target: { node: 0, path: "translation" } },
        { sampler: 1, target: { node: 0, path: "rotation" } },
      ],
      samplers: [{ input: 0, output: 1 }, { input: 0, output: 2 }],
    }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 2, type: "SCALAR" },
      { bufferView: 0, byteOffset: 8, componentType: 5126, count: 2, type: "VEC3" },
      { bufferView: 1, componentType: 5122, normalized: true, count: 2, type: "VEC4" },
    ],
    bufferViews: [{ byteLength: 32 }, { byteOffset: 32, byteLength: 16 }],
  };
  return pack(json, binary).slice(0, cut || undefined);
}

function pack(json: object, binary: ArrayBuffer): ArrayBuffer {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const padded = Math.ceil(text.length / 4) * 4;
  const file = new ArrayBuffer(12 + 8 + padded + 8 + binary.byteLength);
  const view = new DataView(file);
  [0x46546c67, 2, file.byteLength, padded, 0x4e4f534a].forEach((v, k) => view.setUint32(4 * k, v, true));
  new Uint8Array(file, 20, padded).fill(32).set(text);
  view.setUint32(20 + padded, binary.byteLength, true);
  view.setUint32(24 + padded, 0x004e4942, true);
  new Uint8Array(file, 28 + padded).set(new Uint8Array(binary));
  return file;
}

describe("a GLB file", () => {
  it("gives its motion with rotations spread over −1…1", () => {
    const clip = readClip(parseGlb(turningJoint()));
    const pose = clip.makePose();
    clip.sample(0.5, pose);
    expect([clip.names, clip.frames, clip.duration]).toEqual([["hips"], 2, 0.5]);
    expect(pose.rotations[1]).toBeCloseTo(Math.SQRT1_2, 4);
    expect([...pose.root]).toEqual([0, 1, 2]);
  });

  it("is refused in words when it is something else or cut short", () => {
    expect(() => parseGlb(new TextEncoder().encode("HIERARCHY and more text").buffer as ArrayBuffer)).toThrow(GlbError);
    expect(() => parseGlb(turningJoint(200))).toThrow("cut short");
  });

  it("is refused when it holds no motion", () => {
    expect(() => readClip(parseGlb(pack({ asset: { version: "2.0" } }, new ArrayBuffer(4))))).toThrow("no motion");
  });
});
