// Parts of a recording that the server plays, also parts that the page has not shown. Loaded on first use.

import { recordedIn, type Recorded } from "./mcap";

/** Fetches the messages of `topic` between two capture times [ns] from the page's own server. Rejects with a sentence. */
export async function fetchPlayed(topic: string, from_ns: bigint, to_ns: bigint): Promise<Recorded["messages"]> {
  const messages: Recorded["messages"] = [];
  for (let next_ns = from_ns; next_ns <= to_ns;) {
    const part = new URLSearchParams({ topic, from: String(next_ns), to: String(to_ns) });
    let response: Response;
    try {
      response = await fetch(`/api/played?${part}`, { signal: AbortSignal.timeout(30000) });
    } catch {
      throw new Error("The server does not answer.");
    }
    if (!response.ok) throw new Error(`The server does not list its recording (HTTP ${response.status}).`);
    const recorded = recordedIn(new Uint8Array(await response.arrayBuffer()));
    if (recorded.damage) throw new Error(`The recording of ${topic} cannot be read: ${recorded.damage}.`);
    for (const message of recorded.messages) messages.push(message);
    const until = response.headers.get("Foresight-Until") ?? "";
    if (!/^\d{1,20}$/.test(until) || BigInt(until) < next_ns)
      throw new Error("The server does not report the end of its answer.");
    next_ns = BigInt(until) + 1n;
  }
  return messages;
}
