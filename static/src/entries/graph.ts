import "../styles/studio-controls.css";
import "../styles/graph.css";
import "../graph/graph_list";
import "../graph/graph_page";
