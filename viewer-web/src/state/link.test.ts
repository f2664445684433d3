import { expect, test } from "vitest";
import { isOfThisComputer, linkOf } from "./link";
import { routeOf } from "./route";

const route = routeOf("#/14/2/plot?plot=ball.x&marks=7~kick%20off&at=1&session=old");

test("a link names session, moment, marks and settings, and never a token", () => {
  const link = linkOf("http://10.0.0.2:8765/?token=secret&x=1#/elsewhere", route, { session: "s 1", at_ns: 12n });
  expect(link).not.toContain("secret");
  expect(link.startsWith("http://10.0.0.2:8765/?x=1#/14/2/plot?")).toBe(true);
  expect(routeOf(new URL(link).hash)).toEqual({
    robot: "14/2",
    view: "plot",
    settings: new Map([
      ["plot", "ball.x"],
      ["marks", "7~kick off"],
      ["session", "s 1"],
      ["at", "12"],
    ]),
  });
});

test("without a session and a moment it names none", () => {
  const link = linkOf("http://nao:8765/", route, { session: "", at_ns: undefined });
  expect([...routeOf(new URL(link).hash).settings.keys()]).toEqual(["plot", "marks"]);
});

test("a link to this computer helps nobody else", () => {
  for (const address of ["http://localhost:1/", "http://127.0.0.2/", "http://[::1]:8765/"])
    expect(isOfThisComputer(address)).toBe(true);
  for (const address of ["http://10.0.0.2/", "http://localhost.example/"])
    expect(isOfThisComputer(address)).toBe(false);
});
