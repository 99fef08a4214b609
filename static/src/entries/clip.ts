import "../styles/library.css";
import "../styles/clip.css";
import "../styles/body.css";
import "../styles/dialogs.css";
import "../viewer";
import "../builder/use_in_study";
import "../library/clip_body";
import { provenance } from "../library/provenance";
import { copyButtons } from "../results/copy";

copyButtons();
provenance();
