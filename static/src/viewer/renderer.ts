/** The page's one WebGL context. A lone view shows its canvas; several views get copies of it. */
import { NoToneMapping, Vector4, WebGLRenderer, type Camera, type Scene } from "three";
import { tierChooser } from "./tier";

export const MOST_PIXEL_RATIO = 2;

/** A piece of a surface, in CSS pixels from its upper left corner. */
export interface Area {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** A place on the page where a scene appears. */
export class Surface {
  /** Holds whichever canvas shows the picture now. */
  readonly element = document.createElement("div");
  private readonly copy = document.createElement("canvas");
  private paper: CanvasRenderingContext2D | null = null;
  width = 1;
  height = 1;
  ratio = 1;
  /** Asks the owner to draw again: the picture was lost. */
  onLost: () => void = () => {};

  constructor(private readonly shared: SharedRenderer = sharedRenderer()) {
    this.element.className = "canvas";
    shared.add(this);
  }

  /** Size in CSS pixels. */
  resize(width: number, height: number, ratio: number): void {
    this.width = Math.max(Math.round(width), 1);
    this.height = Math.max(Math.round(height), 1);
    this.ratio = Math.min(ratio, MOST_PIXEL_RATIO);
  }

  get pixelWidth(): number {
    return Math.round(this.width * this.ratio);
  }

  get pixelHeight(): number {
    return Math.round(this.height * this.ratio);
  }

  /** Draws, into a piece of the surface if given; what a run of pieces shares is done with the last. */
  draw(scene: Scene, camera: Camera, area: Area | null = null, last = true): void {
    this.shared.draw(this, scene, camera, area, last);
  }

  /** Shows the shared canvas itself, or (null) the copy. */
  show(canvas: HTMLCanvasElement | null): void {
    const shown = canvas ?? this.copy;
    if (shown.parentNode === this.element) return;
    this.element.replaceChildren(shown);
    this.onLost();
  }

  /** Copies the lower left corner of the shared canvas, which was just drawn. */
  take(source: HTMLCanvasElement): void {
    const { copy, pixelWidth, pixelHeight } = this;
    if (copy.width !== pixelWidth) copy.width = pixelWidth;
    if (copy.height !== pixelHeight) copy.height = pixelHeight;
    this.paper ??= copy.getContext("2d");
    this.paper?.clearRect(0, 0, pixelWidth, pixelHeight);
    const from = source.height - pixelHeight;
    this.paper?.drawImage(source, 0, from, pixelWidth, pixelHeight, 0, 0, pixelWidth, pixelHeight);
  }

  dispose(): void {
    this.shared.remove(this);
    this.element.remove();
  }
}

export class SharedRenderer {
  private readonly renderer: WebGLRenderer;
  private readonly surfaces = new Set<Surface>();
  private readonly viewport = new Vector4();

  constructor() {
    this.renderer = new WebGLRenderer({
      // Where the processor draws, smooth edges would cost a third of the frames.
      antialias: tierChooser().tier === "full",
      alpha: true,
      powerPreference: "high-performance",
    });
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.toneMapping = NoToneMapping;
    const canvas = this.renderer.domElement;
    canvas.setAttribute("aria-hidden", "true");
    canvas.addEventListener("webglcontextrestored", () => {
      for (const surface of this.surfaces) surface.onLost();
    });
  }

  add(surface: Surface): void {
    this.surfaces.add(surface);
    this.share();
  }

  remove(surface: Surface): void {
    this.surfaces.delete(surface);
    this.share();
  }

  draw(surface: Surface, scene: Scene, camera: Camera, area: Area | null, last: boolean): void {
    const { renderer } = this;
    const alone = this.surfaces.size === 1;
    this.fit(surface, alone);
    this.place(surface, area);
    renderer.setViewport(this.viewport);
    renderer.setScissor(this.viewport);
    renderer.setScissorTest(!alone || area !== null);
    renderer.render(scene, camera);
    if (!alone && last) surface.take(renderer.domElement);
  }

  /** WebGL counts from the lower left, where the surface's picture lies. */
  private place({ pixelWidth, pixelHeight, height, ratio }: Surface, area: Area | null): void {
    if (!area) this.viewport.set(0, 0, pixelWidth, pixelHeight);
    else {
      const low = height - area.y - area.height;
      this.viewport.set(area.x, low, area.width, area.height).multiplyScalar(ratio).round();
    }
  }

  /** The drawing area: exactly a lone surface's size, otherwise large enough for the largest. */
  private fit(surface: Surface, alone: boolean): void {
    const { width, height } = this.renderer.domElement;
    const wide = alone ? surface.pixelWidth : Math.max(width, surface.pixelWidth);
    const high = alone ? surface.pixelHeight : Math.max(height, surface.pixelHeight);
    if (wide !== width || high !== height) this.renderer.setSize(wide, high, false);
  }

  private share(): void {
    const alone = this.surfaces.size === 1;
    for (const surface of this.surfaces) surface.show(alone ? this.renderer.domElement : null);
  }
}

let shared: SharedRenderer | undefined;

/** Made with the first view. Throws where the browser has no WebGL. */
export function sharedRenderer(): SharedRenderer {
  shared ??= new SharedRenderer();
  return shared;
}
