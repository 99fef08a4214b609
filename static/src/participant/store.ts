// What this device keeps for one participant: waiting answers, drafts, the place in the study.

/** The part of `Storage` that is needed here, so that tests can bring their own. */
export type Storage = Pick<globalThis.Storage, "getItem" | "setItem" | "removeItem" | "key" | "length">;

/**
 * A session's own corner of the device's storage. Every value lies under its own key, so that two tabs never write
 * over one another. Where storage is blocked or full, the memory of the page takes over.
 */
export class Store {
  readonly #prefix: string;
  readonly #storage: Storage | null;
  readonly #memory = new Map<string, string>();

  constructor(token: string, storage: Storage | null = deviceStorage()) {
    this.#prefix = `manner/${fingerprint(token)}/`;
    this.#storage = storage;
  }

  get<T>(key: string): T | null {
    const text = this.#memory.get(key) ?? this.#storage?.getItem(this.#prefix + key) ?? null;
    try {
      return text === null ? null : (JSON.parse(text) as T);
    } catch {
      return null; // half a value, written by something else: as good as none
    }
  }

  set(key: string, value: unknown): void {
    const text = JSON.stringify(value);
    try {
      if (!this.#storage) throw new TypeError("no storage");
      this.#storage.setItem(this.#prefix + key, text);
      this.#memory.delete(key);
    } catch {
      this.#memory.set(key, text);
    }
  }

  remove(key: string): void {
    this.#memory.delete(key);
    this.#storage?.removeItem(this.#prefix + key);
  }

  /** The keys that begin with `start`, in order. */
  keys(start = ""): string[] {
    const found = [...this.#memory.keys()];
    for (let index = 0; index < (this.#storage?.length ?? 0); index++) {
      const key = this.#storage?.key(index);
      if (key?.startsWith(this.#prefix)) found.push(key.slice(this.#prefix.length));
    }
    return [...new Set(found)].filter((key) => key.startsWith(start)).sort();
  }

  clear(): void {
    for (const key of this.keys()) this.remove(key);
  }
}

/** A session's link opens it, so the device's storage names it by a fingerprint only (FNV-1a, 64 bits). */
export function fingerprint(token: string): string {
  let hash = 0xcbf29ce484222325n;
  for (const byte of new TextEncoder().encode(token)) {
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  }
  return hash.toString(16).padStart(16, "0");
}

function deviceStorage(): Storage | null {
  try {
    return globalThis.localStorage;
  } catch {
    return null; // blocked by the browser's settings
  }
}
