import { expect, test } from "vitest";
import { keysOfViews, kPageKeys, type Key } from "./keys";
import { kViews, type View } from "./route";

/** The view after a key is pressed in `view`; undefined if no row has the key. */
function after(rows: Key[], key: string, view: View): View | undefined {
  let gone: View | undefined;
  const viewer = { view, go: ({ view }: { view: View }) => (gone = view) } as unknown as Parameters<Key["act"]>[0];
  rows.find(({ keys }) => keys.includes(key))?.act(viewer, { key, shiftKey: false });
  return gone;
}

test("each of the first nine views has its digit", () => {
  kViews.slice(0, 9).forEach((view, i) => expect(after(kPageKeys, String(i + 1), "field")).toBe(view));
});

test("every view is reached by keyboard, also the tenth and later ones", () => {
  const many = [...kViews, "tenth", "eleventh"] as View[];
  const rows = keysOfViews(many);
  const [digits] = rows;
  expect(digits!.keys).toEqual([..."123456789"]);
  expect(digits!.does).not.toContain("tenth"); // the help promises no key that does nothing
  many.forEach((view, i) => {
    const next = many[(i + 1) % many.length]!;
    expect(after(rows, "v", view)).toBe(next);
    expect(after(rows, "V", next)).toBe(view);
  });
});

test("fewer than nine views have no digit without a view", () => {
  const rows = keysOfViews(["field", "log"]);
  expect(after(rows, "2", "field")).toBe("log");
  expect(after(rows, "3", "field")).toBeUndefined();
});

test("no key of the page has two actions", () => {
  const keys = kPageKeys.flatMap(({ keys }) => keys);
  expect(new Set(keys).size).toBe(keys.length);
});
