// Asking the server: what it refuses becomes a note in the page.
import { ApiError } from "../api";

/** Do it; a refusal is handed over (null: it went well). Whatever is not the server's is thrown on. */
export async function attempt(act: () => Promise<void>, refused: (problem: ApiError | null) => void): Promise<void> {
  try {
    await act();
    refused(null);
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") return;
    if (!(error instanceof ApiError)) throw error;
    refused(error);
  }
}
