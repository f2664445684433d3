// Links that people share: the page's arrangement with its session and moment, never with a token.

import { hashOf, type Route } from "./route";

/** The session and the moment of a link. */
export interface Place {
  /** Name of the played session; "" for a live robot. */
  session: string;
  /** [ns since the epoch] The shown moment; undefined: none. */
  at_ns: bigint | undefined;
}

/** Returns the link to `route` at `place`. `address` is that of the page. */
export function linkOf(address: string, route: Route, { session, at_ns }: Place): string {
  const url = new URL(address);
  url.searchParams.delete("token");
  const settings = new Map([...route.settings].filter(([name]) => !["session", "at", "follow"].includes(name)));
  if (session) settings.set("session", session);
  if (at_ns !== undefined) settings.set("at", String(at_ns));
  url.hash = hashOf({ ...route, settings });
  return url.href;
}

/** Whether the address leads to this computer only, so that nobody else can follow a link. */
export const isOfThisComputer = (address: string): boolean =>
  /^(localhost|127\.\d+\.\d+\.\d+|\[::1\])$/.test(new URL(address).hostname);
