// <still-chart name="…">: one of the page's charts, drawn once and again when the page turns dark.
import type { Charts } from "./axis_charts";
import { darkMode, dataOf, draw } from "./chart";

export class StillChart extends HTMLElement {
  private readonly dark = darkMode();
  private readonly redraw = () => {
    const spec = dataOf<Charts>("charts")[this.getAttribute("name") ?? ""];
    if (spec) void draw(this, spec[this.dark.matches ? "dark" : "light"]);
  };

  connectedCallback(): void {
    this.dark.addEventListener("change", this.redraw);
    this.redraw();
  }

  disconnectedCallback(): void {
    this.dark.removeEventListener("change", this.redraw);
  }
}

customElements.define("still-chart", StillChart);
