// The arrangement of the page as a file: the view and its settings, without a moment and without any token.

import { addressOf } from "../source/target";
import { ownerOf, panesOf } from "./panes";
import { kViews, type Route, type View } from "./route";

const kFormat = 1;
/** Settings of the whole page that belong to the arrangement, beside those of panes. The others are moments. */
const kArrangement = ["with", "field", "find", "breaks", "panes"];
const isArrangement = (setting: string): boolean => kArrangement.includes(setting) || ownerOf(setting).number > 0;
const kRobot = /^(\d+\/\d+(@[\w.:[\]-]+)?)?$/;
const kLongest = 20_000; // [letters] of all settings

/** Returns the file's text, which people can read. */
export function textOfLayout({ robot, view, settings }: Route): string {
  const kept = Object.fromEntries([...settings].filter(([name]) => isArrangement(name)));
  return `${JSON.stringify({ foresight_layout: kFormat, robot, view, settings: kept }, null, 2)}\n`;
}

/** Parses a file of any kind. Returns one sentence if it is no layout. */
export function layoutOf(text: string): Route | { error: string } {
  const no = (why: string) => ({ error: `This is no layout: ${why}.` });
  let file: unknown;
  try {
    file = JSON.parse(text);
  } catch {
    return no("it is not JSON");
  }
  if (typeof file !== "object" || file === null || Array.isArray(file)) return no("expected an object");
  const { foresight_layout: format, robot, view, settings } = file as Record<string, unknown>;
  if (format !== kFormat)
    return no(`expected 'foresight_layout' to be ${kFormat}, got ${JSON.stringify(format) ?? "nothing"}`);
  if (!(kViews as readonly unknown[]).includes(view))
    return no(`expected 'view' to be one of ${kViews.join(", ")}, got ${JSON.stringify(view) ?? "nothing"}`);
  if (typeof robot !== "string" || !kRobot.test(robot))
    return no(`expected 'robot' to be like 14/2, got ${JSON.stringify(robot) ?? "nothing"}`);
  if (typeof settings !== "object" || settings === null || Array.isArray(settings))
    return no("'settings' is no object");
  for (const [name, value] of Object.entries(settings)) {
    if (!isArrangement(name)) return no(`the setting '${name}' is not known`);
    if (typeof value !== "string") return no(`the setting '${name}' is no text`);
    if (ownerOf(name).name === "robot" && !kRobot.test(value))
      return no(`expected '${name}' to be like 14/2, got ${JSON.stringify(value)}`);
  }
  const all = new Map(Object.entries(settings) as [string, string][]);
  if ([...all.values()].join("").length > kLongest) return no(`its settings are longer than ${kLongest} letters`);
  const panes = all.get("panes");
  if (panes !== undefined && !panesOf(panes))
    return no(`expected 'panes' to be like row(field,col(decision,plot)), got ${JSON.stringify(panes)}`);
  for (const host of (all.get("with") ?? "").split(",").filter(Boolean)) {
    const address = addressOf(host);
    if ("error" in address || address.token) return no(`the server '${host}' must be host:port and nothing else`);
  }
  return { robot, view: view as View, settings: all };
}
