// Match days at speed, with a fault each ten seconds: does the robot's program live, and is every message accounted for?
import { execFileSync } from "node:child_process";
import {
  closeSync,
  existsSync,
  mkdirSync,
  openSync,
  readdirSync,
  renameSync,
  rmSync,
  statfsSync,
  writeFileSync,
  writeSync,
} from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Account, kGamePort, look, program, startGameController, use } from "./match_day.mjs";
import { atEnd, scratch, sleep, start } from "./programs.mjs";
import { Report } from "./report.mjs";

const kLibrary = fileURLToPath(new URL("../../build/release/bin/libfailing_calls.so", import.meta.url));
const kBetween_s = 10;
const kLasts_s = 4; // a fault that ends by itself
const kYear_ns = 365n * 86_400n * 1_000_000_000n;

/** A small disk of its own for the recordings, which can be full. Needs root. */
function makeDisk(folder, megabytes) {
  mkdirSync(folder, { recursive: true });
  execFileSync("mount", ["-t", "tmpfs", "-o", `size=${megabytes}m`, "tmpfs", folder]);
  atEnd(() => execFileSync("umount", ["-l", folder]));
}

/** Numbers that are the same in each run. */
function seeded(seed) {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

function setClock(offset_ns) {
  const bytes = Buffer.alloc(8);
  bytes.writeBigInt64LE(offset_ns);
  const file = openSync(join(scratch, "clock"), "r+");
  writeSync(file, bytes, 0, 8, 0);
  closeSync(file);
}

export async function matchDays({ minutes = 120 }) {
  const report = new Report(
    "match-days",
    "does the robot's program live through match days with a fault each ten seconds, and is every message accounted for?",
  );
  console.log(`   ${minutes} min: kill, full disk, stepping clock, moved folder, silent viewer, second GameController`);
  const disk = join(scratch, "disk");
  makeDisk(disk, 600);
  const door = join(scratch, "door");
  const before = ["env", `LD_PRELOAD=${kLibrary}`, `FORESIGHT_FAULTS=${scratch}`];
  const robot = await program(
    "foresight-robot",
    ["--body", "attached", "--team", 14, "--player", 2, "--door", door, "--game-controller", "--game-port", kGamePort],
    disk,
    { before, log_mb: 300 },
  );
  const simulated = await program(
    "foresight-robot",
    ["--body", "sim", "--seed", 7, "--speed", 10, "--loop", "--team", 15],
    join(scratch, "sim"),
  );
  const robots = [robot, simulated].map(({ url, token }) => `${url.replace("http", "ws")}/?token=${token}`);
  const startRelay = () =>
    start("foresight-lab", [
      "relay",
      ...robots,
      "--port",
      0,
      "--state-dir",
      join(scratch, "relay"),
      "--log-dir",
      join(scratch, "relay/logs"),
    ]);
  const startPeer = () => start("bench_door_peer", ["sensors", 60 * minutes + 60], ["env", `FORESIGHT_DOOR=${door}`]);
  let [relay, peer, moved] = [startRelay(), startPeer(), 0];
  let endGames = startGameController();

  const faults = {
    "the team's process is killed": async () => (process.kill(peer.pid, "SIGKILL"), (peer = startPeer())),
    "the robot's program is killed": () => robot.restart(),
    "the relay is killed": async () => (process.kill(relay.pid, "SIGKILL"), (relay = startRelay())),
    "the relay is silent": async () => (
      process.kill(relay.pid, "SIGSTOP"),
      await sleep(kLasts_s),
      process.kill(relay.pid, "SIGCONT")
    ),
    "the disk is full": async () => {
      const filler = join(disk, "filler");
      const { bavail, bsize } = statfsSync(disk);
      // the robot writes meanwhile, so the last bytes may not fit
      execFileSync("sh", ["-c", `head -c ${bavail * bsize} /dev/zero >'${filler}' || :`], { stdio: "ignore" });
      await sleep(kLasts_s);
      rmSync(filler);
    },
    "the clock steps to 1970": async () => (
      setClock(-BigInt(Date.now()) * 1_000_000n + 1_000_000_000n),
      await sleep(kLasts_s),
      setClock(0n)
    ),
    "the clock steps by ten years": async () => (setClock(10n * kYear_ns), await sleep(kLasts_s), setClock(0n)),
    "the log folder is moved": async () =>
      existsSync(join(disk, "logs")) && renameSync(join(disk, "logs"), join(disk, `moved${++moved}`)),
    "a second GameController": async () => {
      const end = startGameController();
      await sleep(kLasts_s);
      end();
    },
    "the GameController restarts": async () => (endGames(), (endGames = startGameController())),
  };
  const random = seeded(1);
  const account = new Account();
  const names = Object.keys(faults);
  const made = new Map();
  const until_ms = performance.now() + 60_000 * minutes;
  const using = use(robot, until_ms);
  while (performance.now() < until_ms && !robot.ended) {
    const name = names[random(names.length)];
    made.set(name, (made.get(name) ?? 0) + 1);
    await faults[name]();
    await sleep(kBetween_s - kLasts_s);
    // moved folders fill the small disk
    for (const old of readdirSync(disk)
      .filter((folder) => /^moved/.test(folder))
      .slice(0, -2)) {
      account.add(robot, join(disk, old));
      rmSync(join(disk, old), { recursive: true });
    }
  }
  await using;
  await sleep(3);
  await look(robot);
  endGames();
  for (const one of [peer, relay]) one.stop();
  const died = robot.ended;
  robot.child.stop();
  simulated.child.stop();
  const status = await robot.child.output.then(
    () => 0,
    () => 1,
  );
  for (const [name, count] of made) console.log(`   ${count} times: ${name}`);
  report.figure(
    "faults",
    [...made.values()].reduce((a, b) => a + b, 0),
  );
  report.figure("deaths of the robot's program", Number(died), "", { exactly: 0 });
  report.figure("it ended as asked", Number(status === 0), "", { exactly: 1 });
  for (const name of readdirSync(disk).filter((folder) => /^(logs|moved\d+)$/.test(folder)))
    account.add(robot, join(disk, name));
  account.tell(report);
  return report.finish();
}
