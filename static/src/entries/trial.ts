import "../styles/participant.css";
import "../participant/trial_page";
