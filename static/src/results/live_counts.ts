// Keeps the large numbers at the top of a results page up to date.
import { api, ApiError } from "../api";

const EVERY = 5000;

/**
 * Ask for the numbers again and again while the page is looked at.
 *
 * @param onComplete called when the number of complete participants has changed since the page was made.
 */
export function followCounts(place: HTMLElement, onComplete: () => void): void {
  const made = place.dataset.complete;
  const ask = async () => {
    const address = place.dataset.address;
    if (document.hidden || !address) return;
    const fresh = await countsFrom(address);
    if (!fresh) return;
    place.replaceChildren(...fresh.childNodes);
    place.dataset.complete = fresh.dataset.complete;
    if (fresh.dataset.complete !== made) onComplete();
  };
  setInterval(() => void ask(), EVERY);
  document.addEventListener("visibilitychange", () => void ask());
}

/** The fragment's list; nothing when the line is down, because the next time will do. */
async function countsFrom(address: string): Promise<HTMLElement | null> {
  try {
    return (await api.page(address)).querySelector<HTMLElement>("[data-complete]");
  } catch (error) {
    if (error instanceof ApiError) return null;
    throw error;
  }
}
