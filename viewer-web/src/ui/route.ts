// The part of the address after `#`: which robot, which view. #/14/2/objects

export const kViews = ["field", "camera", "objects", "rates", "log", "sessions"] as const;
export type View = (typeof kViews)[number];

export interface Route {
  /** "" where no robot was chosen. */
  robot: string;
  /** "" where none was chosen. */
  view: View | "";
}

/** Reads any hash; what makes no sense chooses nothing. */
export function routeOf(hash: string): Route {
  const parts = hash.replace(/^#?\/?/, "").split("/").map(decoded);
  const view = kViews.find((name) => name === parts.at(-1)) ?? "";
  return { robot: parts.length === 3 ? parts.slice(0, 2).join("/") : "", view };
}

export const hashOf = ({ robot, view }: Route): string =>
  `#/${[...(robot ? robot.split("/") : []), ...(view ? [view] : [])].map(encodeURIComponent).join("/")}`;

function decoded(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}
