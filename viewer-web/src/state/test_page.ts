// For tests: a viewer in a page without a browser, and servers that announce objects.

import { vi } from "vitest";
import { kPerceptChannel, percept } from "../memory/test_schema";
import type { Server } from "./server.svelte";
import { Viewer } from "./viewer.svelte";

/** The parts of a browser that hold the page's address. A hash that is set is told later, as in a browser. */
export class FakePage {
  href: string;
  told: (() => void)[] = [];
  entries = 0; // in the browser's history
  wide = false;

  constructor(address: string) {
    this.href = address;
    const change = (hash: string) => {
      this.href = this.href.split("#")[0]! + hash;
    };
    const location = Object.defineProperty({ assign: vi.fn(), reload: vi.fn() }, "hash", {
      get: () => (this.href.includes("#") ? `#${this.href.split("#")[1]}` : ""),
      set: (hash: string) => {
        ++this.entries;
        change(hash);
      },
    });
    Object.defineProperty(location, "href", { get: () => this.href });
    const storage = new Map<string, string>();
    const sessionStorage = {
      getItem: (key: string) => storage.get(key) ?? null,
      setItem: (key: string, value: string) => void storage.set(key, value),
    };
    vi.stubGlobal("location", location);
    vi.stubGlobal("history", { replaceState: (_: unknown, __: string, hash: string) => change(hash) });
    vi.stubGlobal("matchMedia", (query: string) => ({
      matches: query.includes("min-width: 1400px") && this.wide,
      addEventListener: () => {},
    }));
    vi.stubGlobal("window", {
      sessionStorage,
      addEventListener: (name: string, listener: () => void) => name === "hashchange" && this.told.push(listener),
    });
    vi.stubGlobal(
      "WebSocket",
      class {
        close() {}
        send() {}
      },
    );
  }
  /** A person follows a link or goes back. */
  follow(hash: string) {
    this.href = this.href.split("#")[0]! + hash;
    for (const listener of this.told) listener();
  }
}

/** Opens the viewer in a page with this hash in its address. */
export function openPage(hash = "", wide = false): { page: FakePage; viewer: Viewer } {
  const page = new FakePage(`http://robot:8765/${hash}`);
  page.wide = wide;
  const viewer = new Viewer({
    url: "ws://robot:8765/live",
    host: "robot:8765",
    ownHost: true,
    token: "",
    cleanAddress: page.href,
  });
  return { page, viewer };
}

/** The server announces these objects, all that it has, each with one message. */
export function announce(server: Server, ...topics: string[]): void {
  server.introduced({ name: "robot", capabilities: [], metadata: {} }, true, false);
  server.advertised(topics.map((topic, i) => ({ ...kPerceptChannel, id: i + 1, topic, metadata: {} })));
  server.services(["clock"]);
  for (const topic of topics) server.message(topic, 10n ** 9n, percept());
}

export function closePage({ servers }: Viewer): void {
  for (const server of servers) server.stop();
  vi.unstubAllGlobals();
}
