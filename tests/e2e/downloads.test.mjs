// Recordings over HTTP, as browsers, download managers and other viewers request them.
import assert from "node:assert/strict";
import { rmSync, symlinkSync, unlinkSync } from "node:fs";
import http from "node:http";
import net from "node:net";
import { join } from "node:path";
import { test } from "node:test";
import { Live } from "./live.mjs";
import { readSession, readStreamed, spanOf } from "./mcap.mjs";
import {
  download,
  play,
  recordedSession,
  request,
  robot,
  run,
  sessionsOf,
  statusOf,
  synthesize,
  temporaryFolder,
  until,
  within,
} from "./support.mjs";

/** Starts a server with one complete recording; returns both, the recording as bytes. */
async function served(t) {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await synthesize(folder, { seconds: 1 }), "--speed", "1000");
  const path = "/logs/synthetic.mcap";
  const { headers, body, status } = await request(server, path);
  assert.equal(status, 200);
  return { server, folder, path, whole: body, etag: headers.etag, headers };
}

const get = (server, path, headers, method = "GET") => request(server, path, { headers, method });

test("a download has size, type, name, tag, and accepts ranges", async (t) => {
  const { server, path, whole, headers, etag } = await served(t);
  assert.equal(headers["content-length"], String(whole.length));
  assert.equal(headers["accept-ranges"], "bytes");
  assert.equal(headers["content-type"], "application/octet-stream");
  assert.equal(headers["content-disposition"], 'attachment; filename="synthetic.mcap"');
  assert.equal(headers["content-encoding"], undefined);
  assert.match(etag, /^"[^"]+"$/);
  assert.equal((await request(server, path)).headers.etag, etag);
  assert.equal(readStreamed(whole).topics.size, 17);

  const head = await get(server, path, {}, "HEAD");
  assert.deepEqual(
    [head.status, head.headers["content-length"], head.headers.etag, head.body.length],
    [200, String(whole.length), etag, 0],
  );
  const stream = await request(server, "/logs/synthetic/14.2.fsr.mcap");
  assert.deepEqual([...readStreamed(stream.body).topics.keys()], ["/14/2/fsr"]);
  assert.equal(stream.headers["content-disposition"], 'attachment; filename="synthetic.14.2.fsr.mcap"');
});

test("ranges: first, last, middle, past the end, and invalid ones", async (t) => {
  const { server, path, whole } = await served(t);
  const size = whole.length;
  const cases = [
    ["bytes=0-0", 0, 1],
    ["bytes=0-99", 0, 100],
    ["bytes=100-", 100, size],
    ["bytes=-10", size - 10, size],
    [`bytes=-${size + 10}`, 0, size],
    [`bytes=${size - 1}-${size + 99}`, size - 1, size],
  ];
  for (const [range, begin, end] of cases) {
    const part = await get(server, path, { range });
    assert.equal(part.status, 206, range);
    assert.equal(part.headers["content-range"], `bytes ${begin}-${end - 1}/${size}`, range);
    assert.ok(part.body.equals(whole.subarray(begin, end)), range);
  }
  for (const range of [`bytes=${size}-`, "bytes=-0", `bytes=${size + 5}-${size + 9}`]) {
    const none = await get(server, path, { range });
    assert.deepEqual([none.status, none.headers["content-range"]], [416, `bytes */${size}`], range);
  }
  // an invalid range or several ranges get the whole file as answer, as RFC 9110 allows
  for (const range of [
    "bytes=5-2",
    "bytes=a-b",
    "lines=1-2",
    "bytes=0-1,5-6",
    "bytes=-",
    "bytes=0-99999999999999999999999",
  ])
    assert.equal((await get(server, path, { range })).status, 200, range);
  const head = await get(server, path, { range: "bytes=0-9" }, "HEAD");
  assert.ok([200, 206].includes(head.status) && head.body.length === 0);
});

test("any consecutive ranges together are the whole file", async (t) => {
  const { server, path, whole } = await served(t);
  let seed = 1; // the same cuts each time
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const pieces = [];
  for (let at = 0; at < whole.length;) {
    const end = Math.min(whole.length, at + Math.ceil(random() ** 3 * 400000));
    pieces.push((await get(server, path, { range: `bytes=${at}-${end - 1}` })).body);
    at = end;
  }
  assert.ok(pieces.length > 20);
  assert.ok(Buffer.concat(pieces).equals(whole));
});

test("conditions: an unchanged file is not sent twice, a changed one is sent whole", async (t) => {
  const { server, path, whole, etag } = await served(t);
  for (const tags of [etag, `W/${etag}`, `"other", ${etag}`, "*"]) {
    const same = await get(server, path, { "if-none-match": tags });
    assert.deepEqual([same.status, same.body.length, same.headers.etag], [304, 0, etag], tags);
  }
  assert.equal((await get(server, path, { "if-none-match": '"other"' })).status, 200);

  const range = "bytes=10-19";
  assert.equal((await get(server, path, { range, "if-range": etag })).status, 206);
  const changed = await get(server, path, { range, "if-range": '"other"' });
  assert.equal(changed.status, 200);
  assert.ok(changed.body.equals(whole));
});

test("pages of accepted origins may read recordings: CORS", async (t) => {
  const { server, path } = await served(t);
  const lichtblick = "http://localhost:8080";
  const { headers } = await get(server, path, { origin: lichtblick, range: "bytes=0-9" });
  assert.equal(headers["access-control-allow-origin"], lichtblick);
  const exposed = headers["access-control-expose-headers"].toLowerCase();
  for (const name of ["accept-ranges", "content-length", "content-range", "etag"])
    assert.ok(exposed.includes(name), name);
  assert.match(headers.vary, /Origin/);

  const preflight = {
    origin: lichtblick,
    "access-control-request-method": "GET",
    "access-control-request-headers": "range",
  };
  const allowed = await get(server, path, preflight, "OPTIONS");
  assert.ok(allowed.status === 204 && /range/i.test(allowed.headers["access-control-allow-headers"]));
  const stranger = await get(server, path, { ...preflight, origin: "https://evil.example" }, "OPTIONS");
  assert.equal(stranger.headers["access-control-allow-origin"], undefined);
});

test("a recording that grows is redirected to a part that does not, byte for byte", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder, { seconds: 8 }), "--record", "--profile", "full");
  const session = await recordedSession(server);
  const path = `/logs/${session}.mcap`;
  const redirected = () => request(server, path, { headers: { range: "bytes=0-" } });

  // at first no part may be old enough
  const location = await until(async () => {
    const { status, headers, body } = await redirected();
    if (status === 404 && /there is no stream/.test(body)) return false; // no file is open yet
    assert.equal(status, 307, String(body));
    assert.match(headers.location, new RegExp(`^${path}\\?until=\\d+$`));
    const part = await request(server, headers.location);
    if (part.status === 404) return false; // no file is open yet
    const { topics } = readStreamed(part.body);
    return (topics.get("/14/2/joints")?.messages.length ?? 0) > 50 && headers.location;
  }, "joints in the download");
  assert.equal((await redirected()).headers["cache-control"], "no-store");
  assert.match(
    (await request(server, `${path}?from=1`, { headers: { range: "bytes=0-" } })).headers.location,
    /\?from=1&until=\d+$/,
  );

  // without a range it is sent at once, also to programs that follow no redirect
  const whole = await request(server, path);
  assert.equal(whole.status, 200);
  assert.match(whole.headers["content-location"], new RegExp(`^${path}\\?until=\\d+$`));
  assert.ok(readStreamed(whole.body).topics.get("/14/2/joints").messages.length > 50);

  // on a busy machine the recorder may be more than the two seconds behind at first
  const size_bytes = async () => (await statusOf(server)).recording.bytes;
  const first = await until(async () => {
    const earlier = await request(server, location);
    const before = await size_bytes();
    await until(async () => (await size_bytes()) > before, "the recording to grow");
    const later = await request(server, location);
    assert.equal(later.headers.etag === earlier.headers.etag, later.body.equals(earlier.body));
    return later.headers.etag === earlier.headers.etag && later;
  }, "a part that stays as it is");

  // a download that is resumed during recording is complete, too
  const tail = await get(server, location, { range: "bytes=1000-", "if-range": first.headers.etag });
  assert.equal(tail.status, 206);
  assert.ok(Buffer.concat([first.body.subarray(0, 1000), tail.body]).equals(first.body));
  const until_ns = BigInt(/until=(\d+)/.exec(location)[1]);
  for (const { messages } of readStreamed(first.body).topics.values())
    assert.ok(messages.every(({ logTime }) => logTime <= until_ns));
});

test("a recording of a killed robot lacks less than its last two seconds", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 8 });
  const robotServer = await robot(t, folder, session, "--record", "--profile", "full");
  const live = await Live.open(t, robotServer);
  const id = await recordedSession(robotServer);
  const { first_ns: start_ns } = spanOf(readSession(session));
  await live.until(() => live.times.at(-1) > start_ns + 4_000_000_000n, "four seconds of recording");
  const { time_ns } = await statusOf(robotServer); // at speed 1 capture times run like ours
  robotServer.kill("SIGKILL");
  await within(robotServer.ended, "the end");

  // another runtime finds the session
  const server = await robot(t, folder, session, "--speed", "1000");
  const [found] = await sessionsOf(server);
  assert.deepEqual([found.session, found.state], [id, "recovered"]);
  assert.match(found.message, /ended without warning/);
  const { topics } = readStreamed(await download(server, found.url));
  // one second more than promised, for a busy machine
  const safe_ns = BigInt(time_ns) - 2_000_000_000n;
  for (const [topic, { messages }] of readSession(session)) {
    if (["/14/2/log", "/14/2/runtime", "/14/2/clock"].includes(topic)) continue;
    const expected = messages.filter(({ logTime }) => logTime <= safe_ns);
    const got = topics.get(topic)?.messages ?? [];
    assert.ok(got.length >= expected.length, `${topic}: ${got.length} of ${expected.length} messages`);
    assert.ok(
      expected.every(({ logTime, data }, i) => got[i].logTime === logTime && got[i].data.equals(data)),
      topic,
    );
  }
});

test("a session whose path ends with a slash is listed and served", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, `${await synthesize(folder, { seconds: 1 })}/`);
  assert.deepEqual(
    (await sessionsOf(server)).map(({ session }) => session),
    ["synthetic"],
  );
  assert.equal((await request(server, "/logs/synthetic.mcap")).status, 200);
});

test("a recording begins when the log folder can be used", async (t) => {
  const folder = temporaryFolder(t);
  symlinkSync("logs", join(folder, "logs"));
  const server = await robot(t, folder, await synthesize(folder), "--record", "--loop");
  const recording = async () => (await statusOf(server)).recording;
  const { state, message } = await recording();
  assert.equal(state, "disk_full");
  assert.match(
    message,
    /^the recording begins when the disk permits it; cannot make the folder .*: Too many levels of symbolic links$/,
  );
  unlinkSync(join(folder, "logs"));
  await until(
    async () => (await recording()).state === "recording",
    "the recording to begin",
    undefined,
    () => server.output,
  );
});

test("a recording whose log folder is deleted says so and begins anew", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder), "--record", "--loop");
  const recording = async () => (await statusOf(server)).recording;
  await until(async () => (await recording()).messages > 100, "messages in the recording");
  rmSync(join(folder, "logs"), { recursive: true });
  const { dropped, message } = await until(async () => {
    const status = await recording();
    return status.dropped > 0 && status;
  }, "the loss to be noticed");
  const lost =
    /^session \S+: its files were deleted, replaced or moved while it was recorded; messages lost: (\d+)$/.exec(
      message,
    );
  assert.ok(lost && lost[1] > 0 && lost[1] <= dropped, `${message}; ${dropped} dropped`);
  await until(async () => (await recording()).messages > 0, "messages in the new recording");
});

test("a second runtime leaves the session that the first records alone", async (t) => {
  const folder = temporaryFolder(t);
  const played = await synthesize(folder);
  const first = await robot(t, folder, played, "--record", "--loop");
  const session = await recordedSession(first);
  const second = await robot(t, folder, played, "--log-mb", "0");
  const [found] = await sessionsOf(second);
  assert.deepEqual([found.session, found.state], [session, "recording"]);
  assert.equal((await request(second, `/logs/${session}`, { method: "DELETE" })).status, 409);
});

test("a wrong profile or name ends the program with one sentence", async (t) => {
  const folder = temporaryFolder(t);
  const words = [
    "--body",
    "replay",
    "--session",
    await synthesize(folder),
    "--port",
    "0",
    "--log-dir",
    folder,
    "--record",
  ];
  const named = await run("foresight-robot", ...words, "--name", "x".repeat(5000));
  assert.deepEqual(
    [named.status, named.stderr],
    [2, "foresight-robot: --name: session name: expected at most 100 bytes, got 5000\n"],
  );
  const profiled = await run("foresight-robot", ...words, "--profile", "all");
  assert.deepEqual(
    [profiled.status, profiled.stderr],
    [2, "foresight-robot: --profile: recording profile: expected one of game, vision, full, got 'all'\n"],
  );
});

/** Sends `head` unchanged and returns the whole answer; http.request would change it. */
function raw(server, head) {
  const socket = net.connect(server.port, "127.0.0.1");
  let text = "";
  return within(
    new Promise((resolve, reject) => {
      socket.on("data", (bytes) => (text += bytes.toString("latin1")));
      socket.on("error", reject);
      socket.on("close", () => resolve(text));
      socket.write(head);
    }),
    "the answer to a raw request",
  ).finally(() => socket.destroy());
}

test("no path leads out of the log folder", async (t) => {
  const { server } = await served(t);
  const paths = [
    "/logs/../synthetic/session.json",
    "/logs/%2e%2e/state/token",
    "/logs/..%2fstate%2ftoken",
    "/logs/synthetic/..%2f..%2fstate/token",
    "/logs/synthetic/../../state/token",
    "/logs/%2e%2e%2fstate%2ftoken.mcap",
    "/logs/..\\state\\token.mcap",
    "/logs/....//state/token.mcap",
    "/logs/../../../../etc/passwd",
    "//etc/passwd",
    "/logs//etc/passwd.mcap",
    "/logs/%00.mcap",
    "/logs/synthetic%00.mcap",
    "/logs/%252e%252e%252fstate.mcap",
    "/logs/synthetic/session.json",
    "/logs/.hidden.mcap",
    "/logs/synthetic/.mcap",
    "/assets/../../state/token",
    "/assets/%2e%2e/index.html",
    "/logs/synthetic.mcap/../../state/token",
    "http://localhost/../state/token",
    "logs/synthetic.mcap",
    "/logs/state/token.mcap",
    "*",
    "",
  ];
  for (const path of paths) {
    const answer = await raw(server, `GET ${path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n`);
    assert.match(answer, /^HTTP\/1\.1 40[04] /, path);
    assert.doesNotMatch(answer, /[0-9a-f]{32}|root:|"complete"/, path);
  }
});

test("a client that disconnects during a download harms no other", async (t) => {
  const { server, path, whole } = await served(t);
  const abort = () =>
    new Promise((resolve) => {
      const sent = http.get({ host: "127.0.0.1", port: server.port, path, agent: false }, (response) => {
        response.once("data", () => resolve(sent.destroy()));
        response.on("error", () => {});
      });
      sent.on("error", () => {});
    });
  for (let i = 0; i < 5; ++i) await within(Promise.all(Array.from({ length: 10 }, abort)), "ten aborted downloads");
  assert.ok((await download(server, path)).equals(whole));
  assert.equal((await statusOf(server)).clients, 0);
});

test("many downloads at the same time are all complete", async (t) => {
  const { server, path, whole } = await served(t);
  for (const body of await Promise.all(Array.from({ length: 12 }, () => download(server, path))))
    assert.ok(body.equals(whole));
});
