// One tab at a time answers a session: the newest one, and the others say so.

export interface Channel {
  postMessage(message: unknown): void;
  onmessage: ((event: MessageEvent) => void) | null;
  close(): void;
}

interface Claim {
  at: number;
  name: string;
}

/**
 * Claim the session for this tab, and call `lost` once when a later tab claims it.
 * Without BroadcastChannel (very old browsers) nobody yields; the server still keeps one answer per trial.
 */
export function claimSession(name: string, lost: () => void, open = openChannel): () => void {
  const channel = open(`manner/${name}`);
  if (!channel) return () => {};
  const mine: Claim = { at: Date.now(), name: Math.random().toString(36).slice(2) };
  channel.onmessage = ({ data }: MessageEvent<Claim>) => {
    if (!later(data, mine)) return;
    channel.close();
    lost();
  };
  channel.postMessage(mine);
  return () => channel.close();
}

/** Two tabs opened in the same millisecond still agree on which of them yields. */
function later(theirs: Claim, mine: Claim): boolean {
  return theirs.at === mine.at ? theirs.name > mine.name : theirs.at > mine.at;
}

function openChannel(name: string): Channel | null {
  return "BroadcastChannel" in globalThis ? new BroadcastChannel(name) : null;
}
