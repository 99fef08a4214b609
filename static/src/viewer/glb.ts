/** Reads binary glTF 2.0: exactly the parts that Manner's own files use, and nothing else. */

export interface GlbNode {
  name?: string;
  children?: number[];
  translation?: [number, number, number];
  rotation?: [number, number, number, number];
  mesh?: number;
  skin?: number;
}

interface GlbAccessor {
  bufferView: number;
  byteOffset?: number;
  componentType: number;
  normalized?: boolean;
  count: number;
  type: string;
}

interface GlbJson {
  asset: { version: string; extras?: Record<string, unknown> };
  extras?: Record<string, unknown>;
  scene?: number;
  scenes?: { nodes?: number[]; extras?: Record<string, unknown> }[];
  nodes?: GlbNode[];
  meshes?: { primitives: { attributes: Record<string, number>; indices?: number }[] }[];
  skins?: { joints: number[]; inverseBindMatrices: number }[];
  animations?: {
    channels: { sampler: number; target: { node: number; path: string } }[];
    samplers: { input: number; output: number }[];
  }[];
  accessors?: GlbAccessor[];
  bufferViews?: { byteOffset?: number; byteLength: number; byteStride?: number }[];
}

export type Numbers =
  | Float32Array
  | Int8Array
  | Uint8Array
  | Int16Array
  | Uint16Array
  | Uint32Array;

export interface Accessor {
  array: Numbers;
  itemSize: number;
  count: number;
  normalized: boolean;
}

const GLB_MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;
const ITEM_SIZES: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const COMPONENTS = {
  5120: { make: Int8Array, scale: 127 },
  5121: { make: Uint8Array, scale: 255 },
  5122: { make: Int16Array, scale: 32767 },
  5123: { make: Uint16Array, scale: 65535 },
  5125: { make: Uint32Array, scale: 1 },
  5126: { make: Float32Array, scale: 1 },
} as const;

export class GlbError extends Error {}

export class Glb {
  constructor(
    readonly json: GlbJson,
    private readonly binary: ArrayBuffer,
    private readonly start: number,
  ) {}

  get nodes(): GlbNode[] {
    return this.json.nodes ?? [];
  }

  /** What Manner wrote beside the geometry, from whichever place the writer chose. */
  get extras(): Record<string, unknown> {
    const scene = this.json.scenes?.[this.json.scene ?? 0];
    const holders = [this.json.asset.extras, scene?.extras, this.json.extras];
    const found = holders.find((extras) => extras?.["manner"] !== undefined);
    return (found?.["manner"] ?? {}) as Record<string, unknown>;
  }

  /** Parent of every node, -1 for the tops. */
  parents(): Int16Array {
    const parents = new Int16Array(this.nodes.length).fill(-1);
    this.nodes.forEach((node, index) => node.children?.forEach((child) => (parents[child] = index)));
    return parents;
  }

  /** Numbers of an accessor as stored, tightly packed and never shared with the file. */
  accessor(index: number): Accessor {
    const accessor = this.json.accessors?.[index];
    const view = accessor && this.json.bufferViews?.[accessor.bufferView];
    if (!accessor || !view) throw new GlbError(`Accessor ${index} is missing.`);
    const { make } = COMPONENTS[accessor.componentType as keyof typeof COMPONENTS];
    const itemSize = ITEM_SIZES[accessor.type] ?? 1;
    const size = make.BYTES_PER_ELEMENT;
    const stride = view.byteStride ?? itemSize * size;
    const first = this.start + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    const array = new make(accessor.count * itemSize) as Numbers;
    const width = itemSize * size;
    const target = new Uint8Array(array.buffer);
    const step = stride === width ? accessor.count : 1;
    for (let item = 0; item < accessor.count; item += step) {
      const source = new Uint8Array(this.binary, first + item * stride, step * width);
      target.set(source, item * width);
    }
    const normalized = accessor.normalized ?? false;
    return { array, itemSize, count: accessor.count, normalized };
  }

  /** The same as plain numbers, normalised integers spread over −1…1. */
  floats(index: number): Float32Array {
    const { array, normalized } = this.accessor(index);
    if (!normalized) return Float32Array.from(array);
    const type = this.json.accessors![index]!.componentType as keyof typeof COMPONENTS;
    const { scale } = COMPONENTS[type];
    const values = new Float32Array(array.length);
    for (let k = 0; k < values.length; k += 1) values[k] = Math.max(array[k]! / scale, -1);
    return values;
  }
}

/** Opens a GLB file. Throws GlbError when it is something else or cut short. */
export function parseGlb(data: ArrayBuffer): Glb {
  const view = new DataView(data);
  if (data.byteLength < 20 || view.getUint32(0, true) !== GLB_MAGIC) {
    throw new GlbError("This is not a GLB file.");
  }
  if (view.getUint32(8, true) > data.byteLength) throw new GlbError("The GLB file is cut short.");
  let json: GlbJson | undefined;
  let start = 0;
  for (let at = 12; at + 8 <= data.byteLength; ) {
    const length = view.getUint32(at, true);
    const kind = view.getUint32(at + 4, true);
    if (kind === JSON_CHUNK) {
      json = JSON.parse(new TextDecoder().decode(new Uint8Array(data, at + 8, length))) as GlbJson;
    } else if (kind === BINARY_CHUNK) start = at + 8;
    at += 8 + length;
  }
  if (!json) throw new GlbError("The GLB file has no description of its contents.");
  return new Glb(json, data, start);
}
