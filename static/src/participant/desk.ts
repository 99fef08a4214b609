// Where a session comes from and where its answers go: the server, or, in a preview, nowhere.

import { api } from "../api";
import { Outbox } from "../outbox";
import type { GivenAnswer, Session, StoredAnswer } from "./course";
import type { Fetch } from "./preload";
import { fingerprint, Store } from "./store";

export interface Desk {
  /** By which tabs of the same session know each other. */
  name: string;
  store: Store;
  outbox: Outbox<GivenAnswer>;
  bytes: Fetch;
  session(): Promise<Session>;
  complete(): Promise<unknown>;
  /** To the last page. */
  leave(): void;
}

interface Receipt {
  state?: Session["state"];
}

const SEND_TIMEOUT_MS = 15_000;
const bytes: Fetch = (url, onShare) => api.bytes(url, undefined, onShare);

/** @param conflict the server held another answer to this step, and that one counts. */
export function desk(token: string, conflict: (index: number, stored: StoredAnswer | undefined) => void): Desk {
  const path = `/api/v1/sessions/${encodeURIComponent(token)}`;
  const store = new Store(token);
  const leave = () => location.replace(`/take/${encodeURIComponent(token)}/thanks`);
  const send = async (answer: GivenAnswer) => {
    const options = { keepalive: true, signal: AbortSignal.timeout(SEND_TIMEOUT_MS) };
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
    complete: () => api.post(`${path}/complete`),
    leave,
  };
}

/** @param address of a session made from a draft. */
export function previewDesk(address: string): Desk {
  const store = new Store("preview", null);
  return {
    name: "preview",
    store,
    outbox: new Outbox<GivenAnswer>({ store, send: () => Promise.resolve() }),
    bytes,
    session: () => api.get<Session>(address),
    complete: () => Promise.resolve(),
    leave: () => {},
  };
}
