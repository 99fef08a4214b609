import "../styles/sets.css";
import "../sets/set_maker";
