/** Fetches motions and figures, each address once a page. */
import { readBody, type Body } from "./body";
import { readClip, type MotionClip } from "./clip";
import { parseGlb, type Glb } from "./glb";

export type Progress = (loaded: number, total: number) => void;

const files = new Map<string, Promise<Glb>>();
const clips = new Map<string, Promise<MotionClip>>();
const bodies = new Map<string, Promise<Body>>();

export function loadClip(url: string, progress?: Progress): Promise<MotionClip> {
  return remember(clips, url, () => loadFile(url, progress).then(readClip));
}

export function loadBody(url: string, progress?: Progress): Promise<Body> {
  return remember(bodies, url, () => loadFile(url, progress).then(readBody));
}

function loadFile(url: string, progress?: Progress): Promise<Glb> {
  return remember(files, url, () => fetchBytes(url, progress).then(parseGlb));
}

/** A failure is forgotten, so that the next try asks the server again. */
function remember<T>(
  cache: Map<string, Promise<T>>,
  url: string,
  load: () => Promise<T>,
): Promise<T> {
  const known = cache.get(url);
  if (known) return known;
  const fresh = load();
  cache.set(url, fresh);
  fresh.catch(() => cache.delete(url));
  return fresh;
}

async function fetchBytes(url: string, progress?: Progress): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The motion could not be fetched (${response.status}).`);
  const total = Number(response.headers.get("content-length") ?? 0);
  if (!progress || !total || !response.body || response.headers.has("content-encoding")) {
    return response.arrayBuffer();
  }
  const bytes = new Uint8Array(total);
  let loaded = 0;
  const reader = response.body.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    if (loaded + part.value.length > total) throw new Error("The motion is longer than announced.");
    bytes.set(part.value, loaded);
    loaded += part.value.length;
    progress(loaded, total);
  }
  if (loaded < total) throw new Error("The motion arrived incomplete.");
  return bytes.buffer;
}
