import { afterEach, expect, test } from "vitest";
import { kFields } from "../draw/field";
import { kPerceptChannel } from "../memory/test_schema";
import { announce, closePage, openPage, type FakePage } from "./test_page";
import type { Viewer } from "./viewer.svelte";

let page: FakePage;
let viewer: Viewer;
const open = (hash: string) => void ({ page, viewer } = openPage(hash));
const ownServer = () => viewer.servers[0]!;
afterEach(() => closePage(viewer));

/** Two panes, the second with the view of `hash`; a second server has robot 14/3. */
function openTwo(view: string, settings = "") {
  open(`#/14/2/field?panes=row(field,${view})&with=other:8765${settings}`);
  announce(ownServer(), "/14/2/ball", "/14/2/game", "/truth/world");
  announce(viewer.servers[1]!, "/14/3/ball");
  return [viewer.pane(1), viewer.pane(2)] as const;
}

test("a pane shows its own robot while that is available, else the page's", () => {
  const [first, second] = openTwo("log");
  expect([first.robot, second.robot, second.hasOwnRobot]).toEqual(["14/2", "14/2", false]);
  second.set("robot", "14/3@other:8765");
  expect([first.robotKey, second.robotKey]).toEqual(["14/2", "14/3@other:8765"]);
  expect([second.robot, second.hasOwnRobot]).toEqual(["14/3", true]);
  viewer.servers[1]!.unadvertised([{ ...kPerceptChannel, topic: "/14/3/ball" }]);
  expect([second.robot, second.hasOwnRobot, second.get("robot")]).toEqual(["14/2", true, "14/3@other:8765"]);
});

test("its server and objects are those of the robot, or the page's own without a robot", () => {
  open("#/field");
  const pane = viewer.pane(1);
  expect([pane.server, pane.source, pane.robot, pane.robotKey]).toEqual([ownServer(), undefined, "", ""]);
  closePage(viewer);
  const [first, second] = openTwo("log", "&2.robot=14/3@other:8765");
  const [own, other] = viewer.servers;
  expect([first.server, second.server]).toEqual([own, other]);
  expect([first.memory, second.memory]).toEqual([own!.memory, other!.memory]);
  const topics = (pane: typeof first) => pane.objects.map(({ channel }) => channel.topic);
  expect(topics(first)).toEqual(["/14/2/ball", "/14/2/game", "/truth/world"]);
  expect(topics(second)).toEqual(["/14/3/ball"]);
});

test("it knows all servers with their robots, and the world of its own robot comes first", () => {
  const [first, second] = openTwo("log", "&2.robot=14/3@other:8765");
  const told = (pane: typeof first) => pane.told.map(({ robots, keyOf }) => robots.map(keyOf));
  expect(told(first)).toEqual([["14/2"], ["14/3@other:8765"]]);
  expect(told(second)).toEqual([["14/3@other:8765"], ["14/2"]]);
  expect(second.told[0]!.memory).toBe(second.memory);
});

test("time, past, servers and robots are the page's", () => {
  const [, second] = openTwo("log");
  expect(second.time).toBe(viewer.time);
  expect(second.past).toBe(viewer.past);
  expect(second.servers).toBe(viewer.servers);
  expect(second.sources.map(({ key }) => key)).toEqual(["14/2", "14/3@other:8765"]);
});

test("a pane has the view that the address gives it, and one that is not shown has the field", () => {
  const [first, second] = openTwo("log");
  expect([first.view, second.view, viewer.pane(3).view]).toEqual(["field", "log", "field"]);
});

test("the page's keys are for one pane", () => {
  const [first, second] = openTwo("log");
  expect([first.hasKeys, second.hasKeys]).toEqual([true, false]);
  viewer.focus(2);
  expect([first.hasKeys, second.hasKeys]).toEqual([false, true]);
});

test("a setting is the pane's own, or one of the whole page", () => {
  const [first, second] = openTwo("field");
  second.set("layers", "truth");
  expect([first.get("layers"), second.get("layers"), viewer.get("2.layers")]).toEqual(["", "truth", "truth"]);
  second.set("team", "yes");
  expect([first.get("team"), second.get("team"), viewer.get("team")]).toEqual(["yes", "yes", "yes"]);
  second.set("layers", "");
  expect(page.href).not.toContain("layers");
});

test("the field is that of the game, else the one that the person chose", () => {
  const [, second] = openTwo("field");
  expect(second.knownField().from).toBe("assumed");
  second.set("field", "spl2012");
  expect(second.knownField()).toEqual({ from: "chosen", field: kFields["spl2012"] });
});

test("the field can be that of another server", () => {
  const [first] = openTwo("field");
  const other = viewer.servers[1]!;
  const rules = { name: "lab", capabilities: [], metadata: { rules: "spl2012" } };
  const own = { name: "robot", capabilities: [], metadata: { rules: "hsl2026" } };
  ownServer().introduced(own, true, false);
  other.introduced(rules, true, false);
  expect(first.knownField(other)).toEqual({ from: "reported", field: kFields["spl2012"] });
  expect(first.knownField()).toEqual({ from: "reported", field: kFields["hsl2026"] });
});

test("it chooses a view of its own, and a robot for the whole page unless it has its own", () => {
  const [first, second] = openTwo("log");
  second.go({ view: "health" });
  expect([first.view, second.view]).toEqual(["field", "health"]);
  second.go({ robot: "14/3@other:8765" });
  expect([first.robot, second.robot, second.hasOwnRobot]).toEqual(["14/3", "14/3", false]);
  second.set("robot", "14/3@other:8765");
  second.go({ robot: "14/2" });
  expect([first.robot, second.robot, second.hasOwnRobot]).toEqual(["14/3", "14/2", true]);
});

test("a plotted number goes to the pane that shows the plot", () => {
  const [first, second] = openTwo("plot");
  first.plot("ball.x");
  first.plot("ball.y");
  expect([second.get("plot"), first.get("plot"), first.view]).toEqual(["ball.x ball.y", "", "field"]);
});

test("without such a pane, the pane itself becomes the plot", () => {
  const [first, second] = openTwo("log");
  second.plot("ball.x");
  expect([first.view, second.view, second.get("plot"), first.get("plot")]).toEqual(["field", "plot", "ball.x", ""]);
});

test("a curve is added once, and one of another server names it", () => {
  const [first, second] = openTwo("plot", "&2.robot=14/3@other:8765");
  first.addCurve("/14/2/ball.x", second);
  first.addCurve("/14/2/ball.x", second);
  second.addCurve("/14/3/ball.x");
  second.addCurve("/14/3/ball.x");
  second.addCurve("/14/3/ball.y@third:8765");
  expect(second.get("plot")).toBe("/14/2/ball.x /14/3/ball.x@other:8765 /14/3/ball.y@third:8765");
  expect(first.get("plot")).toBe("");
});
