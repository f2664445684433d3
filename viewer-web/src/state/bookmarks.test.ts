import { expect, test } from "vitest";
import { bookmarksOf, textOfBookmarks, withBookmark } from "./bookmarks";

test("bookmarks go through the address as they are, in order of time", () => {
  const bookmarks = [
    { at_ns: 5n, name: "first kick, ~2 m" },
    { at_ns: 1700000000000000000n, name: "" },
  ];
  expect(bookmarksOf(textOfBookmarks([...bookmarks].reverse()))).toEqual(bookmarks);
  expect(bookmarksOf(textOfBookmarks([{ at_ns: 1n, name: "a;2~b" }]))).toEqual([{ at_ns: 1n, name: "a,2~b" }]);
});

test("invalid bookmarks are left out", () => {
  expect(bookmarksOf("")).toEqual([]);
  expect(bookmarksOf("x~y;-1~a;7~ok;99999999999999999999~b;8")).toEqual([{ at_ns: 7n, name: "ok" }]);
});

test("a new one gets a free name, the same moment stands once", () => {
  const two = withBookmark(withBookmark([], 9n), 4n);
  expect(two).toEqual([
    { at_ns: 4n, name: "mark 2" },
    { at_ns: 9n, name: "mark 1" },
  ]);
  expect(withBookmark(two, 9n)).toBe(two);
  expect(withBookmark([two[0]!], 5n).map(({ name }) => name)).toEqual(["mark 2", "mark 1"]);
});
