import "../styles/live.css";
import { participantActs } from "../live/acts";
import { LiveNow } from "../live/now";
import { Replay } from "../live/replay";
import { copyButtons } from "../results/copy";

copyButtons();

const now = document.getElementById("now");
const live = now && new LiveNow(now, document.getElementById("fresh"));
participantActs(document, (home) => {
  if (home) location.assign(home);
  else if (live) return live.ask(true);
  else location.reload();
});

const stage = document.getElementById("stage");
const list = document.querySelector<HTMLElement>("ol.steps");
const steps = document.getElementById("steps");
if (stage && list && steps) {
  void import("../viewer/motion_viewer");
  new Replay(JSON.parse(steps.textContent), list, stage);
}
