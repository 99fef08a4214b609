import "../favicon.svg?no-inline";
import "../styles/fonts.css";
import "../styles/tokens.css";
import "../styles/site.css";
