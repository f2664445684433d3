import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { kPerceptChannel } from "../memory/test_schema";
import { kPresets } from "./panes";
import { announce as announceBy, closePage, openPage, type FakePage } from "./test_page";
import type { Viewer } from "./viewer.svelte";

let page: FakePage;
let viewer: Viewer;
const open = (hash = "", wide = false) => void ({ page, viewer } = openPage(hash, wide));
const announce = (...topics: string[]) => announceBy(viewer.servers[0]!, ...topics);

beforeEach(() => open());
afterEach(() => closePage(viewer));

test("the robot is that of the address while it is there, else the first one, and the address keeps its wish", () => {
  open("#/14/3/field");
  expect([viewer.robot, viewer.source]).toEqual(["", undefined]);
  announce("/14/2/ball");
  expect(viewer.robot).toBe("14/2");
  expect(viewer.arrangement.robot).toBe("14/3");
  announce("/14/2/ball", "/14/3/ball");
  expect(viewer.robot).toBe("14/3");
  viewer.chooseNeighbour(1);
  expect([viewer.robot, page.href]).toEqual(["14/2", "http://robot:8765/#/14/2/field"]);
  viewer.chooseNeighbour(-1);
  expect(viewer.robot).toBe("14/3");
});

test("a page without a view opens one that has data, and its address names it only when something is chosen", () => {
  announce("/14/2/percept");
  viewer.frame();
  expect([viewer.view, viewer.settled, page.href]).toEqual(["objects", true, "http://robot:8765/"]);
  viewer.set("team", "yes");
  expect(page.href).toBe("http://robot:8765/#/objects?team=yes");
  expect(viewer.get("team")).toBe("yes");
  expect(page.entries).toBe(0); // a setting is no step that one goes back
});

test("a wide page without a view begins with several panes", () => {
  open("", true);
  announce("/truth/world", "/14/2/pose", "/14/2/decision");
  viewer.frame();
  expect(viewer.panes.full).toBeUndefined();
  expect(viewer.view).toBe("field");
  expect(viewer.linkTo({ view: "log" })).toContain("panes=");
});

test("panes are split, closed and maximised, each step but the last one in the browser's history", () => {
  open("#/14/2/field");
  announce("/14/2/ball", "/truth/world");
  viewer.split("row");
  expect([viewer.focused.number, page.entries]).toEqual([2, 1]);
  viewer.go({ view: "log" });
  expect([viewer.pane(1).view, viewer.pane(2).view]).toEqual(["field", "log"]);
  viewer.maximise();
  expect([viewer.panes.full, page.entries]).toEqual([2, 2]);
  viewer.focusNeighbour(1);
  expect([viewer.panes.full, viewer.focused.number]).toEqual([1, 1]);
  viewer.maximise();
  viewer.close(viewer.pane(2));
  expect([viewer.view, page.href]).toEqual(["field", "http://robot:8765/#/14/2/field"]);
});

test("a page has six panes at most, and says so", () => {
  open("#/14/2/field");
  for (let i = 0; i < 8; ++i) viewer.split(i % 2 ? "col" : "row");
  expect(viewer.alerts.map(({ text }) => text)).toEqual(["A page has 6 panes at most: close one first."]);
});

test("a preset keeps the settings of the page, and compares with another robot", () => {
  open("#/14/2/field?at=5&field.trail=no");
  announce("/14/2/ball", "/14/3/ball", "/truth/world");
  viewer.arrangeAs(kPresets.find(({ name }) => name === "Compare")!);
  expect(viewer.get("at")).toBe("5");
  const robots = [1, 2, 3].map((number) => viewer.pane(number).robot);
  expect(new Set(robots)).toEqual(new Set(["14/2", "14/3"]));
});

test("a pane with a robot of its own leaves the page's robot alone", () => {
  open("#/14/2/field");
  announce("/14/2/ball", "/14/3/ball", "/truth/world");
  viewer.split("row");
  viewer.focused.set("robot", "14/3");
  expect([viewer.robot, viewer.pane(1).robot, viewer.pane(2).robot]).toEqual(["14/2", "14/2", "14/3"]);
  viewer.go({ robot: "14/2" });
  expect([viewer.pane(2).robot, viewer.pane(2).hasOwnRobot]).toEqual(["14/2", true]);
  expect(viewer.robot).toBe("14/2");
});

test("other servers are in the address, each once, and go when they are taken out of it", () => {
  expect(viewer.add("10.0.14.3")).toBe("");
  expect(viewer.add("10.0.14.3:8765")).toBe("10.0.14.3:8765 is watched already.");
  expect(viewer.add("robot:8765")).toBe("robot:8765 is watched already.");
  expect(viewer.add("http://")).not.toBe("");
  expect(viewer.servers.map(({ target }) => target.host)).toEqual(["robot:8765", "10.0.14.3:8765"]);
  expect(viewer.several).toBe(true);
  const [, other] = viewer.servers;
  other!.introduced({ name: "robot", capabilities: [], metadata: {} }, true, false);
  other!.advertised([{ ...kPerceptChannel, topic: "/14/3/ball", metadata: {} }]);
  expect(viewer.sources.map(({ key }) => key)).toEqual(["14/3@10.0.14.3:8765"]);
  page.follow("#/14/2/field");
  expect(viewer.servers).toHaveLength(1);
});

/** The server announces a recording, and reports whose playhead the connection has. */
function record(own: boolean) {
  const server = viewer.servers[0]!;
  const metadata = { own_playheads: "yes" };
  const span = { start_ns: 0n, end_ns: 100n * 10n ** 9n };
  server.introduced({ name: "lab", capabilities: ["playbackControl"], metadata, span }, true, false);
  server.advertised([{ ...kPerceptChannel, topic: "/14/2/ball", metadata: {} }]);
  server.services(["clock"]);
  server.playhead(own);
  server.playback({ status: "paused", time_ns: 0n, speed: 1, didSeek: false, request: "" });
  return server;
}

test("a page has its own time of a recording, and plays when it opens, unless a link asks for a moment", () => {
  for (const [hash, plays] of [
    ["#/14/2/field", true],
    ["#/14/2/field?at=5000000000", false],
  ] as const) {
    open(hash);
    const server = viewer.servers[0]!;
    const wishes = vi.spyOn(server, "ask").mockImplementation(() => {});
    record(true);
    expect([viewer.follows, viewer.time.shared, wishes.mock.calls.length > 0]).toEqual([false, false, plays]);
    viewer.frame();
    expect(viewer.time.at_ns).toBe(plays ? 0n : 5n * 10n ** 9n);
  }
});

test("a page that was paused before the first data stays paused", () => {
  open("#/14/2/field");
  viewer.time.toggle();
  const wishes = vi.spyOn(viewer.servers[0]!, "ask");
  record(true);
  viewer.frame();
  expect([wishes.mock.calls, viewer.time.runs]).toEqual([[], false]);
});

test("a speed that was chosen before the first data holds", () => {
  open("#/14/2/field");
  viewer.time.speed = 0.25;
  const wishes = vi.spyOn(viewer.servers[0]!, "ask");
  record(true);
  expect(wishes.mock.calls).toEqual([[{ play: true, speed: 0.25 }]]);
});

test("a page follows by its address or a button, and goes on in its own time by the same button", () => {
  open("#/14/2/field?follow&at=5000000000");
  const server = record(false);
  const chosen = vi.spyOn(server.client, "choosePlayhead");
  viewer.frame();
  expect([viewer.follows, viewer.time.shared, viewer.time.live]).toEqual([true, true, true]);
  viewer.setFollows(false);
  expect([page.href.includes("follow"), chosen.mock.lastCall]).toEqual([false, [true]]);
  server.playhead(true);
  expect(viewer.time.shared).toBe(false);
  viewer.setFollows(true);
  expect([page.href.includes("follow=yes"), chosen.mock.lastCall]).toEqual([true, [false]]);
  server.playhead(false);
  page.follow("#/14/2/field"); // a link without it
  expect(chosen.mock.lastCall).toEqual([true]);
});

test("a copied link opens at its moment and not in the shared time", () => {
  open("#/14/2/field?follow=yes");
  record(false);
  expect(viewer.link).toContain("at=0");
  expect(viewer.link).not.toContain("follow");
});

test("a sentence that a person dismissed stays away for a while", () => {
  viewer.say("warning", "the disk is full", "disk");
  viewer.say("warning", "the disk is still full", "disk");
  expect(viewer.alerts.map(({ text }) => text)).toEqual(["the disk is still full"]);
  viewer.mute("disk");
  viewer.say("warning", "the disk is full", "disk");
  expect(viewer.alerts).toEqual([]);
});
