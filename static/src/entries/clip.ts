import "../styles/library.css";
import "../styles/clip.css";
import "../viewer";
import { provenance } from "../library/provenance";
import { copyButtons } from "../results/copy";

copyButtons();
provenance();
