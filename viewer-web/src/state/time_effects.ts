// The effects of the page's time on its servers.

import type { Clocked } from "./clock_shifts";
import type { Server } from "./server.svelte";
import type { Effect } from "./time_state";

/** The servers that show one time. `shiftOf` gives the offset [ns] of a server's clock to the reference. */
export interface Shown {
  servers: readonly Shifted[];
  shiftOf(server: Clocked): bigint;
}

type Shifted = Pick<Server, "memory" | "played" | "place" | "goes" | "asked" | "stand" | "ask">;

/** Shows the moment `at_ns` of the reference at all servers. */
export function show({ servers, shiftOf }: Shown, at_ns: bigint): void {
  for (const server of servers) {
    const theirs_ns = at_ns + shiftOf(server);
    if (!server.played) server.memory.show(theirs_ns);
    else stand(server, server.played.within(theirs_ns));
  }
}

/** Pauses the server at `at_ns`, unless it is there or under way. */
function stand(server: Shifted, at_ns: bigint): void {
  const { moment_ns } = server.memory;
  if (moment_ns === at_ns) return;
  const goesThere = server.place() === at_ns && !server.goes && (moment_ns === undefined || server.asked);
  if (!goesThere) server.stand(at_ns);
}

/** Shows the newest data of all servers. */
export function release({ servers }: Shown): void {
  for (const { memory } of servers) memory.show(undefined);
}

/** Sends a wish to the servers that play recordings. The others show their newest data. */
export function ask({ servers, shiftOf }: Shown, { play, speed, seek_ns }: Effect & { do: "ask" }): void {
  for (const server of servers) {
    const { played } = server;
    if (!played) server.memory.show(undefined);
    else
      server.ask({
        play,
        speed,
        seek_ns: seek_ns === undefined ? undefined : played.within(seek_ns + shiftOf(server)),
      });
  }
}
