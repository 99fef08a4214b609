/** Whether this browser can draw in three dimensions at all, and whether a graphics card helps it. */

interface Support {
  webgl: boolean;
  software: boolean;
}

let known: Support | undefined;

export function hasWebGL(): boolean {
  return (known ??= probe()).webgl;
}

/** The processor does the graphics card's work: rich shading would cost the motion its pace. */
export function drawsInSoftware(): boolean {
  return (known ??= probe()).software;
}

function probe(): Support {
  try {
    const context = document.createElement("canvas").getContext("webgl2");
    if (!context) return { webgl: false, software: false };
    const info = context.getExtension("WEBGL_debug_renderer_info");
    const name = String(context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER));
    // The probe's context is given back at once: browsers allow only a few.
    context.getExtension("WEBGL_lose_context")?.loseContext();
    return { webgl: true, software: /swiftshader|llvmpipe|softpipe|basic render/i.test(name) };
  } catch {
    return { webgl: false, software: false };
  }
}
