// How many panes the screen has room for.

import type { Room } from "./panes";

const kPhone = "(max-width: 640px), (max-height: 460px) and (pointer: coarse)";
const kUpright = "(max-width: 1000px) and (orientation: portrait)";

/** Whether the screen is wide enough to begin with several panes. */
export const isWide = (): boolean => matchMedia("(min-width: 1400px)").matches;

/** The room, kept up to date. */
export class Screen {
  room: Room = $state("all");

  constructor() {
    const queries = [matchMedia(kPhone), matchMedia(kUpright)] as const;
    const look = () => (this.room = queries[0].matches ? "one" : queries[1].matches ? "two" : "all");
    for (const query of queries) query.addEventListener("change", look);
    look();
  }
}
