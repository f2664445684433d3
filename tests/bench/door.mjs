// Does a team's process reach memory without loss and without waiting, also when either side is killed?
import { spawn } from "node:child_process";
import { existsSync, rmSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { atEnd, command, scratch, sleep, start } from "./programs.mjs";
import { Report } from "./report.mjs";

const path = (relative) => fileURLToPath(new URL(relative, import.meta.url));
const kBlock = 5; // [ms] most that a call may wait

/** foresight-robot with an open door; resolves when a process can connect. */
async function openRuntime(...words) {
  const folder = join(scratch, "door-logs");
  rmSync(folder, { recursive: true, force: true });
  const runtime = start("foresight-robot", [
    "--body",
    "attached",
    "--port",
    0,
    "--state-dir",
    join(scratch, "state"),
    "--log-dir",
    folder,
    ...words,
  ]);
  await Promise.race([
    runtime.output,
    (async () => {
      while (!existsSync(process.env.FORESIGHT_DOOR)) await sleep(0.002);
    })(),
  ]);
  return {
    ...runtime,
    folder,
    kill: () => process.kill(runtime.pid, "SIGKILL"),
    ended: runtime.output.catch(() => {}),
  };
}

function startPython(seconds) {
  const child = spawn("python3", [path("door_peer.py"), String(seconds)], {
    stdio: ["ignore", "pipe", "inherit"],
    env: { ...process.env, PYTHONPATH: path("../../robot/client") },
  });
  atEnd(() => child.kill("SIGKILL"));
  let text = "";
  child.stdout.on("data", (data) => (text += data));
  return new Promise((done, fail) =>
    child.on("close", (code) =>
      code === 0 ? done(JSON.parse(text)) : fail(new Error(`door_peer.py ended with ${code}`)),
    ),
  );
}

/** 83 Hz of joints and 30 Hz of raw images of two processes at once, all of it recorded. */
async function nothingLost(report, seconds) {
  console.log(`   joints and images from C and from Python: ${seconds} s …`);
  const runtime = await openRuntime("--record", "--profile", "full");
  const [c, python] = await Promise.all([start("bench_door_peer", ["sensors", seconds]).report, startPython(seconds)]);
  await sleep(1);
  runtime.stop();
  await runtime.ended;
  const session = command("ls", runtime.folder).trim().split("\n").at(-1);
  const info = JSON.parse(
    command(path("../../build/release/bin/foresight-lab"), "info", "--json", join(runtime.folder, session)),
  );
  const recorded = (topic) => info.streams.find((stream) => stream.topic === `/14/2/${topic}`)?.messages ?? 0;
  for (const [name, process, joints, camera] of [
    ["C", c, "joints", "camera_top"],
    ["Python", python, "python_joints", "python_camera"],
  ]) {
    report.figure(
      `${name}: lost on the way to the recording`,
      process.joints.calls + process.images.calls - recorded(joints) - recorded(camera),
      `of ${process.joints.calls + process.images.calls}`,
      { exactly: 0 },
    );
    report.figure(`${name}: joints`, recorded(joints) / seconds, "Hz");
    report.figure(`${name}: images`, recorded(camera) / seconds, "Hz");
    report.figure(
      `${name}: processor per small write`,
      process.joints.cpu_us,
      "us",
      name === "C" ? { atMost: 50 } : {},
    );
    report.figure(`${name}: processor per image`, process.images.cpu_us, "us");
  }
  report.figure("C: longest small write", c.joints.longest_ms, "ms");
}

function tellPeer(report, name, peer) {
  report.figure(`${name}: torn messages`, peer.torn, `of ${peer.seen}`, { exactly: 0 });
  report.figure(
    `${name}: longest call that waited`,
    Math.max(peer.writes.longest_wait_ms, peer.reads.longest_wait_ms),
    "ms",
    { atMost: kBlock },
  );
  report.figure(
    `${name}: longest call, pushed off the processor included`,
    Math.max(peer.writes.longest_ms, peer.reads.longest_ms),
    "ms",
  );
  report.figure(`${name}: calls`, peer.writes.calls + peer.reads.calls);
}

async function killRuntimes(report, kills) {
  console.log(`   kill -9 of the runtime, ${kills} times …`);
  const peer = start("bench_door_peer", ["pulse", "pulse"]);
  for (let i = 0; i < kills; ++i) {
    const runtime = await openRuntime();
    await sleep(Math.random() * 0.25); // a client tries again every 0.1 s
    runtime.kill();
    await runtime.ended;
    // the next runtime removes this socket itself; here its absence only shows when that runtime is there
    rmSync(process.env.FORESIGHT_DOOR, { force: true });
  }
  peer.stop();
  tellPeer(report, `runtime killed ${kills} times`, await peer.report);
}

async function killProcesses(report, kills) {
  console.log(`   kill -9 of a process, ${kills} times …`);
  const runtime = await openRuntime();
  const bystander = start("bench_door_peer", ["pulse", "bystander"]);
  const judge = start("bench_door_peer", ["watch", "judged"]);
  for (let i = 0; i < kills; ++i) {
    const victim = start("bench_door_peer", ["pulse", "judged"]);
    await sleep(0.002 + Math.random() * 0.06);
    process.kill(victim.pid, "SIGKILL");
    await victim.output.catch(() => {});
  }
  await sleep(0.3);
  bystander.stop();
  judge.stop();
  const [untouched, judged] = [await bystander.report, await judge.report];
  report.figure(
    `a process killed ${kills} times: the runtime goes on`,
    Number(existsSync(`/proc/${runtime.pid}`)),
    "",
    { exactly: 1 },
  );
  report.figure(`a process killed ${kills} times: torn messages`, judged.torn, `of ${judged.seen}`, { exactly: 0 });
  report.figure(
    `a process killed ${kills} times: lost by another process`,
    untouched.lost + untouched.missed,
    `of ${untouched.writes.calls}`,
    { exactly: 0 },
  );
  tellPeer(report, "another process meanwhile", untouched);
  runtime.stop();
  await runtime.ended;
}

export async function door({ seconds = 60, kills = 1000 }) {
  const report = new Report("door", "does a team's process reach memory without loss and without waiting?");
  process.env.FORESIGHT_DOOR = join(scratch, "door");
  await nothingLost(report, seconds);
  await killRuntimes(report, kills);
  await killProcesses(report, kills);
  return report.finish();
}
