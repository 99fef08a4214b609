import "../styles/library.css";
import "../library/clip_library";
