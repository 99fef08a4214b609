// Where a session comes from and where its answers go: the server, or, in a preview, nowhere.

import { api } from "../api";
import { Outbox } from "../outbox";
import type { GivenAnswer, Session, StoredAnswer } from "./course";
import type { Made } from "../trials/kind";
import type { Fetch } from "./preload";
import { fingerprint, Store } from "./store";

export interface Desk {
  /** By which tabs of the same session know each other. */
  name: string;
  store: Store;
  outbox: Outbox<GivenAnswer>;
  bytes: Fetch;
  session(): Promise<Session>;
  /** What the sliders of a step make. */
  motion(step: number, values: Readonly<Record<string, number>>): Promise<Made>;
  complete(): Promise<unknown>;
  /** To the last page. */
  leave(): void;
}

interface Receipt {
  state?: Session["state"];
}

const SEND_TIMEOUT_MS = 15_000;
/** A browser lets no more than 64 kB outlive their page. */
const MOST_KEPT_ALIVE = 60_000;
const bytes: Fetch = (url, onShare) => api.bytes(url, undefined, onShare);

/** @param conflict the server held another answer to this step, and that one counts. */
export function desk(token: string, conflict: (index: number, stored: StoredAnswer | undefined) => void): Desk {
  const path = `/api/v1/sessions/${encodeURIComponent(token)}`;
  const store = new Store(token);
  const leave = () => location.replace(`/take/${encodeURIComponent(token)}/thanks`);
  const send = async (answer: GivenAnswer) => {
    const keepalive = new Blob([JSON.stringify(answer)]).size < MOST_KEPT_ALIVE;
    const options = { keepalive, signal: AbortSignal.timeout(SEND_TIMEOUT_MS) };
    const receipt = await api.post<Receipt>(`${path}/responses`, answer, options);
    // An answer may end the study for this person.
    if (receipt.state && receipt.state !== "active") leave();
  };
  return {
    name: fingerprint(token),
    store,
    outbox: new Outbox<GivenAnswer>({
      store,
      send,
      onConflict: (answer, stored) => conflict(answer.trial_index, stored as StoredAnswer | undefined),
    }),
    bytes,
    session: () => api.get<Session>(path),
    motion: (step, values) => moved(`${path}/steps/${step}/motion`, values),
    complete: () => api.post(`${path}/complete`),
    leave,
  };
}

/** @param address of a session made from a draft. */
export function previewDesk(address: string): Desk {
  const store = new Store("preview", null);
  const [path = "", query = ""] = address.split("?");
  return {
    name: "preview",
    store,
    outbox: new Outbox<GivenAnswer>({ store, send: () => Promise.resolve() }),
    bytes,
    session: () => api.get<Session>(address),
    motion: (step, values) => moved(`${path}/steps/${step}/motion?${query}`, values),
    complete: () => Promise.resolve(),
    leave: () => {},
  };
}

async function moved(path: string, values: Readonly<Record<string, number>>): Promise<Made> {
  const { bytes: glb, headers } = await api.reply(path, { values });
  return { glb, distance: Number(headers.get("Manner-Distance")), solved: headers.get("Manner-Solved") === "1" };
}
