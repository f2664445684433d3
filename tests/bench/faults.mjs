// Does a single failure of the system end a program, or lose a message that nobody counts? Two robots and a relay record while
// calls for files, threads, descriptors and memory fail one after the other (failing_calls.cpp).
import { readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Account, kGamePort, look, program, startGameController, use } from "./match_day.mjs";
import { scratch, sleep, start } from "./programs.mjs";
import { Report } from "./report.mjs";

const kLibrary = fileURLToPath(new URL("../../build/release/bin/libfailing_calls.so", import.meta.url));
const kEach = 30; // failures of each place in a program
const kPause_ms = 10;

/** The words in front of a program in which calls fail. */
const failing = [
  "env",
  `LD_PRELOAD=${kLibrary}`,
  `FORESIGHT_FAULTS=${scratch}`,
  `FORESIGHT_FAULTS_EACH=${kEach}`,
  `FORESIGHT_FAULTS_PAUSE_MS=${kPause_ms}`,
];

const faultsOf = () =>
  readdirSync(scratch)
    .filter((name) => name.startsWith("faults-"))
    .flatMap((name) => readFileSync(join(scratch, name), "utf8").split("\n").filter(Boolean));

export async function faults({ seconds = 240 }) {
  const report = new Report(
    "faults",
    "does a single failure of the system end a program, or lose messages without counting them?",
  );
  console.log(
    `   two robots and a relay, ${seconds} s; each place in a program fails ${kEach} times, one failure per ${kPause_ms} ms and program`,
  );
  const door = join(scratch, "door");
  const attached = await program(
    "foresight-robot",
    ["--body", "attached", "--team", 14, "--player", 2, "--door", door, "--game-controller", "--game-port", kGamePort],
    join(scratch, "attached"),
    { before: failing },
  );
  const played = await program(
    "foresight-robot",
    ["--body", "sim", "--seed", 7, "--speed", 4, "--loop", "--record"],
    join(scratch, "sim"),
    { before: failing },
  );
  const robots = [attached, played].map(({ url, token }) => `${url.replace("http", "ws")}/?token=${token}`);
  const relay = await program(
    "foresight-lab",
    ["relay", ...robots, "--record", "--pictures", "none"],
    join(scratch, "relay"),
    { before: failing },
  );
  const programs = [attached, played, relay];
  const peer = start("bench_door_peer", ["sensors", seconds + 20], ["env", `FORESIGHT_DOOR=${door}`]);
  const endGames = startGameController();
  await sleep(3);

  writeFileSync(join(scratch, "begin"), "");
  const until_ms = performance.now() + 1000 * seconds;
  await Promise.all(programs.map((robot) => use(robot, until_ms)));
  rmSync(join(scratch, "begin"));
  await sleep(3); // the last chunks reach the disk

  for (const robot of programs) await look(robot);
  endGames();
  peer.stop();
  const deaths = programs.filter(({ ended }) => ended).length;
  for (const { child } of programs) child.stop();
  const ends = await Promise.all(
    programs.map(({ child }) =>
      child.output.then(
        () => 0,
        () => 1,
      ),
    ),
  );

  const made = faultsOf();
  const kinds = new Map();
  for (const [, kind] of made.map((line) => line.split(" "))) kinds.set(kind, (kinds.get(kind) ?? 0) + 1);
  console.log(
    `   faults: ${[...kinds]
      .map(([kind, count]) => `${kind} ${count}`)
      .sort()
      .join(", ")}`,
  );
  report.figure("single faults", made.length, "", { atLeast: 2000 });
  report.figure("places in the programs that failed", new Set(made.map((line) => line.split(" ")[3])).size);
  report.figure("programs that died", deaths, "", { exactly: 0 });
  report.figure("programs that did not end as asked", ends.filter(Boolean).length, "", { exactly: 0 });
  const account = new Account();
  for (const robot of programs) account.add(robot, join(robot.folder, "logs"));
  account.tell(report);
  return report.finish();
}
