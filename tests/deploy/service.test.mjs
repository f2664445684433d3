// The start script that goes to the robots, in the system's shell and in busybox, and the unit for systemd.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { chmodSync, copyFileSync, existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { atEnd, root, temporaryFolder, until } from "../e2e/support.mjs";

const kOnRobot = join(root, "robot/deploy/on_robot");
const has = (tool) => spawnSync("sh", ["-c", `command -v ${tool}`]).status === 0;

const kRuntime = {
  folder: "versions/one",
  from: "current",
  starter: "foresight",
  program: "foresight-robot",
  state: "state",
};
const kGuardian = {
  folder: "guardian",
  from: "guardian",
  starter: "guardian",
  program: "foresight-guardian",
  state: "state/guardian",
};

/**
 * An installed version in a home of its own, whose program is the line of shell `program`: {home, run, state, log, running}. `run` answers
 * {status, output} of the start script. `tools`: the folder where all commands are looked for. `what` is installed.
 */
function installed(t, program, { shell = "/bin/sh", tools, what = kRuntime } = {}) {
  const home = temporaryFolder(t);
  const version = join(home, "foresight", what.folder);
  for (const folder of ["bin", "etc"]) mkdirSync(join(version, folder), { recursive: true });
  if (what.from !== what.folder) symlinkSync(what.folder, join(home, "foresight", what.from));
  writeFileSync(
    join(version, what.starter),
    readFileSync(join(kOnRobot, "foresight"), "utf8").replace("#!/bin/sh", `#!${shell}`),
  );
  writeFileSync(join(version, "bin", what.program), `#!/bin/sh\n${program}\n`);
  writeFileSync(
    join(version, "etc/settings"),
    "# a comment\nbody=attached\n\nfield=$(touch broken) `x` 'A' \\\ngame-controller",
  );
  for (const name of [what.starter, `bin/${what.program}`]) chmodSync(join(version, name), 0o755);
  const env = { HOME: home, PATH: tools ?? process.env.PATH };
  const run = (verb, more) => {
    const { status, stdout, stderr } = spawnSync(join(home, "foresight", what.from, what.starter), [verb], {
      env: { ...env, ...more },
      encoding: "utf8",
    });
    return { status, output: (stdout + stderr).trim() };
  };
  atEnd(t, () => run("stop"));
  const file = (name) => join(home, "foresight", what.state, name);
  const state = (name) => (existsSync(file(name)) ? readFileSync(file(name), "utf8").trim() : "");
  const log = () => state(`${what.starter}.log`);
  // its own log has begun
  const running = () =>
    until(
      () =>
        state("pid") &&
        log()
          .split("\n")
          .includes(`process ${state("pid")}`) &&
        Number(state("pid")),
      "the program",
    );
  return { home, run, state, log, running };
}

/** Returns true if a process has ended, also when its parent has not waited for it yet. */
function isGone(pid) {
  try {
    return readFileSync(`/proc/${pid}/cmdline`, "utf8") === "";
  } catch {
    return true;
  }
}

/** Makes a folder with the commands of busybox. */
function busyboxTools(t) {
  const folder = temporaryFolder(t);
  execFileSync("busybox", ["--install", "-s", folder]);
  return folder;
}

// each test has its own folder, and mostly waits
describe("the start script", { concurrency: true }, () => {
  const kLives = 'echo "process $$"; printf "%s\\n" "$@"; trap "exit 0" TERM; while :; do sleep 0.05; done';

  const shells = [
    ["the system's shell", () => ({}), {}],
    [
      "busybox",
      (t) => ({
        shell: `${execFileSync("sh", ["-c", "command -v busybox"], { encoding: "utf8" }).trim()} sh`,
        tools: busyboxTools(t),
      }),
      { skip: has("busybox") ? false : "there is no busybox" },
    ],
  ];
  for (const [name, options, skip] of shells) {
    test(
      `${name}: it starts, reports its status, and stops; settings become options without change`,
      skip,
      async (t) => {
        const service = installed(t, kLives, options(t));
        assert.deepEqual(service.run("status"), { status: 3, output: "is stopped" });
        assert.equal(service.run("start").status, 0);
        assert.deepEqual(service.run("status"), { status: 0, output: "runs" });
        await until(() => service.log().includes("--game-controller"), "the options");
        const options_seen = service
          .log()
          .split("\n")
          .filter((line) => line.startsWith("--"));
        assert.deepEqual(options_seen, ["--body=attached", "--field=$(touch broken) `x` 'A' \\", "--game-controller"]);
        assert.ok(!existsSync(join(service.home, "foresight/broken")));

        // a second start has no effect
        const first = service.state("pid");
        assert.equal(service.run("start").status, 0);
        assert.equal(service.state("pid"), first);
        assert.equal(service.run("stop").status, 0);
        assert.deepEqual(service.run("status"), { status: 3, output: "is stopped" });
        assert.ok(isGone(first));
        assert.equal(service.run("stop").status, 0);
      },
    );

    test(
      `${name}: it restarts after a crash, but not after the third within a minute, and reports that`,
      skip,
      async (t) => {
        const service = installed(t, kLives, options(t));
        service.run("start");
        for (let crash = 1; crash <= 3; ++crash) {
          const pid = await service.running();
          process.kill(pid, "SIGKILL");
          await until(() => service.state("pid") !== String(pid), "its end");
        }
        const down = "crashed three times within a minute and stays down: exit status 137";
        assert.deepEqual(
          await until(() => service.run("status").status === 4 && service.run("status"), "it stays down"),
          { status: 4, output: down },
        );
        assert.match(service.run("log").output, new RegExp(`foresight: ${down}$`));

        // after a start by hand, three crashes are allowed again
        service.run("start");
        assert.deepEqual(service.run("status"), { status: 0, output: "runs" });
      },
    );

    test(`${name}: a program whose supervisor was killed is stopped all the same`, skip, async (t) => {
      const service = installed(t, kLives, options(t));
      service.run("start");
      const pid = await service.running();
      process.kill(Number(service.state("supervisor")), "SIGKILL");
      assert.equal(service.run("stop").status, 0);
      assert.ok(isGone(pid));
    });
  }

  test("a program that ignores SIGTERM ends within 8 s", async (t) => {
    const service = installed(t, 'trap "" TERM; echo "process $$"; while :; do sleep 0.05; done');
    const stop_ms = async () => {
      service.run("start");
      const pid = await service.running();
      const began = performance.now();
      assert.equal(service.run("stop").status, 0);
      assert.ok(isGone(pid));
      return performance.now() - began;
    };
    // a busy machine may delay one of three, not each
    const took_ms = [];
    while (took_ms.length < 3 && !took_ms.some((time) => time < 8000)) took_ms.push(await stop_ms());
    assert.ok(Math.min(...took_ms) < 8000, `took ${took_ms.map(Math.round)} ms`);
  });

  test("a program that ends well is not started again", async (t) => {
    const service = installed(t, "exit 0");
    service.run("start");
    await until(() => service.run("status").status === 3, "its end");
    assert.match(service.log(), /foresight: ended$/);
  });

  test("five logs are kept", async (t) => {
    const service = installed(t, kLives);
    for (let run = 1; run <= 7; ++run) {
      service.run("start");
      await service.running();
      service.run("stop");
    }
    for (const number of [1, 2, 3, 4])
      assert.ok(existsSync(join(service.home, `foresight/state/foresight.${number}.log`)));
    assert.ok(!existsSync(join(service.home, "foresight/state/foresight.5.log")));
  });

  test("the start script of the guardian has its own state beside the runtime's", async (t) => {
    const service = installed(t, kLives, { what: kGuardian });
    service.run("start");
    const pid = await service.running();
    assert.match(readFileSync(`/proc/${pid}/cmdline`, "utf8"), /bin\/foresight-guardian/);
    assert.deepEqual(service.run("status"), { status: 0, output: "runs" });
    assert.ok(!existsSync(join(service.home, "foresight/state/pid")));
    assert.equal(service.run("stop").status, 0);
    assert.ok(isGone(pid));
  });

  test("a failure that systemd reports counts as a crash", (t) => {
    const service = installed(t, "exit 3");
    const crash = { SERVICE_RESULT: "exit-code", EXIT_CODE: "exited", EXIT_STATUS: "3" };
    for (let run = 1; run <= 3; ++run) {
      assert.equal(service.run("run").status, 3);
      assert.equal(service.run("status").status, 3, `${run} starts`);
      service.run("ended", crash);
    }
    assert.deepEqual(service.run("status"), {
      status: 4,
      output: "crashed three times within a minute and stays down: exit-code, exited 3",
    });
  });

  for (const [unit, what] of [
    ["foresight.service", kRuntime],
    ["foresight-guardian.service", kGuardian],
  ])
    test(
      `systemd finds nothing wrong with ${unit}`,
      { skip: has("systemd-analyze") ? false : "there is no systemd-analyze" },
      (t) => {
        const { home } = installed(t, "exit 0", { what });
        copyFileSync(join(kOnRobot, unit), join(home, unit));
        const env = { ...process.env, HOME: home, XDG_RUNTIME_DIR: home };
        const { status, stdout, stderr } = spawnSync("systemd-analyze", ["--user", "verify", join(home, unit)], {
          env,
          encoding: "utf8",
        });
        assert.deepEqual({ status, said: stdout + stderr }, { status: 0, said: "" });
      },
    );
});
