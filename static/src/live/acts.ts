// What a researcher does with a participant: each act is one call, and the audit trail keeps it.
import { api, ApiError } from "../api";

interface Wording {
  title: (name: string) => string;
  explained: string;
  action: string;
  /** Whether the audit trail should say why. */
  why: boolean;
}

const WORDINGS: Record<string, Wording> = {
  exclude: {
    title: (name) => `Leave participant ${name} out`,
    explained: "Results and groups go on without them. The answers stay, and you can take it back.",
    action: "Leave out",
    why: true,
  },
  flag: {
    title: (name) => `Mark participant ${name}`,
    explained: "To be looked at again. A mark changes nothing else.",
    action: "Mark",
    why: true,
  },
  delete: {
    title: (name) => `Delete participant ${name}`,
    explained: "Every answer and all that is known of them is deleted for good. Only the fact that somebody took part stays.",
    action: "Delete for good",
    why: false,
  },
};

/** @param done called after an act, with where to go next if the page itself is gone. */
export function participantActs(root: Document, done: (home: string | null) => Promise<void> | void): void {
  const dialog = root.querySelector<HTMLDialogElement>("dialog#why");
  if (!dialog) return;
  root.addEventListener("click", (event) => {
    const button = (event.target as Element).closest<HTMLButtonElement>("[data-act]");
    if (!button) return;
    const wording = WORDINGS[button.dataset.act ?? ""];
    if (wording) ask(dialog, button, wording, done);
    else void act(button, null).then(() => done(null), (error: unknown) => tell(dialog, button, error));
  });
  dialog.querySelector("[data-cancel]")?.addEventListener("click", () => dialog.close());
}

function ask(
  dialog: HTMLDialogElement,
  button: HTMLButtonElement,
  wording: Wording,
  done: (home: string | null) => Promise<void> | void,
): void {
  const reason = dialog.querySelector("textarea")!;
  fill(dialog, wording.title(button.dataset.name ?? ""), wording.explained, wording.action);
  dialog.querySelector<HTMLElement>("[data-reason]")!.hidden = !wording.why;
  dialog.querySelector("[data-do]")!.classList.toggle("danger-primary", !wording.why);
  reason.value = "";
  reason.required = wording.why;
  dialog.querySelector("form")!.onsubmit = (event) => {
    event.preventDefault();
    void act(button, wording.why ? reason.value.trim() : null).then(
      async () => {
        dialog.close();
        await done(button.dataset.home ?? null);
      },
      (error: unknown) => tell(dialog, button, error),
    );
  };
  dialog.showModal();
}

/** The call that belongs to a button. */
export async function act(button: HTMLElement, reason: string | null): Promise<void> {
  const home = button.closest<HTMLElement>("[data-api]")?.dataset.api ?? "";
  const { act: name = "", session = "" } = button.dataset;
  const place = `${home}/sessions/${session}`;
  if (name === "delete") await api.delete(place);
  else await api.post(`${place}/${name}`, reason === null ? undefined : { reason });
}

function tell(dialog: HTMLDialogElement, button: HTMLElement, error: unknown): void {
  if (!(error instanceof ApiError)) throw error;
  if (!dialog.open) {
    fill(dialog, button.textContent ?? "", "", "");
    dialog.showModal();
  }
  const failure = dialog.querySelector<HTMLElement>("[data-failure]")!;
  failure.textContent = [error.message, error.mend].filter(Boolean).join(" ");
  failure.hidden = false;
}

function fill(dialog: HTMLDialogElement, title: string, explained: string, action: string): void {
  dialog.querySelector("h2")!.textContent = title;
  dialog.querySelector("[data-explained]")!.textContent = explained;
  const button = dialog.querySelector<HTMLElement>("[data-do]")!;
  button.textContent = action;
  button.hidden = !action;
  dialog.querySelector<HTMLElement>("[data-failure]")!.hidden = true;
}
