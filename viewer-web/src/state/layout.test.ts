import { expect, test } from "vitest";
import { layoutOf, textOfLayout } from "./layout";
import type { Route } from "./route";

const route: Route = {
  robot: "14/2@10.0.14.2:8765",
  view: "plot",
  settings: new Map([
    ["with", "10.0.14.2:8765"],
    ["plot", "/14/2/ball.x /14/2/pose~truth"],
    ["layers", "truth,belief"],
    ["panes", "row(plot,col(field,plot):2)"],
    ["2.layers", "truth"],
    ["2.robot", "14/3@10.0.14.2:8765"],
    ["at", "17"],
    ["marks", "17~kick"],
    ["loop", "1-2"],
  ]),
};

test("a layout read again is the same, without its moments", () => {
  const { settings, ...rest } = route;
  expect(layoutOf(textOfLayout(route))).toEqual({ ...rest, settings: new Map([...settings].slice(0, 6)) });
});

test("a file that is no layout is refused with one sentence and its reason", () => {
  const with_ = (more: object) =>
    JSON.stringify({ foresight_layout: 1, robot: "14/2", view: "field", settings: {}, ...more });
  expect(layoutOf(with_({}))).toMatchObject({ view: "field" });
  const cases: [string, string][] = [
    ["", "it is not JSON"],
    ["[]", "expected an object"],
    ["{}", "expected 'foresight_layout' to be 1, got nothing"],
    [with_({ foresight_layout: 2 }), "expected 'foresight_layout' to be 1, got 2"],
    [with_({ view: "cinema" }), 'got "cinema"'],
    [with_({ robot: "<b>" }), `expected 'robot' to be like 14/2, got "<b>"`],
    [with_({ settings: [] }), "'settings' is no object"],
    [with_({ settings: { token: "x" } }), "the setting 'token' is not known"],
    [with_({ settings: { plot: 5 } }), "the setting 'plot' is no text"],
    [
      with_({ settings: { with: "robot:8765?token=x" } }),
      "the server 'robot:8765?token=x' must be host:port and nothing else",
    ],
    [with_({ settings: { panes: "row(field" } }), `got "row(field"`],
    [with_({ settings: { "2.robot": "<b>" } }), `expected '2.robot' to be like 14/2, got "<b>"`],
    [with_({ settings: { "7.layers": "truth" } }), "the setting '7.layers' is not known"],
    [with_({ settings: { "2.with": "x:1" } }), "the setting '2.with' is not known"],
    [with_({ settings: { plot: "x".repeat(30000) } }), "longer than 20000"],
  ];
  for (const [text, why] of cases)
    expect(layoutOf(text), text.slice(0, 60)).toEqual({ error: expect.stringContaining(why) });
});

test("every truncation is refused", () => {
  const text = textOfLayout(route).trimEnd();
  for (let length = 0; length < text.length; ++length) expect(layoutOf(text.slice(0, length))).toHaveProperty("error");
});
