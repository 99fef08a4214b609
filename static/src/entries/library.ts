import "../styles/library.css";
import "../styles/body.css";
import "../styles/dialogs.css";
import "../library/clip_library";
