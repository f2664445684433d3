// Rights to watch and to control: Host, Origin and token by the rules for other machines and pages, and failures at the start.
import assert from "node:assert/strict";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import net from "node:net";
import { hostname } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { Live, refusal } from "./live.mjs";
import { needsNetwork, own, play, request, robot, run, synthesize, temporaryFolder, within } from "./support.mjs";

// an address of this machine that is not loopback

async function served(t, ...args) {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 1 });
  return { folder, session, server: await play(t, folder, session, "--speed", "1000", ...args) };
}

// names of this machine
const first = hostname().split(".")[0];
const names = [hostname(), first, `${first}.local`];

test("a Host is accepted if it is an address, localhost, our own name or configured; a refusal names the option", async (t) => {
  const { server } = await served(t, "--allow-host", "nao14.lab");
  const port = server.port;
  const accepted = [
    "localhost",
    `localhost:${port}`,
    "127.0.0.1",
    `[::1]:${port}`,
    "10.0.14.2:80",
    "NAO14.lab:1",
    "LocalHost",
    ...names,
    `${first}.local:${port}`,
  ];
  const refused = [
    "evil.example",
    "evil.local",
    "localhost.evil.example",
    `${first}.local.evil.example`,
    ".local",
    "local",
    "10.0.14.2.evil.example",
    "127.0.0.1:x",
    "[::1",
    "a b",
  ];
  for (const host of accepted) {
    assert.equal((await request(server, "/api/status", { headers: { host } })).status, 200, host);
    await (await Live.open(t, server, { headers: { host } })).socket.terminate();
  }
  for (const host of refused) {
    for (const path of ["/", "/api/status", "/api/sessions", "/logs/synthetic.mcap"]) {
      const { status, body } = await request(server, path, { headers: { host } });
      assert.equal(status, 403, `${host} ${path}`);
      assert.match(body.toString(), /--allow-host/);
    }
    const { status, text } = await refusal(server, { headers: { host } });
    assert.equal(status, 403);
    assert.match(text, /--allow-host/);
  }
  const sentence = (await request(server, "/", { headers: { host: "robot.lab:8765" } })).body.toString();
  assert.equal(
    sentence,
    "host 'robot.lab:8765' is not a name of this robot; if it is, start it with --allow-host robot.lab\n",
  );
});

test("a page of an Origin may connect if it is our own, local, a file, Foxglove or configured; a refusal names the option", async (t) => {
  const { server } = await served(t, "--allow-origin", "https://lab.example");
  const accepted = [
    undefined,
    `http://localhost:${server.port}`,
    "http://localhost:9",
    "https://localhost",
    "http://127.0.0.1:1",
    "http://[::1]:5",
    "file://",
    "https://app.foxglove.dev",
    "https://lab.example",
    "HTTPS://LAB.example",
  ];
  const refused = [
    "null",
    "https://evil.example",
    "http://localhost.evil.example",
    "https://app.foxglove.dev.evil.example",
    "http://app.foxglove.dev",
    "https://lab.example:444",
    "http://10.0.14.2:8765",
    "chrome-extension://abc",
    "",
    "http://",
  ];
  for (const origin of accepted) {
    const live = await Live.open(t, server, { headers: origin === undefined ? {} : { origin } });
    live.socket.terminate();
    if (origin === undefined) continue;
    const { headers } = await request(server, "/api/status", { headers: { origin } });
    assert.equal(headers["access-control-allow-origin"], origin);
  }
  for (const origin of refused) {
    const { status, text } = await refusal(server, { headers: { origin } });
    assert.equal(status, 403, origin);
    assert.match(text, /--allow-origin/);
    assert.equal(
      (await request(server, "/api/status", { headers: { origin } })).headers["access-control-allow-origin"],
      undefined,
      origin,
    );
  }
  // a page of the same name and port as the robot's Host is the robot's own
  await Live.open(t, server, { headers: { host: `${first}.local:8765`, origin: `http://${first}.local:8765` } });
  assert.equal(
    (await refusal(server, { headers: { host: `${first}.local:8765`, origin: `http://${first}.local:80` } })).status,
    403,
  );
});

test("every page comes with a strict Content-Security-Policy and no referrer", async (t) => {
  const { server } = await served(t);
  for (const path of ["/", "/logs/", "/api/status"]) {
    const { headers } = await request(server, path);
    const policy = headers["content-security-policy"];
    assert.match(policy, /default-src 'self'/);
    assert.match(policy, /frame-ancestors 'none'/);
    assert.doesNotMatch(policy, /unsafe-eval|script-src[^;]*unsafe-inline/);
    assert.equal(headers["referrer-policy"], "no-referrer");
    assert.equal(headers["x-content-type-options"], "nosniff");
  }
});

test("the server accepts only GET, HEAD, DELETE and OPTIONS, and refuses a second Host", async (t) => {
  const { server } = await served(t);
  for (const method of ["POST", "PUT", "PATCH"])
    assert.equal((await request(server, "/api/status", { method })).status, 405);
  assert.equal((await request(server, "/api/status", { method: "DELETE" })).status, 404);
  const socket = net.connect(server.port, "127.0.0.1");
  socket.write("GET /api/status HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\n\r\n");
  const [answer] = await within(Promise.all([new Promise((resolve) => socket.once("data", resolve))]), "the answer");
  assert.match(answer.toString(), /^HTTP\/1\.1 400 /);
  socket.destroy();
});

test(
  "control from another machine needs the token; watching does not, unless reading is protected",
  needsNetwork,
  async (t) => {
    const folder = temporaryFolder(t);
    const session = await synthesize(folder, { seconds: 1 });
    const server = await robot(t, folder, session, "--bind", "0.0.0.0");
    const token = readFileSync(join(folder, "state/token"), "utf8").trim();
    const from = (path) => Live.open(t, server, { address: own, path });
    const needed = /control token.*\?token=/;

    for (const path of [
      "/",
      "/?token=",
      "/?token=0123456789abcdef0123456789abcdef",
      `/?token=${token.slice(0, -1)}`,
      `/?token=${token}0`,
      `/?token=${token.toUpperCase()}x`,
    ]) {
      const guest = await from(path);
      await guest.subscribe("/14/2/joints"); // watching needs no token
      await guest.newest("/14/2/joints");
      for (const service of ["start_recording", "stop_recording", "keep_session"]) {
        const { ok, error } = await guest.call(service, {});
        assert.equal(ok, false, path);
        assert.match(error, needed);
      }
      assert.equal((await guest.call("clock_sync", { sent_ns: "1" })).ok, true); // every client may ask for the time
      guest.send({ op: "setParameters", parameters: [{ name: "jpeg_quality", value: 10 }], id: "set" });
      const { parameters } = await guest.until(() => guest.values.find(({ id }) => id === "set"), "the values");
      assert.equal(parameters[0].value, 75);
      assert.ok(guest.statuses.some(({ level, message }) => level === 2 && needed.test(message)));
      guest.socket.terminate();
    }
    assert.equal((await request(server, "/api/sessions", { address: own })).status, 200);

    const trusted = await from(`/?token=${token}`);
    assert.equal((await trusted.call("start_recording")).ok, true);
    assert.equal((await trusted.call("stop_recording")).ok, true);
    const local = await Live.open(t, server); // processes of this machine need no token
    assert.equal((await local.call("start_recording")).ok, true);
    await local.call("stop_recording");
  },
);

test(
  "with protected reading another machine without the token gets only the viewer itself",
  needsNetwork,
  async (t) => {
    const { folder, server } = await served(t, "--bind", "0.0.0.0", "--protect-reading");
    const token = readFileSync(join(folder, "state/token"), "utf8").trim();
    const ask = (path) => request(server, path, { address: own });
    for (const path of ["/api/status", "/api/sessions", "/logs/", "/logs/synthetic.mcap"]) {
      const { status, body } = await ask(path);
      assert.equal(status, 401, path);
      assert.match(body.toString(), /\?token=/);
      assert.equal((await ask(`${path}?token=${token}`)).status, 200, path);
      assert.equal((await request(server, path)).status, 200, path); // on the machine itself
    }
    assert.equal((await ask("/")).status, 200);
    assert.equal((await refusal(server, { address: own })).status, 401);
    await Live.open(t, server, { address: own, path: `/?token=${token}` });
  },
);

test("the token is made once, only its owner can read it, and no answer contains it", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 1 });
  const server = await robot(t, folder, session);
  const file = join(folder, "state/token");
  const token = readFileSync(file, "utf8").trim();
  assert.match(token, /^[0-9a-f]{32}$/);
  assert.equal(statSync(file).mode & 0o777, 0o600);

  const live = await Live.open(t, server, { path: `/?token=${token}` });
  await live.subscribe("/14/2/runtime", "/14/2/log");
  const runtime = await live.newest("/14/2/runtime");
  const said = [
    server.output,
    JSON.stringify(live.infos),
    JSON.stringify(live.decoded("/14/2/runtime", runtime)),
    live.messages
      .get("/14/2/log")
      .map(({ data }) => data.toString("latin1"))
      .join(),
  ];
  for (const path of [
    "/",
    "/api/status",
    "/api/sessions",
    `/logs/?token=${token}`,
    `/api/status?token=${token}`,
    `/nothing?token=${token}`,
  ]) {
    const { body, headers } = await request(server, path);
    // the list of recordings keeps the token in its links, because the next page needs it too
    if (!path.startsWith("/logs/")) said.push(body.toString("latin1"), JSON.stringify(headers));
  }
  for (const text of said) assert.ok(!text.includes(token), text.slice(0, 200));

  await server.stop();
  await robot(t, folder, session);
  assert.equal(readFileSync(file, "utf8").trim(), token);
});

/** Asserts that a program refuses to start, with status 2 and one sentence. */
async function refuses(sentence, program, ...args) {
  const { status, stderr } = await run(program, ...args);
  assert.equal(status, 2, `${args}: ${stderr}`);
  assert.match(stderr, sentence);
  assert.equal(stderr.trim().split("\n").length, 1, stderr);
}

test("a program that cannot start gives the reason in one sentence, with status 2", async (t) => {
  const { folder, session, server } = await served(t);
  const state = ["--state-dir", join(folder, "state")];
  const again = (...args) => ["--session", session, "--log-dir", join(folder, "logs"), ...state, ...args];
  await refuses(
    /cannot listen on 127\.0\.0\.1:\d+: Address already in use/,
    "foresight-lab",
    "play",
    session,
    "--port",
    `${server.port}`,
    ...state,
  );
  await refuses(
    /cannot listen on 127\.0\.0\.1:\d+: Address already in use/,
    "foresight-robot",
    ...again("--port", `${server.port}`),
  );
  await refuses(
    /cannot listen on nowhere:0: expected an IP address/,
    "foresight-robot",
    ...again("--port", "0", "--bind", "nowhere"),
  );
  await refuses(/session .*nowhere/, "foresight-lab", "play", join(folder, "nowhere"), "--port", "0", ...state);
  await refuses(/session .*nowhere/, "foresight-robot", "--session", join(folder, "nowhere"), "--port", "0", ...state);
  await refuses(/--session/, "foresight-robot", "--port", "0", ...state);
  await refuses(
    /speed must be 0\.01 \.\. 1000/,
    "foresight-lab",
    "play",
    session,
    "--speed",
    "0",
    "--port",
    "0",
    ...state,
  );
  await refuses(/session/, "foresight-lab", "info", join(folder, "state"));
  await refuses(/profile/, "foresight-robot", ...again("--port", "0", "--record", "--profile", "everything"));

  writeFileSync(join(folder, "state/token"), "short\n");
  await refuses(/token: expected at least 8 characters/, "foresight-lab", "play", session, "--port", "0", ...state);
});
