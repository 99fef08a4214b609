import "../styles/participant.css";
import "../participant/trial_page";

// The viewer is large: it comes beside the first clip, while the page is already there.
void import("../viewer/motion_viewer");
