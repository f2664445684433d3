import { expect, test } from "vitest";
import { hashOf, kViews, routeOf } from "./route";

test("robot and view survive the address", () => {
  for (const robot of ["", "14/2", "team a/ü%"])
    for (const view of kViews) expect(routeOf(hashOf({ robot, view }))).toEqual({ robot, view });
});

test("an address that makes no sense chooses nothing", () => {
  for (const hash of ["", "#", "#/", "#/nothing", "#/%ZZ", "#/a/b/c/d"]) expect(routeOf(hash)).toEqual({ robot: "", view: "" });
});
