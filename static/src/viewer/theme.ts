/** Light or dark, from the element's attribute, the page or the system. */
import type { Mode } from "./looks";

export function modeOf(attribute: string | null): Mode {
  if (attribute === "light" || attribute === "dark") return attribute;
  const page = document.documentElement.dataset["theme"];
  if (page === "light" || page === "dark") return page;
  return window.matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

/** Calls back whenever the page's or the system's choice changes. Returns the way to stop. */
export function watchMode(changed: () => void): () => void {
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  system.addEventListener("change", changed);
  const page = new MutationObserver(changed);
  page.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  return () => {
    system.removeEventListener("change", changed);
    page.disconnect();
  };
}

export function wantsStillness(): boolean {
  return window.matchMedia("(prefers-reduced-motion: reduce)").matches;
}
