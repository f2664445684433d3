import { McapWriter } from "@mcap/core";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { kPerceptChannel, percept } from "../memory/test_schema";
import { Past } from "../memory/past";
import type { Channel, Level, ServerInfo } from "../source/texts";
import type { Left } from "./left";
import { Server, type Speaker } from "./server.svelte";

const kSecond = 1_000_000_000n;
const channelOf = (topic: string, id = 1): Channel => ({ ...kPerceptChannel, id, topic, metadata: {} });
const infoOf = (more: Partial<ServerInfo> = {}): ServerInfo => ({
  name: "robot",
  capabilities: [],
  metadata: {},
  ...more,
});

/** The sentences of a server, by key. */
class Told implements Speaker {
  several = false;
  said = new Map<string, string>();
  followed = 0;
  say(_level: Level, text: string, key = text) {
    this.said.set(key, text);
  }
  dismiss(keys: string[]) {
    for (const key of keys) this.said.delete(key);
  }
  follow() {
    ++this.followed;
  }
  follows = false;
  asked_ns: bigint | undefined;
  begun: (Left | undefined)[] = [];
  opened(_: Server, left: Left | undefined) {
    this.begun.push(left);
  }
}

let told: Told;
let server: Server;
let asked: string[];
let addresses: URL[]; // of all connections

/** A recording of one message of each topic, by another library. */
async function recording(topics: string[], log_ns: bigint): Promise<Uint8Array<ArrayBuffer>> {
  const pieces: Uint8Array[] = [];
  let length = 0n;
  const write = (bytes: Uint8Array) => {
    pieces.push(bytes.slice());
    length += BigInt(bytes.length);
    return Promise.resolve();
  };
  const writer = new McapWriter({ writable: { position: () => length, write } });
  await writer.start({ profile: "", library: "" });
  for (const topic of topics) {
    const channelId = await writer.registerChannel({
      topic,
      schemaId: 0,
      messageEncoding: "protobuf",
      metadata: new Map(),
    });
    await writer.addMessage({ channelId, sequence: 1, logTime: log_ns, publishTime: log_ns, data: percept() });
  }
  await writer.end();
  return Uint8Array.from(pieces.flatMap((piece) => [...piece]));
}

beforeEach(() => {
  addresses = [];
  vi.stubGlobal(
    "WebSocket",
    class {
      constructor(url: string) {
        addresses.push(new URL(url));
      }
      close() {}
      send() {}
    },
  );
  asked = [];
  vi.stubGlobal("fetch", async (path: string) => {
    asked.push(path);
    const topics = new URLSearchParams(path.split("?")[1]).get("topics")!.split("\n");
    return new Response(await recording(topics, 100n * kSecond));
  });
  told = new Told();
  const target = { url: "ws://robot:8765/live", host: "robot:8765", ownHost: true, token: "", cleanAddress: "" };
  server = new Server(target, new Past(), told);
});
afterEach(() => {
  server.stop();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

const settled = async () => {
  for (let i = 0; i < 20; ++i) await new Promise((resolve) => setTimeout(resolve));
};

/** A live robot that remembers its last minutes, has announced `topics`, and whose present was shown for a second. */
function live(...topics: string[]) {
  const began = performance.now();
  vi.spyOn(performance, "now").mockReturnValue(began);
  server.introduced(infoOf({ metadata: { recent: "/api/recent" } }), true, false);
  server.advertised(topics.map(channelOf));
  for (const topic of topics) server.subscribed(topic, true);
  server.services(["set_parameters"]);
  vi.spyOn(performance, "now").mockReturnValue(began + 1000);
}

test("the present is shown before the past is asked for", async () => {
  live("/14/2/ball");
  server.parameters([{ name: "match_mode", value: false }]);
  vi.spyOn(performance, "now").mockReturnValue(performance.now() - 900);
  server.frame();
  await settled();
  expect(asked).toEqual([]);
  vi.spyOn(performance, "now").mockReturnValue(performance.now() + 900);
  server.frame();
  await settled();
  expect(asked.length).toBe(1);
});

test("the last minutes are asked for when the parameters are known, and lie before what has come", async () => {
  live("/14/2/ball", "/14/2/pose");
  server.message("/14/2/ball", 400n * kSecond, percept());
  server.frame();
  await settled();
  expect(asked).toEqual([]);
  server.parameters([{ name: "match_mode", value: false }]);
  server.frame();
  expect(server.recalls).toBe(true);
  await settled();
  expect(asked).toEqual(["/api/recent?topics=%2F14%2F2%2Fball%0A%2F14%2F2%2Fpose"]);
  expect(server.recalls).toBe(false);
  const { history } = server.memory.get("/14/2/ball")!;
  expect([history.first_ns, history.last_ns]).toEqual([100n * kSecond, 400n * kSecond]);
  expect(server.memory.get("/14/2/pose")!.history.last_ns).toBe(100n * kSecond);
  expect([...told.said.values()]).toEqual([]);
});

test("nothing is asked for during a game, of images, of another host, or if the server remembers nothing", async () => {
  live("/14/2/ball");
  server.parameters([{ name: "match_mode", value: true }]);
  server.frame();
  await settled();
  server.introduced(infoOf({ metadata: { recent: "http://elsewhere/" } }), true, false);
  server.advertised([channelOf("/14/2/ball")]);
  server.subscribed("/14/2/ball", true);
  server.parameters([{ name: "match_mode", value: false }]);
  server.services(["set_parameters"]);
  server.frame();
  await settled();
  server.introduced(infoOf({ metadata: { recent: "/api/recent" } }), true, false);
  server.advertised([{ ...channelOf("/14/2/camera"), schemaName: "foresight.Image" }]);
  server.subscribed("/14/2/camera", true);
  server.parameters([{ name: "match_mode", value: false }]);
  server.services(["set_parameters"]);
  server.frame();
  await settled();
  expect(asked).toEqual([]);
});

test("a failure is told once, and dismissed when the server begins anew", async () => {
  vi.stubGlobal("fetch", () => Promise.reject(new Error("no network")));
  live("/14/2/ball");
  server.parameters([{ name: "match_mode", value: false }]);
  server.frame();
  await settled();
  expect([...told.said.values()]).toEqual(["The last minutes of /14/2/ball cannot be had: no network."]);
  server.introduced(infoOf(), true, false);
  expect(told.said.size).toBe(0);
});

test("a server with a span and the capability plays a recording; a fresh introduction forgets the past", () => {
  const span = { start_ns: 5n * kSecond, end_ns: 9n * kSecond };
  server.introduced(infoOf({ span }), true, false);
  expect(server.played).toBeUndefined();
  server.introduced(infoOf({ capabilities: ["playbackControl"], span }), true, false);
  expect(server.memory.range()).toEqual({ first_ns: span.start_ns, last_ns: span.end_ns });
  server.advertised([channelOf("/14/2/ball")]);
  server.message("/14/2/ball", 6n * kSecond, percept());
  server.introduced(infoOf(), false, false);
  expect(server.memory.get("/14/2/ball")!.received).toBe(1);
  server.introduced(infoOf(), true, false);
  expect(server.memory.get("/14/2/ball")).toBeUndefined();
  expect(server.played).toBeUndefined();
});

const kSpan = { start_ns: 5n * kSecond, end_ns: 90n * kSecond };
const recorded = (more: Partial<ServerInfo> = {}): ServerInfo =>
  infoOf({ capabilities: ["playbackControl"], span: kSpan, metadata: { own_playheads: "yes", session: "a" }, ...more });
const stateOf = (at: bigint, more: object = {}) =>
  ({ status: "paused", time_ns: at * kSecond, speed: 1, didSeek: false, request: "", ...more }) as const;
/** Loses the connection, and makes the next one. */
function connectAgain() {
  server.connection({ state: "waiting", why: "lost" });
  server.client.start();
  return addresses.at(-1)!.searchParams.get("playhead");
}
/** A connection to a recording with a playhead of its own. */
function opens(info: ServerInfo, fresh = true) {
  server.connection({ state: "open" });
  server.introduced(info, fresh, false);
  server.playhead(true);
}

test("a page asks for a playhead of its own, at the moment of a link, or follows", () => {
  expect(addresses.at(-1)!.searchParams.get("playhead")).toBe("own");
  told.asked_ns = 7n;
  expect(connectAgain()).toBe("7");
  told.follows = true;
  expect(connectAgain()).toBeNull();
  expect(addresses.at(-1)!.searchParams.get("playback")).toBe("yes");
});

test("a new playhead of its own is reported once, when its state is known", () => {
  opens(recorded());
  expect([server.own, server.offersOwn, told.begun]).toEqual([true, true, []]);
  server.playback(stateOf(5n));
  server.playback(stateOf(5n));
  expect([told.begun, told.followed]).toEqual([[undefined], 0]);
});

test("a playhead of its own survives a lost connection: place, speed, and whether it plays", () => {
  opens(recorded());
  server.playback(stateOf(20n, { speed: 2 }));
  expect(connectAgain()).toBe(String(20n * kSecond));
  expect(connectAgain()).toBe(String(20n * kSecond)); // the next try too
  opens(recorded(), false);
  server.playback(stateOf(20n));
  expect(told.begun.at(-1)).toEqual({ play: false, speed: 2, at_ns: 20n * kSecond, ...kSpan, session: "a" });

  // a server that was started again
  server.ask({ play: true, speed: 4, seek_ns: 30n * kSecond });
  server.playback(stateOf(30n, { status: "playing", speed: 4, didSeek: true, request: "page 1" }));
  expect(BigInt(connectAgain()!)).toBeGreaterThanOrEqual(30n * kSecond);
  expect(server.runs).toBe(false); // nothing plays without a connection
  opens(recorded());
  server.playback(stateOf(30n));
  expect(told.begun.at(-1)).toMatchObject({ play: true, speed: 4 });

  // another recording begins at its begin
  connectAgain();
  opens(recorded({ span: { start_ns: 6n * kSecond, end_ns: 7n * kSecond } }));
  server.playback(stateOf(6n));
  expect(told.begun.at(-1)).toBeUndefined();

  // also one with the same span
  opens(recorded());
  server.playback(stateOf(20n));
  connectAgain();
  opens(recorded({ metadata: { own_playheads: "yes", session: "b" } }));
  server.playback(stateOf(20n));
  expect(told.begun.at(-1)).toBeUndefined();
});

test("a page that is loaded again goes on where it was, unless a link asks for a moment", () => {
  const stored = new Map<string, string>();
  vi.stubGlobal("window", {
    sessionStorage: {
      getItem: (key: string) => stored.get(key) ?? null,
      setItem: (key: string, value: string) => void stored.set(key, value),
      removeItem: (key: string) => void stored.delete(key),
    },
  });
  opens(recorded());
  server.playback(stateOf(20n, { speed: 2 }));
  server.keepPlayhead();
  const again = () => {
    server.stop();
    server = new Server(server.target, new Past(), told);
    return addresses.at(-1)!.searchParams.get("playhead");
  };
  expect(again()).toBe(String(20n * kSecond));
  opens(recorded());
  server.playback(stateOf(20n));
  expect(told.begun.at(-1)).toMatchObject({ play: false, speed: 2 });
  told.asked_ns = 7n;
  expect(again()).toBe("7");
});

test("a moment that the page shows by itself survives a lost connection", () => {
  opens(recorded());
  server.playback(stateOf(20n));
  server.memory.show(12n * kSecond);
  expect(connectAgain()).toBe(String(12n * kSecond));
});

test("who shares the playback is moved by others; a playhead of its own is moved by nobody else", () => {
  server.introduced(recorded(), true, false);
  server.playhead(false);
  server.playback(stateOf(20n, { didSeek: true }));
  expect([told.followed, told.begun]).toEqual([1, []]);
  server.playhead(true);
  server.playback(stateOf(20n, { didSeek: true }));
  expect(told.followed).toBe(1);
});

test("the nearest moment of many topics is asked for a few topics at a time", async () => {
  opens(recorded());
  server.services(["message_beside"]);
  let [underWay, most] = [0, 0];
  vi.spyOn(server, "frameBeside").mockImplementation(async (topic, at_ns, by) => {
    most = Math.max(most, ++underWay);
    await settled();
    --underWay;
    return topic === "/14/2/x17" && by > 0 ? at_ns + 3n : at_ns + BigInt(by) * 9n;
  });
  const topics = Array.from({ length: 20 }, (_, i) => `/14/2/x${i}`);
  expect(await server.nearestTo(topics, 10n * kSecond)).toBe(10n * kSecond + 3n);
  expect(most).toBeLessThanOrEqual(32);
});

test("sensors are those of the offered topics, sorted", () => {
  live("/truth/10/sensor", "/truth/2/sensor", "/truth/2/depth");
  expect(server.sensors).toEqual([2, 10]);
  server.unadvertised([channelOf("/truth/2/sensor")]);
  expect(server.sensors).toEqual([10]);
});

test("robots, session, body and practice are those that the server tells", () => {
  expect(server.practice).toBe(false);
  server.introduced(infoOf({ metadata: { body: "sim", session: "final" } }), true, false);
  server.advertised([channelOf("/14/2/ball"), channelOf("/5/1/ball", 2), channelOf("/truth/world", 3)]);
  expect([server.robots, server.session, server.body]).toEqual([["5/1", "14/2"], "final", "a simulation"]);
  server.introduced(infoOf({ metadata: { body: "sim", session: "final", robots: "14/2" } }), true, false);
  server.advertised([channelOf("/14/2/ball"), channelOf("/5/1/ball", 2), channelOf("/truth/world", 3)]);
  expect(server.robots).toEqual(["14/2", "5/1"]); // its own team first
  server.unadvertised([channelOf("/5/1/ball", 2)]);
  expect(server.robots).toEqual(["14/2"]);
  server.parameters([{ name: "match_mode", value: false }]);
  server.parameters([{ name: "other", value: 1 }]);
  expect(server.practice).toBe(true);
  expect([server.playsAnother("final"), server.playsAnother("semifinal"), server.playsAnother("")]).toEqual([
    false,
    true,
    false,
  ]);
});

test("sentences name the server if there are several, and a refusal for want of a token asks for one", () => {
  server.status("warning", "the disk is full", "disk");
  told.several = true;
  server.status("error", "not allowed", "service x", "token");
  expect([...told.said.values()]).toEqual(["the disk is full", "robot:8765: not allowed"]);
  expect(server.wantsToken).toBe(true);
  server.removeStatus(["disk"]);
  expect([...told.said.values()]).toEqual(["robot:8765: not allowed"]);
  server.stop();
  expect(told.said.size).toBe(0);
});

test("a live moment that the page holds is shown at once", async () => {
  live("/14/2/ball");
  for (const at of [10n, 11n, 12n]) server.message("/14/2/ball", at * kSecond, percept());
  expect(await server.nearestTo(["/14/2/ball"], 11n * kSecond + 1n)).toBe(11n * kSecond);
  server.memory.show(11n * kSecond);
  expect(server.memory.get("/14/2/ball")!.shown!.log_ns).toBe(11n * kSecond);
});
