import "../styles/library.css";
import "../styles/sets.css";
import "../sets/set_maker";
