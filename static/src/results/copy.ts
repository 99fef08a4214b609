// Buttons that copy: `data-copy` holds the text, or the id of the element whose text is meant.

const SAID_FOR = 2000;

export function copyButtons(root: ParentNode = document): void {
  root.addEventListener("click", (event) => {
    const button = (event.target as Element).closest<HTMLElement>("[data-copy]");
    if (button) void copy(button);
  });
}

async function copy(button: HTMLElement): Promise<void> {
  const wanted = button.dataset.copy ?? "";
  const text = (document.getElementById(wanted)?.textContent?.trim() ?? wanted).replaceAll("\u00a0", " ");
  const word = button.querySelector<HTMLElement>("[data-word]") ?? button;
  const before = word.textContent;
  word.textContent = (await written(text)) ? "Copied" : "Press Ctrl+C to copy";
  setTimeout(() => (word.textContent = before), SAID_FOR);
}

/** Write to the clipboard; where that is not allowed (no TLS), select the text for the person. */
async function written(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
