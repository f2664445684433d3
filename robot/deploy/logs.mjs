// scripts/logs: downloads the recordings of robots.
import { existsSync, statSync } from "node:fs";
import { join, relative } from "node:path";
import { dayOf } from "./day.mjs";
import { bring } from "./download.mjs";
import { RobotFailed, runMain } from "./failure.mjs";
import { Lines, sideBySide } from "./lines.mjs";
import { anyText, readCommandLine } from "./options.mjs";
import { Recordings, Refused, tokenText } from "./recordings.mjs";
import { addressThatAnswers, connected } from "./ssh.mjs";
import { pick, readTeam, robotsFile } from "./team.mjs";

const kSmall_bytes = 1e6; // files up to this size of all robots come first
const kAtOnce = 3; // files of one robot
const kImages = ["foresight.Image", "foxglove.CompressedImage", "foxglove.RawImage"];

const kOptions = { robots: anyText, "no-images": true, delete: true, out: anyText, token: tokenText };

const mb = (bytes) => `${(bytes / 1e6).toFixed(1)} MB`;

/** Returns true if the whole session is here already: a file gets its name only when its checksum is right. */
function isHome(session, folder, isWanted) {
  const has = ({ file, size_bytes }) => existsSync(join(folder, file)) && statSync(join(folder, file)).size === size_bytes;
  return existsSync(join(folder, "session.json")) && session.streams.filter(({ file }) => isWanted(file)).every(has);
}

/** Returns the plan for one session: {session, folder, files, mayGo}, or {session, files: [], note} if nothing is to come. */
async function planSession(recordings, session, options, root) {
  if (session.state === "recording") return { session, files: [], note: "still being recorded" };
  const images = options["no-images"] ? session.streams.filter(({ schema }) => kImages.includes(schema)).map(({ file }) => file) : [];
  const isWanted = (file) => !images.includes(file);
  const folder = join(root, session.session);
  // the robot reads the whole session for its checksums, so it is not asked for a session that is here already
  if (!options.delete && isHome(session, folder, isWanted)) return { session, files: [], note: "here already" };
  const files = (await recordings.files(session.session)).filter(({ name }) => isWanted(name));
  return { session, folder, files, mayGo: options.delete && images.length === 0 && !session.kept };
}

/** Returns the plan for one robot. Sessions that the robot refuses now are reported and left out. */
async function planRobot(robot, options, tell) {
  const host = await addressThatAnswers(robot, "http_port");
  if (!host) throw new RobotFailed(`no runtime answers at port ${robot.http_port} of ${robot.addresses.join(" or ")}: it is off, stopped, or silent because a game is in progress`);
  const token = options.delete ? options.token ?? (await tokenOf(robot)) : undefined;
  const recordings = new Recordings(host, robot.http_port, token);
  const plan = { recordings, sessions: [], done_bytes: 0, notes: new Map() };
  for (const session of await recordings.sessions()) {
    const root = join(options.out ?? "logs", dayOf(session.start_ns), robot.name);
    const planned = await planSession(recordings, session, options, root).catch((error) => {
      if (!(error instanceof Refused) || error.status === 503) throw error;
      tell(`${session.session}: ${error.message}`);
      return { session, files: [], note: "refused" };
    });
    if (planned.note) plan.notes.set(planned.note, (plan.notes.get(planned.note) ?? 0) + 1);
    else plan.sessions.push(planned);
  }
  plan.total_bytes = plan.sessions.flatMap(({ files }) => files).reduce((sum, { size_bytes }) => sum + size_bytes, 0);
  return plan;
}

/** Reads the robot's control token over ssh. */
async function tokenOf(robot) {
  const text = await connected(robot, (connection) => connection.must("its token for --delete (--token gives it, too)", "cat foresight/state/token"));
  return text.trim();
}

/** Downloads the files of a robot that `isNow` selects, the smallest first, several at the same time. */
async function bringFiles(plan, isNow, progress) {
  const jobs = plan.sessions.flatMap(({ session, folder, files }) => files.filter(isNow).map((file) => ({ session, file, path: join(folder, file.name) })));
  jobs.sort((a, b) => a.file.size_bytes - b.file.size_bytes);
  const work = async () => {
    for (let job = jobs.shift(); job; job = jobs.shift())
      await bring(plan.recordings, job.session.session, job.file, job.path, (bytes) => progress((plan.done_bytes += bytes))).catch((error) => {
        jobs.length = 0; // ends the other downloads from this robot
        throw error;
      });
  };
  await Promise.all(Array.from({ length: kAtOnce }, work));
}

/** Deletes complete sessions on the robot, and returns their number. */
async function removeArrived(plan, tell) {
  let removed = 0;
  for (const { session } of plan.sessions.filter(({ mayGo }) => mayGo))
    try {
      await plan.recordings.remove(session.session);
      ++removed;
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      tell(`${session.session} stays on the robot: ${error.message}`);
    }
  return removed;
}

function summary(plan, removed) {
  const folders = new Set(plan.sessions.map(({ folder }) => relative(".", join(folder, "..")) || "."));
  const notes = [...plan.notes].map(([note, count]) => `${count} ${note}`);
  const came = plan.sessions.length === 0 ? "nothing new" : `${plan.sessions.length} session${plan.sessions.length === 1 ? "" : "s"}, ${mb(plan.total_bytes)}, in ${[...folders].join(", ")}`;
  return [came, ...notes, ...(removed > 0 ? [`${removed} deleted on the robot`] : [])].join("; ");
}

async function main(words) {
  const { names, options } = readCommandLine("logs", words, kOptions);
  const file = robotsFile(options.robots);
  const robots = pick(readTeam(file), names, file);
  const lines = new Lines(robots.map((robot) => robot.name));
  const plans = new Map();
  const tell = (robot) => (text) => lines.tell(robot.name, text);

  let good = await sideBySide(lines, robots, async (robot) => {
    lines.say(robot.name, "looks at the recordings", { passing: true });
    plans.set(robot.name, await planRobot(robot, options, tell(robot)));
  });
  for (const isNow of [({ size_bytes }) => size_bytes <= kSmall_bytes, ({ size_bytes }) => size_bytes > kSmall_bytes])
    good = await sideBySide(lines, good, (robot) => {
      const plan = plans.get(robot.name);
      return bringFiles(plan, isNow, () => lines.say(robot.name, `${mb(plan.done_bytes)} of ${mb(plan.total_bytes)}`, { passing: true }));
    });
  good = await sideBySide(lines, good, async (robot) => {
    const plan = plans.get(robot.name);
    lines.say(robot.name, summary(plan, await removeArrived(plan, tell(robot))));
  });
  for (const { recordings } of plans.values()) recordings.close();
  return good.length === robots.length ? 0 : 1;
}

await runMain("logs", main);
