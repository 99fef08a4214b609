import "../styles/participant.css";
import "../styles/participant-ends.css";
import { Store } from "../participant/store";
import { hasWebGL } from "../viewer/support";
import { t } from "../words";

// Everything has arrived, or is deleted: this device has nothing more to keep.
const { token } = document.querySelector<HTMLElement>("[data-forget]")?.dataset ?? {};
if (token) new Store(token).clear();

for (const button of document.querySelectorAll<HTMLButtonElement>("[data-copy]")) {
  button.hidden = !navigator.clipboard;
  button.addEventListener("click", () => void copy(button));
}
const viewer = document.querySelector("motion-viewer");
if (viewer && hasWebGL()) void import("../viewer/motion_viewer");

// A bow is deepest in the middle of its clip. Held there, it is seen whenever somebody looks up.
viewer?.addEventListener("timeupdate", () => {
  if (!viewer.paused && !viewer.loop && viewer.currentTime >= viewer.duration / 2) viewer.pause();
});

async function copy(button: HTMLButtonElement): Promise<void> {
  const text = document.getElementById(button.dataset["copy"] ?? "")?.textContent?.trim() ?? "";
  await navigator.clipboard.writeText(text);
  const word = button.querySelector("span");
  if (word) word.textContent = t("Copied");
}
