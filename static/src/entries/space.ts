import "../styles/library.css";
import "../styles/dialogs.css";
import "../styles/studio.css";
import "../styles/time-strip.css";
import "../styles/space.css";
import "../viewer";
import "../space/motion_space";
