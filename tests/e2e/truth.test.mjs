// foresight-lab truth: synthetic sensors watch a simulated game, over the network and in the view Ground truth.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createSocket } from "node:dgram";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open, shoot } from "./browser.mjs";
import { Live } from "./live.mjs";
import { readSession } from "./mcap.mjs";
import { packet } from "./ssl_packets.mjs";
import { atEnd, dataFile, needsData, root, run, start, temporaryFolder, until } from "./support.mjs";

const watchField = (t, ...options) => start(t, temporaryFolder(t), "foresight-lab", "truth", ...options);

/** The newest message of a topic, decoded. */
const newest = async (live, topic) => live.decoded(topic, await live.newest(topic));

/** Waits until a message of a topic fulfils a condition, and returns it. */
const until_ = (live, topic, condition, what) =>
  until(async () => {
    const message = await newest(live, topic);
    return condition(message) && message;
  }, what);

/** The pixel of a point [m, field] in the image of a sensor, or undefined outside of it. */
function pixelOf({ place, pinhole }, { x, y, z }) {
  const away = [x - place.x, y - place.y, z - place.z];
  const [right, down, ahead] = [0, 1, 2].map((axis) =>
    away.reduce((sum, value, i) => sum + place.rotation[3 * i + axis] * value, 0),
  );
  if (ahead <= 0) return undefined;
  const at = {
    x: pinhole.centre_x + (pinhole.focal_x * right) / ahead,
    y: pinhole.centre_y + (pinhole.focal_y * down) / ahead,
  };
  return at.x > 5 && at.y > 5 && at.x < pinhole.width - 5 && at.y < pinhole.height - 5 ? at : undefined;
}

test("a synthetic sensor finds the robots of a simulated game, and says how well", async (t) => {
  const server = await watchField(t, "--source", "synthetic", "--seed", "7");
  const live = await Live.open(t, server);
  for (const topic of ["/truth/world", "/truth/simulated", "/truth/1/sensor", "/truth/1/depth", "/truth/1/points"])
    await live.subscribe(topic);
  const sensor = await until_(live, "/truth/1/sensor", ({ robots }) => robots.length > 0, "a robot in the image");
  assert.equal(sensor.state, "STATE_WATCHING");
  assert.equal(sensor.problem, "");
  const depth = await newest(live, "/truth/1/depth");
  assert.equal(depth.encoding, "16UC1");
  assert.equal(Buffer.from(depth.data, "base64").length, 640 * 480 * 2);
  const points = await newest(live, "/truth/1/points");
  assert.equal(points.frame_id, "field");
  assert.ok(Buffer.from(points.data, "base64").length > 16 * 10000);

  // each robot that is reported stands near a true one
  const world = await until_(live, "/truth/world", ({ robots }) => robots.length > 0, "a robot in the truth");
  const { robots } = await newest(live, "/truth/simulated");
  for (const seen of world.robots)
    assert.ok(
      robots.some(({ x, y }) => Math.hypot(x - seen.x, y - seen.y) < 0.2),
      JSON.stringify(seen),
    );
  assert.ok(BigInt(world.sent_ns) >= BigInt(world.detected_ns) && BigInt(world.detected_ns) > 0n);
});

test("a calibrated sensor learns the empty field from its next images", async (t) => {
  const live = await Live.open(t, await watchField(t, "--source", "synthetic", "--seed", "7"));
  await live.subscribe("/truth/1/sensor");
  await until_(live, "/truth/1/sensor", ({ state }) => state === "STATE_WATCHING", "an image");
  assert.equal((await live.call("/truth/background", { sensor: 1 })).images, 15);
  await until_(
    live,
    "/truth/1/sensor",
    ({ background_images: images, background_awaited: awaited }) => images === 15 && !awaited,
    "the empty field",
  );
});

test("a sensor is calibrated by clicks, and the calibration is used at once and after a restart", async (t) => {
  const folder = temporaryFolder(t);
  const first = await watchField(t, "--source", "synthetic", "--seed", "7");
  const exact = await Live.open(t, first);
  await exact.subscribe("/truth/1/sensor");
  const known = await until_(exact, "/truth/1/sensor", ({ place }) => place, "the place of the sensor");
  await first.stop();

  const file = join(folder, "lab.json");
  const server = await watchField(t, "--source", "synthetic", "--seed", "7", "--calibration", file);
  const live = await Live.open(t, server);
  await live.subscribe("/truth/1/sensor");
  const blind = await until_(live, "/truth/1/sensor", ({ state }) => state === "STATE_WATCHING", "an image");
  assert.equal(blind.place, undefined, "nobody knows where the sensor is");
  const { error } = await live.call("/truth/background", { sensor: 1 });
  assert.match(error, /sensor 1 is not calibrated/);

  const { landmarks, clicks: none, file: name } = await live.call("/truth/landmarks", { sensor: 1 });
  assert.deepEqual(none, []);
  assert.equal(name, "lab.json");
  const clicks = landmarks.flatMap((landmark) => {
    const at = pixelOf(known, landmark);
    return at ? [{ landmark: landmark.name, ...at }] : [];
  });
  assert.ok(clicks.length >= 6, `${clicks.length} landmarks are in view`);
  const poor = await live.call("/truth/calibrate", { sensor: 1, clicks: clicks.slice(0, 3), save: true });
  assert.equal(poor.ok, true);
  assert.match(poor.refused, /landmark/);
  assert.equal(existsSync(file), false);

  const good = await live.call("/truth/calibrate", { sensor: 1, clicks, save: true });
  assert.equal(good.refused, "", good.refused);
  assert.equal(good.saved, "lab.json");
  assert.ok(good.error.p95 < 0.05);
  for (const axis of ["x", "y", "z"]) assert.ok(Math.abs(good.place[axis] - known.place[axis]) < 0.05, axis);
  await until_(live, "/truth/1/sensor", ({ place }) => place, "the sensor uses the calibration");
  assert.equal(JSON.parse(readFileSync(file, "utf8")).sensors.length, 1);
  await server.stop();

  const again = await Live.open(t, await watchField(t, "--source", "synthetic", "--calibration", file));
  await again.subscribe("/truth/1/sensor");
  const restarted = await until_(again, "/truth/1/sensor", ({ place }) => place, "the place from the file");
  assert.ok(Math.abs(restarted.place.x - good.place.x) < 1e-4);
  assert.equal((await again.call("/truth/landmarks", { sensor: 1 })).clicks.length, clicks.length);

  // the same clicks from a file
  const [written, byFile] = [join(folder, "clicks.json"), join(folder, "by_file.json")];
  const calibrate = (use) => {
    writeFileSync(written, JSON.stringify({ clicks: use }));
    return run("foresight-lab", "calibrate", "--source", "synthetic", "--clicks", written, "--calibration", byFile);
  };
  const refused = await calibrate(clicks.slice(0, 3));
  assert.equal(refused.status, 2);
  assert.match(refused.stderr, /clicks\.json: .*landmark/);
  assert.equal(existsSync(byFile), false);
  const { status, stdout, stderr } = await calibrate(clicks);
  assert.equal(status, 0, stderr);
  for (const { landmark } of clicks) assert.ok(stdout.includes(landmark), landmark);
  assert.match(stdout, /robots +mean [0-9.]+ cm, p95 [0-9.]+ cm/);
  const [saved] = JSON.parse(readFileSync(byFile, "utf8")).sensors;
  assert.equal(saved.clicks.length, clicks.length);
  const watching = await Live.open(t, await watchField(t, "--source", "synthetic", "--calibration", byFile));
  await watching.subscribe("/truth/1/sensor");
  const placed = await until_(watching, "/truth/1/sensor", ({ place }) => place, "the place from the clicks");
  for (const axis of ["x", "y", "z"]) assert.ok(Math.abs(placed.place[axis] - known.place[axis]) < 0.05, axis);
});

for (const [options, sentence] of [
  [[], /--landmarks/],
  [["--source", "synthetic"], /--clicks/],
  [["--source", "synthetic", "--clicks", "/nowhere.json"], /--clicks: .*nowhere/],
  [["--source", "kinect", "--clicks", join(root, "CMakeLists.txt")], /CMakeLists/],
])
  test(`foresight-lab calibrate ${options.join(" ")} is refused in one sentence`, async () => {
    const { status, stderr } = await run("foresight-lab", "calibrate", ...options);
    assert.equal(status, 2);
    assert.match(stderr, sentence);
  });

test("the landmarks of a field are listed for a file of clicks", async () => {
  const { stdout } = await run("foresight-lab", "calibrate", "--landmarks", "--rules", "spl2025", "--json");
  const corner = JSON.parse(stdout).find(({ name }) => name === "corner +x +y");
  assert.deepEqual([corner.x, corner.y], [4.5, 3]);
});

test("two sensors report one truth", async (t) => {
  const server = await watchField(t, "--source", "synthetic", "--source", "synthetic:2", "--rules", "spl2012:3");
  const live = await Live.open(t, server);
  await live.subscribe("/truth/world");
  await until_(
    live,
    "/truth/world",
    ({ robots }) => robots.some(({ sensors }) => sensors === 2),
    "a robot that both sensors see",
  );
});

test("a live robot beside the truth: its link is shown, and its clock is compared", async (t) => {
  const robot = await start(
    t,
    temporaryFolder(t),
    "foresight-robot",
    "--body",
    "sim",
    "--team",
    "14",
    "--no-foresight",
  );
  const live = await Live.open(t, await watchField(t, "--source", "synthetic", "--robot", `127.0.0.1:${robot.port}`));
  await live.subscribe("/lab/1/runtime");
  await live.subscribe("/lab/1/clock");
  const { links } = await until_(
    live,
    "/lab/1/runtime",
    ({ links: all }) => all?.some(({ received }) => Number(received) > 0),
    "poses of the robot",
  );
  assert.equal(links[0].state, "STATE_CONNECTED");
  const sample = await until_(live, "/lab/1/clock", ({ peer }) => peer === links[0].robot, "its clock");
  assert.equal(sample.source, "SOURCE_PEER");
  assert.ok(!live.channels.has(`/${links[0].robot}/pose`), "the robot's objects stay at the robot");
});

test("recorded truth is smoothed, and the copy plays like the recording", async (t) => {
  const logs = temporaryFolder(t);
  const server = await watchField(t, "--source", "synthetic", "--seed", "7", "--record", "--log-dir", logs);
  const live = await Live.open(t, server);
  await live.subscribe("/truth/world");
  await until_(live, "/truth/world", ({ robots }) => robots.length > 0, "a robot in the truth");
  await live.until(() => live.messages.get("/truth/world").length > 60, "two seconds of truth");
  await server.stop();
  const [recorded] = readdirSync(logs).filter((name) => name.endsWith("_full"));
  const { status, stdout, stderr } = await run("foresight-lab", "smooth", join(logs, recorded));
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^smoothed +\d+ images of 1 sensors/);
  const copy = stdout.trim().split("\n").at(-1);
  assert.equal(copy, join(logs, `${recorded}_smoothed`));
  const [before, after] = [readSession(join(logs, recorded)), readSession(copy)];
  assert.deepEqual([...after.keys()].sort(), [...before.keys()].sort());
  assert.ok(after.get("/truth/world").messages.length > 60);

  const again = await run("foresight-lab", "smooth", join(logs, recorded));
  assert.equal(again.status, 2, "the copy is there already");
  const played = await Live.open(t, await start(t, temporaryFolder(t), "foresight-lab", "play", copy));
  await played.subscribe("/truth/world");
  await until_(played, "/truth/world", ({ robots }) => robots.length > 0, "a robot in the smoothed truth");
});

test("the view Ground truth shows image, points and field of a sensor", async (t) => {
  const server = await watchField(t, "--source", "synthetic", "--seed", "7");
  const { page, problems } = await open(t, `${server.http}/#/ground-truth`, {
    viewport: { width: 1500, height: 900 },
  });
  await page
    .getByText(/mean error|cm from the true/i)
    .first()
    .waitFor();
  await shoot(page, "truth_real");
  assert.deepEqual(problems, []);
});

test("a recording of a real Kinect is played at its times", needsData, async (t) => {
  const source = `fakenect:${dataFile("depth/fakenect_nyu")}`;
  const live = await Live.open(t, await watchField(t, "--source", source));
  await live.subscribe("/truth/1/sensor");
  const sensor = await until_(live, "/truth/1/sensor", ({ state }) => state === "STATE_ENDED", "the end");
  assert.equal(sensor.address, source);
  assert.equal(sensor.pinhole.width, 640);
});

for (const [options, sentence] of [
  [["--source", "kinect"], /kinect/],
  [["--source", "synthetic", "--source", "ssl-vision"], /must be the only source/],
  [["--source", "synthetic", "--source", "freenect:0"], /synthetic sensors only, or none/],
  [["--source", "fakenect:/nowhere"], /nowhere/],
  [["--source", "synthetic", "--rules", "spl1812"], /spl1812/],
  [["--source", "ssl-vision:10.0.0.1:10006"], /multicast/],
  [["--source", "synthetic", "--robot", "nobody"], /--robot: .*nobody/],
])
  test(`foresight-lab truth ${options.join(" ")} is refused in one sentence`, async (t) => {
    const { status, stderr } = await run("foresight-lab", "truth", ...options);
    assert.equal(status, 2);
    assert.match(stderr, sentence);
    assert.equal(stderr.trim().split("\n").length, 1);
  });

test("a process of a lab's own reports the truth through the door", async (t) => {
  const door = join(temporaryFolder(t), "door");
  const live = await Live.open(t, await watchField(t, "--source", "door", "--door", door));
  const example = join(root, "robot/client/examples/truth.py");
  const teller = spawn("python3", [example], {
    env: { ...process.env, FORESIGHT_DOOR: door, PYTHONPATH: join(root, "robot/client") },
    stdio: "ignore",
  });
  atEnd(t, () => teller.kill());
  await live.subscribe("/truth/world");
  const { ball, robots } = await newest(live, "/truth/world");
  assert.ok(Math.hypot(ball.x, ball.y) > 0.1, "a ball on a circle");
  assert.equal(robots.length, 2);
});

test("packets of SSL-Vision become the truth", async (t) => {
  const address = "239.5.23.77";
  const port = 20000 + (process.pid % 20000);
  const live = await Live.open(t, await watchField(t, "--source", `ssl-vision:${address}:${port}`, "--yellow", "18"));
  await live.subscribe("/truth/world");
  const socket = createSocket("udp4");
  atEnd(t, () => socket.close());
  const { bytes, set } = packet();
  let frame = 0;
  const sending = setInterval(() => {
    set(++frame, 100 + frame / 60);
    socket.send(Buffer.from(bytes), port, address);
  }, 16);
  atEnd(t, () => clearInterval(sending));
  const { ball, robots } = await newest(live, "/truth/world");
  assert.ok(Math.abs(ball.x - 1.25) < 1e-6 && Math.abs(ball.y + 0.5) < 1e-6);
  assert.deepEqual([robots[0].team, robots[0].player], [18, 3]);
  assert.ok(Math.abs(robots[0].heading - 0.5) < 1e-6);
});
