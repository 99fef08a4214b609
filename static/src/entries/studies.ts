import "../styles/library.css";
import "../styles/results.css";
import "../styles/keys.css";
import "../styles/dialogs.css";
import "../styles/builder.css";
import "../styles/studies.css";
import { copyButtons } from "../results/copy";
import "../builder/new_study";
import "../builder/study_settings";

copyButtons();
