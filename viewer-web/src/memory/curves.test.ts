import { expect, test } from "vitest";
import { curveOf, curvesOf, partsOf, titleOf } from "./curves";

test("a setting is split into its curves, as in old links", () => {
  expect(curvesOf("/14/2/ball.x /14/2/pose~truth  /14/3/ball.x@host:1")).toEqual([
    "/14/2/ball.x",
    "/14/2/pose~truth",
    "/14/3/ball.x@host:1",
  ]);
  expect(curvesOf("")).toEqual([]);
  expect(curvesOf("max(ball.x, 2) /14/2/ball.x")).toEqual(["max(ball.x, 2)", "/14/2/ball.x"]);
  expect(curvesOf(`decision.role=="a b (" ball.x`)).toEqual([`decision.role=="a b ("`, "ball.x"]);
});

test("a curve of several expressions comes back as it was", () => {
  const texts = ["ball.x > 2 && ball.y < 1 / 2", "distance(ball, truth.ball)", "any ball.x > 2", `a.b == "c d" or e.f`];
  const curves = texts.map((text) => curveOf(text, []));
  expect(curvesOf(curves.join(" "))).toEqual(curves);
});

test("only what follows the last @ is a host", () => {
  expect(partsOf("distance(a.b,c.d)@10.0.14.3:8765")).toEqual({
    expression: "distance(a.b,c.d)",
    host: "10.0.14.3:8765",
  });
  expect(partsOf(`log.text=="me@home"`)).toEqual({ expression: `log.text=="me@home"`, host: undefined });
  expect(partsOf("ball.x")).toEqual({ expression: "ball.x", host: undefined });
});

test("a title is written for people", () => {
  expect(titleOf("distance(ball,truth.ball)@host:1", [])).toBe("distance(ball, truth.ball)@host:1");
  expect(titleOf("/14/2/joints.position[0]", ["/14/2/joints"])).toBe("/14/2/joints.position[head_yaw]");
  expect(titleOf("/14/2/pose~truth", ["/14/2/pose"])).toBe("/14/2/pose~truth");
});
