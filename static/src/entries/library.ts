import "../styles/library.css";
import "../styles/body.css";
import "../library/clip_library";
