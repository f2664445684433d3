// The server to connect to, and the handling of the token.

export interface Target {
  /** WebSocket address with the token, if there is one. Only for the socket, never shown on the page. */
  url: string;
  /** Host and port, as people name the robot. */
  host: string;
  /** True if page and data come from the same server. Then its HTTP interface may be used too. */
  ownHost: boolean;
  token: string;
  /** The page's address without the token. */
  cleanAddress: string;
}

/**
 * Reads the page's address: the live connection of its own host, or the server in `?ws=`. The token is that of
 * `?token=`, or the one that this tab kept for exactly this host. Otherwise a link with `?ws=ws://elsewhere` could
 * steal a robot's token.
 */
export function targetOf(address: string, keptToken: (host: string) => string): Target | { error: string } {
  const page = new URL(address);
  const given = page.searchParams.get("token");
  const wanted = page.searchParams.get("ws");
  page.searchParams.delete("token");

  let url: URL;
  try {
    url = wanted ? new URL(wanted) : new URL("/live", address.replace(/^http/, "ws"));
  } catch {
    return { error: `Address of the page: 'ws' must look like ws://robot:8765, got '${wanted}'.` };
  }
  if (url.protocol !== "ws:" && url.protocol !== "wss:")
    return { error: `Address of the page: 'ws' must start with ws:// or wss://, got '${wanted}'.` };

  url.search = wanted ? url.search : "";
  url.hash = "";
  const token = given ?? keptToken(url.host);
  if (token) url.searchParams.set("token", token);
  return {
    url: url.href,
    host: url.host,
    ownHost: url.host === page.host,
    token,
    cleanAddress: given === null ? address : page.href,
  };
}

const kUsualPort = 8765;

/**
 * Reads the address that a person types to add a robot: "10.0.14.2", "nao.local:8765", or one copied from a browser. A
 * token is returned separately, because addresses are shown and shared.
 */
export function addressOf(typed: string): { host: string; token: string } | { error: string } {
  const error = { error: `Expected host or host:port, such as 10.0.14.2:8765, got '${typed.trim()}'.` };
  let url: URL;
  try {
    url = new URL(/^\w+:\/\//.test(typed.trim()) ? typed.trim() : `ws://${typed.trim()}`);
  } catch {
    return error;
  }
  if (!["ws:", "wss:", "http:", "https:"].includes(url.protocol) || url.username || !/^[\w.:[\]-]+$/.test(url.hostname))
    return error;
  const secure = url.protocol === "wss:" || url.protocol === "https:";
  const port = url.port || (/:80\/?$/.test(typed.trim()) ? "80" : String(kUsualPort));
  if (secure) return { error: "Other robots are reached without encryption: leave 'https' out." };
  return { host: `${url.hostname}:${port}`, token: url.searchParams.get("token") ?? "" };
}

/** Returns the target of another server, given as "host:port", or undefined if that is invalid. */
export function targetOfHost(host: string, token: string): Target | undefined {
  const address = addressOf(host);
  if ("error" in address) return undefined;
  const url = new URL(`ws://${address.host}/live`);
  if (token) url.searchParams.set("token", token);
  return { url: url.href, host: address.host, ownHost: false, token, cleanAddress: "" };
}
