// Named moments, as the page's address holds them: "1700000000000000000~first kick;…".

export interface Bookmark {
  /** [ns since the epoch] capture time of the reference. */
  at_ns: bigint;
  name: string;
}

const kMost = 50;
const kLongest = 60; // [letters]

/** Parses any text, in order of time. Invalid parts are left out. */
export function bookmarksOf(text: string): Bookmark[] {
  const bookmarks = text.split(";").flatMap((part) => {
    const [, at, name] = /^(\d{1,19})~(.*)$/s.exec(part) ?? [];
    return at === undefined ? [] : [{ at_ns: BigInt(at), name: name! }];
  });
  return bookmarks.slice(0, kMost).sort((a, b) => (a.at_ns < b.at_ns ? -1 : 1));
}

export const textOfBookmarks = (bookmarks: Bookmark[]): string =>
  bookmarks.map(({ at_ns, name }) => `${at_ns}~${name.replaceAll(";", ",").slice(0, kLongest)}`).join(";");

/** Adds a bookmark with the first free name. A moment has only one bookmark. */
export function withBookmark(bookmarks: Bookmark[], at_ns: bigint): Bookmark[] {
  if (bookmarks.some((bookmark) => bookmark.at_ns === at_ns)) return bookmarks;
  const names = new Set(bookmarks.map(({ name }) => name));
  let number = 1;
  while (names.has(`mark ${number}`)) ++number;
  return bookmarksOf(textOfBookmarks([...bookmarks.slice(0, kMost - 1), { at_ns, name: `mark ${number}` }]));
}
