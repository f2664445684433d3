// A small server of ground truth: a synthetic depth sensor beside a field with robots and a ball. It speaks the Foxglove
// protocol, as `foresight-lab truth` does, and calibrates by a plain least squares.
import { atEnd, require } from "./support.mjs";
import { messageOf } from "./descriptors.mjs";

const { WebSocketServer } = require("ws");

export const kPinhole = { width: 640, height: 480, focalX: 575.8, focalY: 575.8, centreX: 320, centreY: 240 };
const kField = {
  length: 9,
  width: 6,
  circle: 0.75,
  goalArea: [0.6, 2.2],
  penaltyArea: [1.65, 4],
  mark: 1.3,
  goal: 1.6,
};
const kBackgroundImages = 15; // of the empty field
const kFrames = 24; // they are played again and again
const kRobotRadius = 0.12,
  kRobotHeight = 0.58,
  kBallRadius = 0.05;

// poses

const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const unit = (a) => a.map((value) => value / Math.hypot(...a));
const column = (rotation, i) => [rotation[i], rotation[3 + i], rotation[6 + i]];

/** A sensor at `at` that looks at a point: {rotation: field_from_sensor row by row, at}. */
export function lookingAt(at, target) {
  const forward = unit(target.map((value, i) => value - at[i]));
  const right = unit(cross(forward, [0, 0, 1]));
  const down = cross(forward, right);
  return { rotation: [0, 1, 2].flatMap((i) => [right[i], down[i], forward[i]]), at };
}

/** The pixel of a point of the field, or undefined behind the sensor. */
export function pixelOf({ rotation, at }, point) {
  const away = point.map((value, i) => value - at[i]);
  const [x, y, z] = [0, 1, 2].map((i) => dot(column(rotation, i), away));
  const { focalX, focalY, centreX, centreY } = kPinhole;
  return z > 0.05 ? { x: centreX + (focalX * x) / z, y: centreY + (focalY * y) / z } : undefined;
}

/** Turns a pose by a small rotation vector about the sensor's axes and moves it. */
function moved({ rotation, at }, [a, b, c, x, y, z]) {
  const turn = [1, -c, b, c, 1, -a, -b, a, 1];
  const rows = [0, 1, 2].map((row) => [0, 1, 2].map((i) => dot(rotation.slice(3 * row, 3 * row + 3), column(turn, i))));
  // orthonormal again
  const right = unit([0, 1, 2].map((row) => rows[row][0]));
  const down = [0, 1, 2].map((row) => rows[row][1]);
  const forward = unit(cross(right, down));
  const square = cross(forward, right);
  return {
    rotation: [0, 1, 2].flatMap((row) => [right[row], square[row], forward[row]]),
    at: [at[0] + x, at[1] + y, at[2] + z],
  };
}

// scene

const robotsAt = (time) => [
  { x: -1.6 + 0.25 * Math.sin(time), y: -0.9, vx: 0.25 * Math.cos(time), vy: 0, track: 3 },
  { x: 0.4, y: -0.2 + 0.3 * Math.cos(time), vx: 0, vy: -0.3 * Math.sin(time), track: 4 },
  { x: 1.5, y: 0.9, vx: 0, vy: 0, track: 7 },
  { x: -0.7, y: 0.8, vx: 0, vy: 0, track: 9, team: 14, player: 2 },
];
const ballAt = (time) => ({ x: -0.5 + 0.5 * Math.sin(time), y: -1.2, vx: 0.5 * Math.cos(time), vy: 0 });

/** [m] depths of the carpet and of a wall behind it; 0 beyond 7 m. */
function emptyScene({ rotation, at }) {
  const { width, height, focalX, focalY, centreX, centreY } = kPinhole;
  const depths = new Float32Array(width * height);
  for (let v = 0, i = 0; v < height; ++v)
    for (let u = 0; u < width; ++u, ++i) {
      const ray = [(u + 0.5 - centreX) / focalX, (v + 0.5 - centreY) / focalY, 1];
      const [, y, z] = [0, 1, 2].map((row) => dot(rotation.slice(3 * row, 3 * row + 3), ray));
      const ground = z < 0 ? -at[2] / z : Infinity;
      const wall = y > 0 ? (4.2 - at[1]) / y : Infinity;
      const depth = Math.min(ground, wall);
      depths[i] = depth < 7 ? depth : 0;
    }
  return depths;
}

/** Draws a upright cylinder, or a ball, into depths: the nearest surface wins. */
function drawThing(depths, pose, { x, y }, radius, height) {
  const { rotation, at } = pose;
  const { width, focalX, focalY, centreX, centreY } = kPinhole;
  const [low, high] = [pixelOf(pose, [x, y, 0]), pixelOf(pose, [x, y, height])];
  if (!low || !high) return;
  const depth = dot(column(rotation, 2), [x - at[0], y - at[1], height / 2 - at[2]]);
  const half = (focalX * radius) / depth;
  const top = Math.max(0, Math.floor(high.y)),
    bottom = Math.min(kPinhole.height - 1, Math.ceil(low.y));
  for (let v = top; v <= bottom; ++v)
    for (let u = Math.max(0, Math.floor(low.x - half)); u <= Math.min(width - 1, low.x + half); ++u) {
      const side = (u + 0.5 - low.x) / half;
      const up = (v - top) / Math.max(1, bottom - top);
      // a body with a head, legs apart
      if (height > 0.3 && (Math.abs(side) > (up < 0.22 ? 0.45 : 0.95) || (up > 0.7 && Math.abs(side) < 0.15))) continue;
      if (height <= 0.3 && side * side + (2 * up - 1) ** 2 > 1) continue;
      const ray = [(u + 0.5 - centreX) / focalX, (v + 0.5 - centreY) / focalY, 1];
      const surface = depth - radius * Math.sqrt(Math.max(0, 1 - side * side));
      const there = at[2] + surface * dot(rotation.slice(6, 9), ray);
      const i = v * width + u;
      if (there > 0 && (depths[i] === 0 || surface < depths[i])) depths[i] = surface;
      if (u > low.x + half - 2) depths[i] = 0; // the projector's shadow
    }
}

/** A row of depth images in mm, little endian, with a plain noise that grows with the square of the depth. */
function framesOf(pose) {
  const empty = emptyScene(pose);
  let seed = 1;
  const random = () => (seed = (seed * 1103515245 + 12345) & 0x7fffffff) / 0x7fffffff;
  return Array.from({ length: kFrames }, (_, frame) => {
    const time = (2 * Math.PI * frame) / kFrames;
    const depths = empty.slice();
    for (const robot of robotsAt(time)) drawThing(depths, pose, robot, kRobotRadius, kRobotHeight);
    drawThing(depths, pose, ballAt(time), kBallRadius, 2 * kBallRadius);
    const bytes = Buffer.alloc(2 * depths.length);
    depths.forEach((depth, i) => {
      const noisy = depth + (random() - 0.5) * 0.004 * depth * depth;
      bytes.writeUInt16LE(depth > 0.4 && random() > 0.01 ? Math.round(1000 * noisy) : 0, 2 * i);
    });
    return bytes;
  });
}

/** A picture of the field's lines in colours. */
function colourOf({ rotation, at }) {
  const { width, height, focalX, focalY, centreX, centreY } = kPinhole;
  const rgb = Buffer.alloc(3 * width * height);
  const onLine = (x, y) => {
    const [ax, ay] = [Math.abs(x), Math.abs(y)];
    const near = (value, line) => Math.abs(value - line) < 0.025;
    const box = (deep, wide) =>
      (near(ax, kField.length / 2 - deep) && ay <= wide / 2) ||
      (near(ay, wide / 2) && ax >= kField.length / 2 - deep && ax <= kField.length / 2);
    return (
      box(0, kField.width) ||
      (near(ay, kField.width / 2) && ax < kField.length / 2) ||
      (near(ax, 0) && ay < kField.width / 2) ||
      Math.abs(Math.hypot(x, y) - kField.circle) < 0.025 ||
      box(...kField.goalArea) ||
      box(...kField.penaltyArea) ||
      (Math.abs(ax - (kField.length / 2 - kField.mark)) < 0.05 && ay < 0.05)
    );
  };
  for (let v = 0, i = 0; v < height; ++v)
    for (let u = 0; u < width; ++u, i += 3) {
      const ray = [(u + 0.5 - centreX) / focalX, (v + 0.5 - centreY) / focalY, 1];
      const [dx, dy, dz] = [0, 1, 2].map((row) => dot(rotation.slice(3 * row, 3 * row + 3), ray));
      const far = dz < 0 ? -at[2] / dz : Infinity;
      const [x, y] = [at[0] + far * dx, at[1] + far * dy];
      const colour = y > 4.2 || far > 20 ? [150, 140, 130] : onLine(x, y) ? [235, 240, 235] : [44, 112, 66];
      rgb.set(colour, i);
    }
  return rgb;
}

// calibration

export const kLandmarks = [
  ...[-1, 1].flatMap((sx) =>
    [-1, 1].flatMap((sy) =>
      [
        ["corner", (sx * kField.length) / 2, (sy * kField.width) / 2],
        ["penalty area", sx * (kField.length / 2 - 1.65), sy * 2],
        ["penalty area foot", (sx * kField.length) / 2, sy * 2],
        ["goal area", sx * (kField.length / 2 - 0.6), sy * 1.1],
        ["goal post", (sx * kField.length) / 2, sy * 0.8],
      ].map(([name, x, y]) => ({ name: `${name} ${sx > 0 ? "+x" : "-x"} ${sy > 0 ? "+y" : "-y"}`, x, y, z: 0 })),
    ),
  ),
  ...[-1, 1].flatMap((s) => [
    { name: `penalty mark ${s > 0 ? "+x" : "-x"}`, x: s * (kField.length / 2 - 1.3), y: 0, z: 0 },
    { name: `centre line ${s > 0 ? "+y" : "-y"}`, x: 0, y: s * 3, z: 0 },
    { name: `circle and centre line ${s > 0 ? "+y" : "-y"}`, x: 0, y: s * 0.75, z: 0 },
  ]),
];
const placeOf = (name) => {
  const { x, y, z } = kLandmarks.find((landmark) => landmark.name === name);
  return [x, y, z];
};

/** Solves the least squares of the pose by Gauss and Newton, from a pose near it. */
function fit(start, clicks) {
  const errorsOf = (pose) =>
    clicks.flatMap(({ landmark, x, y }) => {
      const pixel = pixelOf(pose, placeOf(landmark)) ?? { x: 1e4, y: 1e4 };
      return [pixel.x - x, pixel.y - y];
    });
  let pose = start;
  for (let round = 0; round < 12; ++round) {
    const errors = errorsOf(pose);
    const slopes = [0, 1, 2, 3, 4, 5].map((i) => {
      const step = [0, 0, 0, 0, 0, 0].with(i, 1e-5);
      return errorsOf(moved(pose, step)).map((value, row) => (value - errors[row]) / 1e-5);
    });
    const normal = slopes.map((one, i) => [
      ...slopes.map((other, j) => dot(one, other) + (i === j ? 1e-6 : 0)),
      -dot(one, errors),
    ]);
    pose = moved(pose, solved(normal));
  }
  return pose;
}

/** Solves linear equations, whose right side is the last column, by elimination. */
function solved(rows) {
  const size = rows.length;
  for (let i = 0; i < size; ++i) {
    const pivot = rows.slice(i).reduce((best, row) => (Math.abs(row[i]) > Math.abs(best[i]) ? row : best));
    rows.splice(rows.indexOf(pivot), 1);
    rows.splice(i, 0, pivot);
    for (let j = 0; j < size; ++j)
      if (j !== i) rows[j] = rows[j].map((value, k) => value - (rows[j][i] / pivot[i]) * pivot[k]);
  }
  return rows.map((row, i) => row[size] / row[i]);
}

function calibrate(start, { clicks, save }) {
  const nothing = { fitted: false, residuals: [], depth_scale: 1, depth_scale_deviation: 0, saved: "" };
  if (clicks.length < 4) return { ...nothing, refused: `expected at least 4 landmarks, got ${clicks.length}` };
  const pose = fit(start, clicks);
  const residuals = clicks.map(({ landmark, x, y }) => {
    const pixel = pixelOf(pose, placeOf(landmark)) ?? { x: 1e4, y: 1e4 };
    const pixels = Math.hypot(pixel.x - x, pixel.y - y);
    return { landmark, pixels, outlier: pixels > 8 };
  });
  const mean = residuals.reduce((sum, { pixels }) => sum + pixels, 0) / residuals.length;
  const worst = residuals.reduce((a, b) => (a.pixels > b.pixels ? a : b));
  const refused = mean > 3 ? `the landmarks are ${mean.toFixed(1)} px away on average, expected at most 3 px` : "";
  const middle = [0, 1].map((i) => clicks.reduce((sum, { landmark }) => sum + placeOf(landmark)[i], 0) / clicks.length);
  const grid = [];
  for (let x = -2.75; x < 3; x += 0.5)
    for (let y = -2.75; y < 3; y += 0.5) {
      const pixel = pixelOf(pose, [x, y, 0]);
      if (!pixel || pixel.x < 0 || pixel.y < 0 || pixel.x > 640 || pixel.y > 480) continue;
      const away = Math.hypot(x - middle[0], y - middle[1]);
      grid.push({ x, y, metres: (0.003 + 0.004 * mean) * (0.5 + (0.5 * away * away) / Math.sqrt(clicks.length)) });
    }
  const errors = grid.map(({ metres }) => metres).sort((a, b) => a - b);
  return {
    fitted: true,
    refused,
    residuals,
    depth_scale: 1.0043,
    depth_scale_deviation: 0.0021,
    error: {
      mean: errors.reduce((sum, value) => sum + value, 0) / errors.length,
      p95: errors[Math.floor(0.95 * errors.length)],
      grid,
    },
    left_out: { mean: 0.004 * mean + 0.004, worst: 0.004 * worst.pixels + 0.006, landmark: worst.landmark },
    place: { rotation: pose.rotation, x: pose.at[0], y: pose.at[1], z: pose.at[2] },
    saved: save && !refused ? "lab.json" : "",
  };
}

// server

const stamp = (ns) => ({ seconds: ns / 1_000_000_000n, nanos: Number(ns % 1_000_000_000n) });

/** Starts it; returns {port, pose, requests, state}. `state` may be changed: {problem, calibrated, hz, background}. */
export async function truthServer(t, { colour = true, clicks = [], hz = 30 } = {}) {
  const pose = lookingAt([0, -4.1, 2.1], [0, -0.4, 0]);
  const other = lookingAt([3.2, 3.9, 1.9], [1.2, 0.4, 0]);
  const [truth, sensor, image] = [
    messageOf("foresight/truth.proto", "foresight.GroundTruth"),
    messageOf("foresight/truth.proto", "foresight.TruthSensor"),
    messageOf("foxglove/RawImage.proto", "foxglove.RawImage"),
  ];
  const topics = [
    ["/truth/world", truth],
    ["/truth/simulated", truth],
    ["/truth/1/sensor", sensor],
    ["/truth/2/sensor", sensor],
    ["/truth/1/depth", image],
    ...(colour ? [["/truth/1/color", image]] : []),
  ];
  const channels = topics.map(([topic, { schemaName, schema }], id) => ({
    id,
    topic,
    encoding: "protobuf",
    schemaName,
    schema,
    metadata: {},
  }));
  const services = ["/truth/landmarks", "/truth/calibrate", "/truth/background"];
  const state = { problem: "", calibrated: true, hz, background: { images: 0, awaited: 0 } };
  const requests = [];
  const frames = framesOf(pose);
  const rgb = colourOf(pose);
  const server = new WebSocketServer({ port: 0, handleProtocols: (offered) => [...offered][0] });
  await new Promise((done) => server.once("listening", done));
  const subscriptions = new Map(); // socket -> topic -> subscription id

  function answer(name, request) {
    requests.push({ name, request });
    if (name === "/truth/landmarks") return { landmarks: kLandmarks, clicks, file: "lab.json" };
    if (name === "/truth/background") {
      state.background.awaited = kBackgroundImages;
      return { ok: true, images: kBackgroundImages };
    }
    return calibrate(moved(pose, [0.01, -0.01, 0.005, 0.05, -0.04, 0.03]), request);
  }
  function call(socket, bytes) {
    const [service, id, length] = [bytes.readUInt32LE(1), bytes.readUInt32LE(5), bytes.readUInt32LE(9)];
    const text = Buffer.from(JSON.stringify(answer(services[service], JSON.parse(bytes.subarray(13 + length)))));
    const head = Buffer.alloc(13);
    head[0] = 3;
    head.writeUInt32LE(service, 1);
    head.writeUInt32LE(id, 5);
    head.writeUInt32LE(4, 9);
    socket.send(Buffer.concat([head, Buffer.from("json"), text]));
  }
  server.on("connection", (socket) => {
    const wanted = new Map();
    subscriptions.set(socket, wanted);
    socket.on("close", () => subscriptions.delete(socket));
    socket.on("message", (bytes, isBinary) => {
      if (isBinary) return call(socket, bytes);
      const message = JSON.parse(bytes);
      for (const { id, channelId } of message.subscriptions ?? []) wanted.set(channels[channelId].topic, id);
      for (const [topic, id] of wanted) if (message.subscriptionIds?.includes(id)) wanted.delete(topic);
    });
    socket.send(
      JSON.stringify({
        op: "serverInfo",
        name: "truth",
        capabilities: ["services", "time"],
        supportedEncodings: ["json"],
        metadata: { rules: "spl2025" },
        sessionId: "1",
      }),
    );
    socket.send(JSON.stringify({ op: "advertise", channels }));
    socket.send(
      JSON.stringify({
        op: "advertiseServices",
        services: services.map((name, id) => ({ id, name, type: name, requestSchema: "", responseSchema: "" })),
      }),
    );
  });

  function publish(topic, ns, data) {
    for (const [socket, wanted] of subscriptions) {
      const id = wanted.get(topic);
      if (id === undefined || socket.bufferedAmount > 4e6) continue;
      const head = Buffer.alloc(13);
      head[0] = 1;
      head.writeUInt32LE(id, 1);
      head.writeBigUInt64LE(ns, 5);
      socket.send(Buffer.concat([head, data]));
    }
  }
  const placeOfSensor = ({ rotation, at: [x, y, z] }) => ({
    rotation,
    x,
    y,
    z,
    depthScale: 1,
    errorMean: 0.012,
    errorP95: 0.024,
  });
  const offset = (thing, i, frame) => ({
    x: thing.x + 0.02 * Math.sin(5 * i + frame),
    y: thing.y + 0.015 * Math.cos(3 * i - frame),
  });
  const covariance = { xx: 0.0009, xy: 0.0004, yy: 0.0025 };
  const found = (frame, time) => ({
    robots: robotsAt(time).map((robot, i) => ({
      ...offset(robot, i, frame),
      velocityX: robot.vx,
      velocityY: robot.vy,
      covariance,
      track: robot.track,
      sensors: 2,
      ...(robot.team ? { team: robot.team, player: robot.player, heading: 0.8 } : {}),
    })),
    ball: {
      ...offset({ x: ballAt(time).x, y: ballAt(time).y }, 0, 0),
      velocityX: ballAt(time).vx,
      velocityY: 0,
      covariance: { xx: 0.0001, xy: 0, yy: 0.0002 },
      track: 1,
      sensors: 1,
    },
  });
  let count = 0;
  const tell = () => {
    const ns = BigInt(Date.now()) * 1_000_000n;
    const frame = count++ % kFrames;
    const time = (2 * Math.PI * frame) / kFrames;
    const size = Buffer.alloc(9);
    size[0] = 2;
    size.writeBigUInt64LE(ns, 1);
    for (const socket of subscriptions.keys()) socket.send(size); // the server's time
    const seen = found(frame, time);
    publish("/truth/world", ns, truth.bytes({ ...seen, detectedNs: String(ns), sentNs: String(ns) }));
    const real = {
      robots: robotsAt(time).map(({ x, y }) => ({ x, y })),
      ball: { x: ballAt(time).x, y: ballAt(time).y },
    };
    publish("/truth/simulated", ns, truth.bytes(real));
    const { background } = state;
    if (background.awaited > 0) {
      --background.awaited;
      background.images = Math.min(kBackgroundImages, background.images + 1);
    }
    const report = {
      state: "STATE_WATCHING",
      address: "synthetic",
      problem: state.problem,
      rateHz: state.hz,
      detectionMs: 0.8,
      backgroundImages: background.images,
      backgroundAwaited: background.awaited,
    };
    publish(
      "/truth/1/sensor",
      ns,
      sensor.bytes({
        ...report,
        pinhole: kPinhole,
        ...(state.calibrated ? { place: placeOfSensor(pose), ...seen } : {}),
      }),
    );
    publish(
      "/truth/2/sensor",
      ns,
      sensor.bytes({
        state: "STATE_WAITING",
        address: "freenect:0",
        problem: "freenect:0: no sensor is connected",
        pinhole: kPinhole,
        place: placeOfSensor(other),
      }),
    );
    const common = { timestamp: stamp(ns), width: 640, height: 480, frameId: "sensor 1" };
    publish("/truth/1/depth", ns, image.bytesOf({ ...common, encoding: "16UC1", step: 1280, data: frames[frame] }));
    if (colour) publish("/truth/1/color", ns, image.bytesOf({ ...common, encoding: "rgb8", step: 1920, data: rgb }));
  };
  const timer = setInterval(tell, 1000 / hz);
  atEnd(t, () => {
    clearInterval(timer);
    for (const socket of server.clients) socket.terminate();
    return new Promise((done) => server.close(done));
  });
  return { port: server.address().port, pose, requests, state };
}
