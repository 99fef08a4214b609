/** Registers `<motion-viewer>`. Load it lazily: it brings the renderer with it. */
import { MotionViewer } from "./element";

if (!customElements.get("motion-viewer")) customElements.define("motion-viewer", MotionViewer);

export { MotionViewer };
export type { ViewingStatistics } from "./statistics";

declare global {
  interface HTMLElementTagNameMap {
    "motion-viewer": MotionViewer;
  }
}
