import "../styles/library.css";
import "../styles/picker.css";
import "../styles/space.css";
import "../space/space_list";
