import "../styles/results.css";
import "../styles/impressions.css";
import "../impressions/impressions_page";
