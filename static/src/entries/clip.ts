import "../styles/library.css";
import "../styles/clip.css";
import "../styles/body.css";
import "../viewer";
import "../library/clip_body";
import { provenance } from "../library/provenance";
import { copyButtons } from "../results/copy";

copyButtons();
provenance();
