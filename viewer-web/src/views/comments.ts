// The comments of the schemas' fields, fetched at the first use because the first page does not need them.

type Comments = Record<string, Record<string, [unit: string, comment: string]>>;
let fetched: Promise<Comments> | undefined;

/** All comments; none when they cannot be had. */
export function comments(): Promise<Comments> {
  fetched ??= import("virtual:schema_comments").then(
    (module) => module.default,
    () => ({}),
  );
  return fetched;
}

/** "m/s"; "" when not known. Where only the field's name is known, the unit that all fields of this name share. */
export async function unitOf(message: string, name: string): Promise<string> {
  const all = await comments();
  if (message) return all[message]?.[name]?.[0] ?? "";
  const units = new Set(
    Object.values(all).flatMap((fields) => (Object.hasOwn(fields, name) ? [fields[name]![0]] : [])),
  );
  return units.size === 1 ? [...units][0]! : "";
}
