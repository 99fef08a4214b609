/** Whether this browser can draw in three dimensions at all. */

let known: boolean | undefined;

export function hasWebGL(): boolean {
  known ??= probe();
  return known;
}

function probe(): boolean {
  try {
    const context = document.createElement("canvas").getContext("webgl2");
    // The probe's context is given back at once: browsers allow only a few.
    context?.getExtension("WEBGL_lose_context")?.loseContext();
    return context !== null;
  } catch {
    return false;
  }
}
