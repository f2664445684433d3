import { expect, test } from "vitest";
import { hashOf, kViews, routeOf } from "./route";

const none = new Map<string, string>();

test("robot, view and settings survive the address", () => {
  const settings = new Map([
    ["with", "10.0.0.2:8765,[::1]:1"],
    ["plot", "/14/2/ball.x&=?#%+ ü"],
  ]);
  for (const robot of ["", "14/2", "team a/ü%", "14/2@10.0.0.2:8765"])
    for (const view of kViews)
      for (const some of [none, settings])
        expect(routeOf(hashOf({ robot, view, settings: some }))).toEqual({ robot, view, settings: some });
});

test("an address that makes no sense chooses nothing", () => {
  for (const hash of ["", "#", "#/", "#/nothing", "#/%ZZ", "#/a/b/c/d", "#/constructor"])
    expect(routeOf(hash)).toEqual({ robot: "", view: "", settings: none });
});

test("a view is found by its former name, and a token never stays", () => {
  expect(routeOf("#/14/2/rates")).toMatchObject({ robot: "14/2", view: "health" });
  expect(routeOf("#/field?token=secret&at=7").settings).toEqual(new Map([["at", "7"]]));
});
