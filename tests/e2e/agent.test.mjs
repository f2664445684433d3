// A team without a behaviour of its own: our agent decides from the data that the team's process writes.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import { Live } from "./live.mjs";
import { bin, run, start, temporaryFolder } from "./support.mjs";

test("with --behaviour the robot decides from the beliefs of a team's process, which reads the commands", async (t) => {
  const door = join(temporaryFolder(t), "door");
  const server = await start(
    t,
    temporaryFolder(t),
    "foresight-robot",
    "--body",
    "attached",
    "--behaviour",
    "baseline",
    "--team",
    "14",
    "--player",
    "2",
    "--door",
    door,
  );
  const live = await Live.open(t, server);
  await live.subscribe("/14/2/decision", "/14/2/motion_command");
  await live.newest("/14/2/motion_command"); // it stands until it knows where it is

  const framework = promisify(execFile)(join(bin, "example_team_framework"), ["8"], {
    env: { ...process.env, FORESIGHT_DOOR: door },
    timeout: 60000,
  });
  const decision = await live.newest("/14/2/decision");
  assert.ok(decision, "a decision with its reasons");
  const { stdout } = await framework;
  const commands = Number(/^(\d+) commands/.exec(stdout)?.[1]);
  assert.ok(commands > 0, `the framework reads commands of the agent, got: ${stdout}`);
});

test("--behaviour is refused with a sentence: an unknown name, another body, another first strategy", async () => {
  const refused = async (words, sentence) => {
    const { status, stderr } = await run("foresight-robot", ...words);
    assert.equal(status, 2, words.join(" "));
    assert.match(stderr, sentence);
  };
  await refused(["--body", "attached", "--behaviour", "nonsense"], /--behaviour: no strategy 'nonsense'/);
  await refused(["--body", "sim", "--behaviour", "baseline"], /--behaviour: expected --body attached or nao, got sim/);
  await refused(
    ["--body", "attached", "--behaviour", "passing", "--strategies", "baseline,passing"],
    /--behaviour: expected the first of --strategies, 'baseline', got 'passing'/,
  );
});
