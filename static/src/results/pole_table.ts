// Choosing a row of "Is every emotion seen?" puts its sentence beside the table, ready to copy.

export function poleTable(table: HTMLTableElement, sentence: HTMLElement): void {
  table.addEventListener("click", (event) => {
    const row = (event.target as Element).closest<HTMLTableRowElement>("tr[data-sentence]");
    if (row) choose(table, row, sentence);
  });
}

export function choose(table: HTMLTableElement, row: HTMLTableRowElement, sentence: HTMLElement): void {
  for (const other of table.querySelectorAll("tr[data-sentence]")) {
    const chosen = other === row;
    other.classList.toggle("chosen", chosen);
    other.querySelector("button")?.setAttribute("aria-pressed", String(chosen));
  }
  sentence.replaceChildren(...italics(row.dataset.sentence ?? ""));
}

/** Statistical symbols stand in italics, as the style asks: t(42.7), p, d. */
export function italics(text: string): (string | HTMLElement)[] {
  return text.split(/\b([tpd])(?=\(| [=<])/).map((part, index) => {
    if (index % 2 === 0) return part;
    const symbol = document.createElement("em");
    symbol.textContent = part;
    return symbol;
  });
}
