import "../styles/library.css";
import "../styles/clip.css";
import "../viewer";
import { copyButtons } from "../results/copy";

copyButtons();
