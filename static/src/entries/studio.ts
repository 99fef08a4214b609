import "../styles/library.css";
import "../styles/dialogs.css";
import "../styles/studio.css";
import "../styles/time-strip.css";
import "../viewer";
import "../studio/motion_studio";
