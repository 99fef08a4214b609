import "../styles/participant.css";
import "../styles/participant-ends.css";
import { showLocalTimes } from "../participant/local_time";
import { hasWebGL } from "../viewer/support";

// Taking part is offered only where the clips can be drawn, and before anything is agreed to.
const state = hasWebGL() ? "supported" : "unsupported";
for (const part of document.querySelectorAll<HTMLElement>("[data-when]")) {
  part.hidden = part.dataset["when"] !== state;
}
if (state === "supported" && document.querySelector("motion-viewer")) void import("../viewer/motion_viewer");
showLocalTimes();
