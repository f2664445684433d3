// Foxglove's own client, which nobody here wrote.
import { atEnd, require } from "./support.mjs";

const { FoxgloveClient } = require("@foxglove/ws-protocol");
const WebSocket = require("ws");

/** One that connects to a server and is cut off when the test ends, with the socket under it. */
export function foxgloveClient(t, server) {
  const ws = new WebSocket(`ws://localhost:${server.port}`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
  atEnd(t, () => ws.terminate());
  return { ws, client: new FoxgloveClient({ ws }) };
}
