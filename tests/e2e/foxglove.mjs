// Foxglove's own client, independent of our code.
import { atEnd, require } from "./support.mjs";

const { FoxgloveClient } = require("@foxglove/ws-protocol");
const WebSocket = require("ws");

/** Connects a client to a server; it and its socket are closed when the test ends. */
export function foxgloveClient(t, server) {
  const ws = new WebSocket(`ws://localhost:${server.port}`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
  atEnd(t, () => ws.terminate());
  return { ws, client: new FoxgloveClient({ ws }) };
}
