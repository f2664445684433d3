// Where to connect to, and what becomes of the token.

export interface Target {
  /** WebSocket address, with the token if there is one: for the socket only, never for the page. */
  url: string;
  /** The robot as a person would name it: host and port. */
  host: string;
  /** True where the page and the data come from the same server, so its HTTP interface may be asked too. */
  ownHost: boolean;
  token: string;
  /** The page's address without the token. */
  cleanAddress: string;
}

/**
 * Reads the page's address: the own host's live connection, or what `?ws=` names, with the token of `?token=` or the
 * one this tab kept for that very host: a link to `?ws=ws://elsewhere` must not carry a robot's token away.
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
  return { url: url.href, host: url.host, ownHost: url.host === page.host, token, cleanAddress: given === null ? address : page.href };
}

const kUsualPort = 8765;

/**
 * What a person types to add a robot: "10.0.14.2", "nao.local:8765", or an address copied from a browser. A token in
 * it is taken apart, since addresses are shown and shared.
 */
export function addressOf(typed: string): { host: string; token: string } | { error: string } {
  const error = { error: `Expected host or host:port, such as 10.0.14.2:8765, got '${typed.trim()}'.` };
  let url: URL;
  try {
    url = new URL(/^\w+:\/\//.test(typed.trim()) ? typed.trim() : `ws://${typed.trim()}`);
  } catch {
    return error;
  }
  if (!["ws:", "wss:", "http:", "https:"].includes(url.protocol) || url.username || !/^[\w.:[\]-]+$/.test(url.hostname)) return error;
  const secure = url.protocol === "wss:" || url.protocol === "https:";
  const port = url.port || (/:80\/?$/.test(typed.trim()) ? "80" : String(kUsualPort));
  if (secure) return { error: "Other robots are reached without encryption: leave 'https' out." };
  return { host: `${url.hostname}:${port}`, token: url.searchParams.get("token") ?? "" };
}

/** Another server than the page's own, by "host:port"; undefined where that is none. */
export function targetOfHost(host: string, token: string): Target | undefined {
  const address = addressOf(host);
  if ("error" in address) return undefined;
  const url = new URL(`ws://${address.host}/live`);
  if (token) url.searchParams.set("token", token);
  return { url: url.href, host: address.host, ownHost: false, token, cleanAddress: "" };
}
