import "../styles/keys.css";
import { copyButtons } from "../results/copy";

copyButtons();
