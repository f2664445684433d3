import { expect, test } from "vitest";
import { addressOf, targetOf, targetOfHost } from "./target";

const nothing = () => "";
const kept = (host: string) => (host === "robot" ? "old" : "");

test("the page connects to its own host", () => {
  expect(targetOf("http://10.0.14.2:8765/#/14/2/camera", nothing)).toMatchObject({
    url: "ws://10.0.14.2:8765/live",
    host: "10.0.14.2:8765",
    ownHost: true,
  });
  expect(targetOf("https://lab.example/?x=1", nothing)).toMatchObject({ url: "wss://lab.example/live" });
});

test("a token goes to the socket and is removed from the address", () => {
  expect(targetOf("http://robot:8765/?token=s%26cret&a=b#/rates", nothing)).toMatchObject({
    url: "ws://robot:8765/live?token=s%26cret",
    token: "s&cret",
    cleanAddress: "http://robot:8765/?a=b#/rates",
  });
});

test("the token that this tab kept is used, and a new one replaces it", () => {
  expect(targetOf("http://robot/", kept)).toMatchObject({ url: "ws://robot/live?token=old" });
  expect(targetOf("http://robot/?token=new", kept)).toMatchObject({ url: "ws://robot/live?token=new" });
});

test("a token kept for one robot is not sent to another host", () => {
  expect(targetOf("http://robot/?ws=ws://elsewhere/", kept)).toMatchObject({ url: "ws://elsewhere/", token: "" });
});

test("?ws= names another robot, which is then not the page's own host", () => {
  expect(targetOf("http://lab/?ws=ws://other:8765/", nothing)).toMatchObject({
    url: "ws://other:8765/",
    ownHost: false,
  });
});

test("an invalid address is refused with a sentence", () => {
  for (const wanted of ["nonsense", "http://robot", "javascript:alert(1)"])
    expect(targetOf(`http://lab/?ws=${encodeURIComponent(wanted)}`, nothing)).toMatchObject({
      error: expect.stringContaining(`got '${wanted}'`),
    });
});

test("a person adds another robot by a typed or copied address", () => {
  const cases: [string, string][] = [
    ["10.0.14.2", "10.0.14.2:8765"],
    [" nao14.local:9000 ", "nao14.local:9000"],
    ["http://localhost:8801/#/14/2/field", "localhost:8801"],
    ["ws://[::1]:8766/live", "[::1]:8766"],
    ["http://lab:80", "lab:80"],
  ];
  for (const [typed, host] of cases) expect(addressOf(typed), typed).toEqual({ host, token: "" });
  expect(addressOf("http://robot:8765/?token=s%26cret")).toEqual({ host: "robot:8765", token: "s&cret" });
  for (const typed of [
    "",
    "a b",
    "javascript:alert(1)",
    "ftp://robot",
    "user:word@robot",
    "robot:port",
    "<b>",
    "https://robot",
  ])
    expect(addressOf(typed), typed).toEqual({ error: expect.any(String) });
  expect(targetOfHost("robot:8765", "x&y")).toMatchObject({
    url: "ws://robot:8765/live?token=x%26y",
    host: "robot:8765",
    ownHost: false,
  });
  expect(targetOfHost("a b", "")).toBeUndefined();
});
