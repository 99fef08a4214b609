import "../styles/library.css";
import "../styles/picker.css";
import "../styles/dialogs.css";
import "../styles/builder.css";
import "../viewer";
import "../viewer/thumbnails";
import "../builder/study_builder";
