import { expect, test } from "vitest";
import { reportsOf, sessionsOf } from "../source/http";
import { choiceOf, clockOf, lengthOf, otherViewers, partOf, secondsOf, startOf } from "./recording";

const kStart_ns = 1795269731000000000n; // 2026-11-21 14:02:11 UTC
const entry = (more: object) => ({ session: "s", start_ns: String(kStart_ns), ...more });

test("start and length are read from decimal strings of ns, whose digits a number could not hold", () => {
  const [session] = sessionsOf({ sessions: [entry({ end_ns: String(kStart_ns + 600_499_999_999n) })] })!;
  expect(startOf(session!, "en-GB", "UTC")).toBe("21 Nov 2026, 14:02:11");
  expect(lengthOf(session!)).toBe("10:00");
});

test("the start is the time of day, also if the robot's clock was set after its program began", () => {
  const of = (behind_ns: unknown) => sessionsOf({ sessions: [entry({ behind_ns })] })![0]!;
  for (const none of [undefined, "0", 180e9, "x", "", "-0"]) {
    expect(clockOf(of(none))).toBe("");
    expect(startOf(of(none), "en-GB", "UTC")).toBe("21 Nov 2026, 14:02:11");
  }
  expect(startOf(of("180000000000"), "en-GB", "UTC")).toBe("21 Nov 2026, 14:05:11");
  expect(clockOf(of("180000000000"))).toContain("3:00 behind the time of day");
  expect(startOf(of("-60000000000"), "en-GB", "UTC")).toBe("21 Nov 2026, 14:01:11");
  expect(clockOf(of("-60000000000"))).toContain("1:00 ahead of the time of day");
});

test("an empty or impossible recording has no length", () => {
  for (const times of [
    { start_ns: "", end_ns: "" },
    { start_ns: "0", end_ns: "0" },
    { end_ns: "1" },
    { end_ns: "x" },
    { end_ns: 7 },
  ])
    expect(lengthOf(sessionsOf({ sessions: [entry(times)] })![0]!)).toBe("–");
});

test("the newest recording comes first, those without a start last", () => {
  const sessions = sessionsOf({
    sessions: [
      entry({ session: "none", start_ns: "" }),
      entry({ session: "old" }),
      entry({ session: "new", start_ns: String(kStart_ns + 1n) }),
    ],
  })!;
  expect(sessions.map(({ session }) => session)).toEqual(["new", "old", "none"]);
});

test("entries that make no sense are left out, links lead only to the robot itself", () => {
  const urls = ["javascript:alert(1)", "//evil/x", "/\\evil", "https://evil/", 5, "/logs/s.mcap"];
  const sessions = sessionsOf({
    sessions: [5, null, {}, entry({ state: "odd", streams: urls.map((url) => ({ url })) })],
  })!;
  expect(sessions).toHaveLength(1);
  expect(sessions[0]).toMatchObject({ state: "unknown", kept: false, foxglove_url: "" });
  const drawn = (foxglove_url: string) => sessionsOf({ sessions: [entry({ foxglove_url })] })![0]!.foxglove_url;
  expect(urls.slice(0, 4).map((url) => drawn(url as string))).toEqual(["", "", "", ""]);
  expect(drawn("/logs/s.mcap?foxglove")).toBe("/logs/s.mcap?foxglove");
  expect(sessions[0]!.streams.map(({ url }) => url)).toEqual(["", "", "", "", "", "/logs/s.mcap"]);
  for (const answer of [undefined, 5, [], {}, { sessions: {} }]) expect(sessionsOf(answer)).toBeUndefined();
});

test("a recording of chosen objects names them, so that nobody takes the others for lost", () => {
  const said = (only: unknown) => choiceOf(sessionsOf({ sessions: [entry({ only })] })![0]!);
  for (const none of [undefined, [], "ball", [5, ""]]) expect(said(none)).toBe("");
  expect(said(["ball"])).toBe("Only chosen objects were recorded: ball.");
  expect(said(["ball", "pose", "truth/world"])).toBe("Only chosen objects were recorded: ball, pose and truth/world.");
  expect(said([..."abcdefg"])).toBe("Only chosen objects were recorded: a, b, c, d, e, f and g.");
  expect(said([..."abcdefgh"])).toBe("Only chosen objects were recorded: a, b, c, d, e, f and 2 more.");
});

test("reports are pages beside the recordings, and no other address", () => {
  const reports = ["report.html", "../x.html", "a/b.html", "javascript:x.html", ".html", 5, "x.htm", "a b.html"];
  expect(reportsOf({ reports })).toEqual(["report.html"]);
  for (const answer of [undefined, 5, [], {}, { reports: {} }]) expect(reportsOf(answer)).toEqual([]);
});

test("other viewers get the file's address; web pages only where they may read it", () => {
  const links = (url: string) => otherViewers(url).map((viewer) => new URL(viewer.url));
  for (const file of [
    "http://10.0.14.2:8765/logs/a b.mcap",
    "http://localhost:8765/logs/s.mcap",
    "https://lab/logs/s.mcap",
  ])
    for (const link of links(file)) {
      expect(link.searchParams.get("ds")).toBe("remote-file");
      expect(link.searchParams.get("ds.url")).toBe(file);
    }
  expect(links("http://10.0.14.2:8765/x").map(({ protocol }) => protocol)).toEqual(["lichtblick:", "https:"]);
  expect(links("http://10.0.14.2:8765/x")[1]!.searchParams.get("openIn")).toBe("desktop");
  expect(links("http://127.0.0.1:8765/x").map(({ protocol }) => protocol)).toEqual(["https:", "https:"]);
});

test("a part of a recording is typed in minutes and seconds, and requested in ns", () => {
  expect(["0:05", "65", "1:05.5", "1:00:00", "", "1:2:3:4", "x", "-1", "1:"].map(secondsOf)).toEqual([
    5,
    65,
    65.5,
    3600,
    undefined,
    undefined,
    undefined,
    undefined,
    undefined,
  ]);
  const session = { url: "/logs/s.mcap", start_ns: kStart_ns, end_ns: kStart_ns + 60_000_000_000n };
  expect(partOf(session, "", "")).toEqual({ url: "/logs/s.mcap" });
  expect(partOf(session, "0:01.5", "10")).toEqual({
    url: "/logs/s.mcap?from=1795269732500000000&to=1795269741000000000",
  });
  expect(partOf(session, "", "0:02")).toEqual({ url: "/logs/s.mcap?to=1795269733000000000" });
  expect(partOf(session, "soon", "")).toEqual({ error: "Expected minutes and seconds such as 1:05, got 'soon'." });
  expect(partOf(session, "5", "5")).toEqual({ error: "The part must end after it begins." });
  expect(partOf(session, "2:00", "")).toEqual({ error: "The recording is shorter than that." });
});
