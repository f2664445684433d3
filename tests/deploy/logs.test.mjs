// scripts/logs against a small server with the robot's API: the copied files, their order, and deletions on the robot.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { dayOf } from "../../robot/deploy/day.mjs";
import { root, temporaryFolder } from "../e2e/support.mjs";
import { serveRecordings } from "./recordings_server.mjs";

const bytes = (size, seed = 1) =>
  Buffer.from(Array.from({ length: size }, (_, i) => (i * 31 + seed * 17 + (i >> 8)) & 255));
const json = (value) => Buffer.from(JSON.stringify(value));
const day = dayOf("1795321006961272091");

/** A session of a small stream, a big one, and images. */
const session = (seed) => ({
  files: {
    "14.2.ball.mcap": bytes(1000, seed),
    "14.2.joints.mcap": bytes(1500000, seed),
    "14.2.camera_top.mcap": bytes(2000, seed),
    "session.json": json({ seed }),
  },
  schemas: { "14.2.camera_top.mcap": "foresight.Image" },
});

/** A person's folder with robots that are these servers: {folder, logs}; logs() answers {status, output}. */
function person(t, servers) {
  const folder = temporaryFolder(t);
  const robots = Object.entries(servers).map(([name, { port }], index) => ({
    name,
    address: "127.0.0.1",
    model: "nao-v6",
    player: index + 1,
    http_port: port,
    ssh_port: 100 + index,
  }));
  writeFileSync(join(folder, "robots.json"), JSON.stringify({ team: 14, robots }));
  const logs = (...words) =>
    new Promise((done) => {
      const env = { ...process.env, FORESIGHT_ROBOTS: join(folder, "robots.json") };
      execFile(join(root, "scripts/logs"), words, { cwd: folder, env }, (error, stdout, stderr) =>
        done({ status: error?.code ?? 0, output: stdout + stderr }),
      );
    });
  return { folder, logs };
}

/** The files of a session as they have arrived: name -> bytes. */
function arrived(folder, robot, id, out = "logs") {
  const path = join(folder, out, day, robot, id);
  return existsSync(path)
    ? Object.fromEntries(
        readdirSync(path)
          .sort()
          .map((name) => [name, readFileSync(join(path, name))]),
      )
    : {};
}
const sorted = (files) => Object.fromEntries(Object.entries(files).sort(([a], [b]) => (a < b ? -1 : 1)));

// each test has its own folder, and mostly waits
describe("logs", { concurrency: true }, () => {
  test("all sessions arrive bit for bit; a second run reads nothing again", async (t) => {
    const sessions = { one: session(1), two: session(2) };
    const robot = await serveRecordings(t, sessions);
    const { folder, logs } = person(t, { tim: robot });
    const { status, output } = await logs("tim");
    assert.equal(status, 0, output);
    for (const id of ["one", "two"]) assert.deepEqual(arrived(folder, "tim", id), sorted(sessions[id].files));
    assert.match(output, new RegExp(`tim {2}2 sessions, 3.0 MB, in logs/${day}/tim\n$`));

    robot.asked.length = 0;
    assert.deepEqual(await logs("tim"), { status: 0, output: "tim  nothing new; 2 here already\n" });
    assert.deepEqual(robot.asked, ["GET /api/sessions"]);
  });

  test("the small files of all robots come before the big ones of any", async (t) => {
    const asked = [];
    const servers = {};
    for (const name of ["tim", "lea"]) {
      servers[name] = await serveRecordings(t, { one: session(1), two: session(2) });
      servers[name].asked = asked;
    }
    const { logs } = person(t, servers);
    assert.equal((await logs("tim", "lea")).status, 0);
    const isBig = asked.filter((line) => line.includes("/files/")).map((line) => line.includes("joints"));
    assert.deepEqual(isBig, [...Array(12).fill(false), ...Array(4).fill(true)]);
  });

  test("with --no-images the images stay on the robot, and so does the session; a later run fetches them", async (t) => {
    const sessions = { one: session(1) };
    const robot = await serveRecordings(t, sessions);
    const { folder, logs } = person(t, { tim: robot });
    assert.equal((await logs("tim", "--no-images", "--delete", "--token", robot.token, "--out", "here")).status, 0);
    assert.deepEqual(Object.keys(arrived(folder, "tim", "one", "here")), [
      "14.2.ball.mcap",
      "14.2.joints.mcap",
      "session.json",
    ]);
    assert.deepEqual((await logs("tim", "--no-images", "--out", "here")).output, "tim  nothing new; 1 here already\n");
    assert.deepEqual(Object.keys(sessions), ["one"]);
    assert.equal((await logs("tim", "--out", "here")).status, 0);
    assert.deepEqual(arrived(folder, "tim", "one", "here"), sorted(sessions.one.files));
  });

  test("a session that the robot is still reading is awaited, so that its images stay there", async (t) => {
    const sessions = { one: { ...session(1), unread: 2 } };
    const robot = await serveRecordings(t, sessions);
    const { folder, logs } = person(t, { tim: robot });
    assert.equal((await logs("tim", "--no-images")).status, 0);
    assert.equal(robot.asked.filter((line) => line === "GET /api/sessions").length, 3);
    assert.equal(arrived(folder, "tim", "one")["14.2.camera_top.mcap"], undefined);
  });

  test("only complete sessions are deleted", async (t) => {
    const sessions = {
      one: session(1),
      kept: { ...session(2), kept: true },
      now: { ...session(3), state: "recording" },
      broken: session(4),
    };
    const whole = sorted(sessions.one.files);
    const robot = await serveRecordings(t, sessions);
    robot.fail = (path, response) =>
      path === "/logs/broken/files/14.2.ball.mcap" &&
      response.writeHead(200, { "content-length": 1000 }).end(bytes(1000, 99));
    const { folder, logs } = person(t, { tim: robot });
    const failed = await logs("tim", "--delete", "--token", robot.token);
    assert.equal(failed.status, 1);
    assert.match(failed.output, /FAILED: broken\/14.2.ball.mcap: the downloaded file does not have the checksum/);
    assert.deepEqual(Object.keys(sessions), ["one", "kept", "now", "broken"], "a robot that failed keeps all");

    robot.fail = undefined;
    const { status, output } = await logs("tim", "--delete", "--token", robot.token);
    assert.equal(status, 0, output);
    assert.match(output, /3 sessions, 4.5 MB, in .*; 1 still being recorded; 2 deleted on the robot/);
    assert.deepEqual(Object.keys(sessions), ["kept", "now"]);
    assert.deepEqual(arrived(folder, "tim", "one"), whole);
  });

  test("with a wrong token nothing is deleted, and a sentence reports it", async (t) => {
    const sessions = { one: session(1) };
    const { logs } = person(t, { tim: await serveRecordings(t, sessions) });
    const { output } = await logs("tim", "--delete", "--token", "87654321");
    assert.match(output, /one stays on the robot: the control token is missing or wrong/);
    assert.deepEqual(Object.keys(sessions), ["one"]);
  });

  /** Makes the big stream's transfer break near its middle, `times` times. */
  function cutBig(robot, big, times) {
    robot.fail = (path, response) => {
      if (!path.endsWith("joints.mcap") || times-- <= 0) return false;
      const from = Number(/\d+/.exec(response.req.headers.range ?? "0")[0]);
      response.writeHead(from > 0 ? 206 : 200, {
        "content-length": big.length - from,
        "content-range": `bytes ${from}-${big.length - 1}/${big.length}`,
      });
      response.write(big.subarray(from, Math.max(from, 700000)), () => response.destroy());
      return true;
    };
  }

  test("a transfer that was cut continues within the same command", async (t) => {
    const sessions = { one: session(1) };
    const robot = await serveRecordings(t, sessions);
    const { folder, logs } = person(t, { tim: robot });
    cutBig(robot, sessions.one.files["14.2.joints.mcap"], 2);
    assert.equal((await logs("tim")).status, 0);
    assert.deepEqual(arrived(folder, "tim", "one"), sorted(sessions.one.files));
    assert.match(robot.asked.at(-1), /joints.mcap bytes=[1-9]\d+-$/);
  });

  test("a robot that does not come back is given up, and the next command continues", async (t) => {
    const sessions = { one: session(1) };
    const big = sessions.one.files["14.2.joints.mcap"];
    const robot = await serveRecordings(t, sessions);
    const { folder, logs } = person(t, { tim: robot });
    cutBig(robot, big, Infinity);
    const { status, output } = await logs("tim");
    assert.equal(status, 1);
    assert.match(output, /tim {2}FAILED: the connection was lost/);
    const part = arrived(folder, "tim", "one")["14.2.joints.mcap.part"];
    assert.ok(part.length > 0 && part.equals(big.subarray(0, part.length)));

    robot.fail = undefined;
    assert.equal((await logs("tim")).status, 0);
    assert.ok(robot.asked.at(-1).endsWith(`joints.mcap bytes=${part.length}-`));
    assert.deepEqual(arrived(folder, "tim", "one"), sorted(sessions.one.files));
  });

  test("a part of another file, or a part that is too long, is deleted", async (t) => {
    const sessions = { one: session(1) };
    const robot = await serveRecordings(t, sessions);
    const { folder, logs } = person(t, { tim: robot });
    const path = join(folder, "logs", day, "tim", "one");
    mkdirSync(path, { recursive: true });
    writeFileSync(join(path, "14.2.ball.mcap.part"), bytes(300, 77));
    writeFileSync(join(path, "14.2.camera_top.mcap.part"), bytes(5000, 77));
    writeFileSync(join(path, "session.json.part"), bytes(sessions.one.files["session.json"].length, 77));
    const { status, output } = await logs("tim");
    assert.equal(status, 0, output);
    assert.deepEqual(arrived(folder, "tim", "one"), sorted(sessions.one.files));
  });

  test("during a game a robot reports it; the others continue", async (t) => {
    const tim = await serveRecordings(t, { one: session(1) });
    const lea = await serveRecordings(t, { two: session(2) });
    tim.fail = (path, response) => (
      response.writeHead(503).end('{"error": "game in progress: come back after FINISHED"}'),
      true
    );
    const { folder, logs } = person(t, { tim, lea });
    const { status, output } = await logs("tim", "lea");
    assert.equal(status, 1);
    assert.match(output, /tim {2}FAILED: game in progress: come back after FINISHED/);
    assert.equal(Object.keys(arrived(folder, "lea", "two")).length, 4);
  });

  test("names that lead out of the folder are refused", async (t) => {
    for (const sessions of [
      { "..": session(1) },
      { "a/../../b": session(1) },
      { one: { files: { "../../.bashrc": bytes(10) } } },
      { one: { files: { ".ssh": bytes(10) } } },
    ]) {
      const { folder, logs } = person(t, { tim: await serveRecordings(t, sessions) });
      const { status, output } = await logs("tim");
      assert.equal(status, 1);
      assert.match(output, /FAILED: expected names of letters, digits, _, \+, \. and -, got/);
      assert.deepEqual(readdirSync(folder), ["robots.json"]);
    }
  });

  test("invalid answers give one sentence", async (t) => {
    const robot = await serveRecordings(t, { one: session(1) });
    const { logs } = person(t, { tim: robot });
    for (const [body, says] of [
      ["<html>", /api\/sessions: expected JSON, got '<html>'/],
      ["{}", /expected a list of sessions/],
      ['{"sessions": [{"session": "one"}]}', /expected a list of sessions/],
    ]) {
      robot.fail = (path, response) => (response.end(body), true);
      assert.match((await logs("tim")).output, says);
    }
    robot.fail = (path, response) =>
      path.endsWith("/files") && (response.end('{"files": [{"name": "x.mcap", "size_bytes": -1}]}'), true);
    assert.match((await logs("tim")).output, /expected a list of files/);
  });

  test("a robot without a runtime is reported", async (t) => {
    const { logs } = person(t, { tim: { port: 1 } });
    assert.deepEqual(await logs("tim"), {
      status: 1,
      output:
        "tim  FAILED: no runtime answers at port 1 of 127.0.0.1: it is off, stopped, or silent because a game is in progress\n",
    });
  });
});
