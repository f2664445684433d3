// A rendered game from end to end: two synthetic sensors, their recording, and the same smoothed, beside the true places.
import { join } from "node:path";
import { decoderOf } from "../e2e/live.mjs";
import { readSession } from "../e2e/mcap.mjs";
import { onlySession, scratch, sleep, start } from "./programs.mjs";
import { meanOf, quantile } from "./statistics.mjs";

const kNear = 0.3; // [m] a report that is farther from all robots is of none
const kMoves = 0.3; // [m/s] a ball that rolls

/** The messages of a topic as {at [s], value}. */
function read(session, topic) {
  const { schema, messages } = session.get(topic);
  const decode = decoderOf(schema.name, schema.data);
  return messages.map(({ logTime, data }) => ({ at: Number(logTime) / 1e9, value: decode(data) }));
}

const between = (a, b, part) => a + part * (b - a);

/** The true places at a time: {ball, robots: Map of name to place}, or undefined between two games. */
function truthAt(truths, from, at) {
  while (from.i + 1 < truths.length && truths[from.i + 1].at <= at) ++from.i;
  const [before, after] = [truths[from.i], truths[from.i + 1]];
  if (!after || at < before.at || after.at - before.at > 0.05) return undefined;
  const part = (at - before.at) / (after.at - before.at);
  const place = (one, other) => ({ x: between(one.x, other.x, part), y: between(one.y, other.y, part) });
  const name = ({ team, player }) => `${team}/${player}`;
  const later = new Map(after.value.robots.map((robot) => [name(robot), robot]));
  const robots = before.value.robots.filter((robot) => later.has(name(robot)));
  const ball = before.value.ball;
  return {
    ball: { ...place(ball, after.value.ball), velocity_x: ball.velocity_x ?? 0, velocity_y: ball.velocity_y ?? 0 },
    robots: new Map(robots.map((robot) => [name(robot), place(robot, later.get(name(robot)))])),
  };
}

const rms = (values) => Math.sqrt(meanOf(values.map((value) => value * value)).mean);

/** The figures of a truth beside the true places [m, m/s]. */
function compare(session) {
  const truths = read(session, "/truth/simulated");
  const from = { i: 0 };
  const [robots, ball, velocity] = [[], [], []];
  const names = new Map(); // track -> the robot that it was last
  let [switches, strangers, unseen, moments] = [0, 0, 0, 0];
  for (const { at, value } of read(session, "/truth/world")) {
    const truth = truthAt(truths, from, at);
    if (!truth) continue;
    ++moments;
    const free = new Map(truth.robots);
    for (const { x, y, track } of value.robots ?? []) {
      const far = ([, place]) => Math.hypot(place.x - x, place.y - y);
      const [nearest] = [...free].sort((a, b) => far(a) - far(b));
      if (!nearest || far(nearest) > kNear) {
        ++strangers;
        continue;
      }
      free.delete(nearest[0]);
      robots.push(far(nearest));
      if (names.has(track) && names.get(track) !== nearest[0]) ++switches;
      names.set(track, nearest[0]);
    }
    unseen += free.size;
    const { ball: seen } = value;
    if (!seen) continue;
    ball.push(Math.hypot(seen.x - truth.ball.x, seen.y - truth.ball.y));
    if (seen.velocity_x !== undefined && Math.hypot(truth.ball.velocity_x, truth.ball.velocity_y) > kMoves)
      velocity.push(Math.hypot(seen.velocity_x - truth.ball.velocity_x, seen.velocity_y - truth.ball.velocity_y));
  }
  return {
    robots: { mean: meanOf(robots).mean, p95: quantile(robots, 0.95), strangers: strangers / moments },
    unseen: unseen / moments,
    switches,
    ball: { median: quantile(ball, 0.5), p95: quantile(ball, 0.95), seen: ball.length / moments },
    velocity: rms(velocity),
  };
}

/** Records `seconds` of a game and smooths the recording. Returns the figures of both. */
export async function renderedGame(seconds) {
  const logs = join(scratch, "rendered-logs");
  const server = start("foresight-lab", [
    ...["truth", "--source", "synthetic", "--source", "synthetic:2", "--seed", 7, "--port", 0, "--record"],
    ...["--log-dir", logs, "--state-dir", join(scratch, "rendered")],
  ]);
  await server.address;
  await sleep(seconds);
  server.stop();
  await server.output;
  const recorded = onlySession(logs);
  await start("foresight-lab", ["smooth", recorded, "--session", join(scratch, "rendered-smoothed")]).output;
  return { live: compare(readSession(recorded)), smoothed: compare(readSession(join(scratch, "rendered-smoothed"))) };
}
