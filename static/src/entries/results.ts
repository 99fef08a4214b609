import "../styles/results.css";
import "../styles/downloads.css";
import "../results/axis_charts";
import "../results/still_chart";
import { copyButtons } from "../results/copy";
import { closingMenu } from "../results/menu";
import { followCounts } from "../results/live_counts";
import { choose, poleTable } from "../results/pole_table";

copyButtons();

const downloads = document.querySelector<HTMLDetailsElement>("details.downloads");
if (downloads) closingMenu(downloads);

const counts = document.getElementById("counts");
if (counts) {
  followCounts(counts, () => document.getElementById("newer")?.removeAttribute("hidden"));
}

const table = document.querySelector<HTMLTableElement>("table.poles");
const sentence = document.getElementById("sentence");
if (table && sentence) {
  poleTable(table, sentence);
  const first = table.querySelector<HTMLTableRowElement>("tr[data-sentence]");
  if (first) choose(table, first, sentence);
}
