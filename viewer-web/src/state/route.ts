// The part of the address after `#`: robot, view and settings. #/14/2/field?with=10.0.14.3:8765&at=…

export const kViews = [
  "field",
  "camera",
  "objects",
  "plot",
  "decision",
  "what-if",
  "health",
  "log",
  "sessions",
  "parameters",
  "debug",
  "ground-truth",
] as const;
export type View = (typeof kViews)[number];

/** The name of a view as people read it: "ground truth". */
export const wordsOfView = (view: View): string => (view === "ground-truth" ? "ground truth" : view);

/** Former names of views. */
const kFormer: Record<string, View> = { rates: "health" };

export interface Route {
  /** "" if no robot was chosen; "14/2@host:port" for a robot of another server. */
  robot: string;
  /** "" if none was chosen. */
  view: View | "";
  /** By name: `with` (other servers), `at` (the moment), and the views' settings. Never a token. */
  settings: ReadonlyMap<string, string>;
}

/** Parses any hash. Invalid parts choose nothing. */
export function routeOf(hash: string): Route {
  const [path, query] = split(hash.replace(/^#?\/?/, ""));
  const parts = path.split("/").map(decoded);
  const last = parts.at(-1)!;
  const view = kViews.find((name) => name === last) ?? (Object.hasOwn(kFormer, last) ? kFormer[last]! : "");
  const settings = new Map([...new URLSearchParams(query)].filter(([name]) => name !== "token"));
  return { robot: parts.length === 3 ? parts.slice(0, 2).join("/") : "", view, settings };
}

export function hashOf({ robot, view, settings }: Route): string {
  const path = [...(robot ? robot.split("/") : []), ...(view ? [view] : [])].map(encoded).join("/");
  const query = [...settings].map(([name, value]) => `${encoded(name)}=${encoded(value)}`).join("&");
  return `#/${path}${query && `?${query}`}`;
}

function split(text: string): [string, string] {
  const at = text.indexOf("?");
  return at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at + 1)];
}

/** Characters that are harmless after `#` stay readable. */
const encoded = (part: string): string => encodeURIComponent(part).replace(/%(40|3A|2C|2F|5B|5D)/g, decodeURIComponent);

function decoded(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}
