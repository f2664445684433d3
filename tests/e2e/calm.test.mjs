// The viewer says what it does not know: a span without data, an old value, a field that nobody reports.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { kPhone, open, shoot } from "./browser.mjs";
import { Live } from "./live.mjs";
import { mcapOf, readSession, readStreamed, spanOf } from "./mcap.mjs";
import { play, start, synthesize, temporaryFolder, until } from "./support.mjs";

const kSecond = 1_000_000_000n;
const nanoseconds = ({ sec, nsec }) => BigInt(sec) * kSecond + BigInt(nsec);

/** A recording of 4 s whose last two seconds come a minute later. */
async function gappy(folder) {
  const topics = readSession(await synthesize(folder, { seconds: 4 }));
  const { first_ns: start_ns } = spanOf(topics);
  const kept = [...topics].filter(([topic]) => /\/(pose|ball|game|decision|world)$/.test(topic));
  const channels = kept.map(([topic, { schema }]) => ({ topic, encoding: "protobuf", schema }));
  const moved = (logTime) => (logTime - start_ns < 2n * kSecond ? logTime : logTime + 60n * kSecond);
  const messages = kept.flatMap(([topic, { messages }]) =>
    messages.map(({ logTime, data }) => ({ topic, logTime: moved(logTime), data })),
  );
  messages.sort((a, b) => Number(a.logTime - b.logTime));
  const file = join(folder, "gappy.mcap");
  writeFileSync(file, await mcapOf(channels, messages));
  return { file, start_ns };
}

test("a moment without data says so, and a button leads to the nearest one that has data", async (t) => {
  const folder = temporaryFolder(t);
  const { file, start_ns } = await gappy(folder);
  const server = await play(t, folder, file);
  const moment_ns = start_ns + 50n * kSecond;
  for (const [name, options] of [
    ["desktop", { colorScheme: "light" }],
    ["phone", { viewport: kPhone, colorScheme: "dark" }],
  ]) {
    const { page, problems } = await open(t, `${server.http}/#/14/2/field?at=${moment_ns}`, options);
    const gap = page.getByText("nothing is kept here");
    await gap.waitFor();
    // the second part begins in the second 62
    const begin = new Date(Number((start_ns + 62n * kSecond) / 1_000_000n)).toISOString().slice(11, 19);
    await page.getByText(`nothing is kept here; nearest ${begin} –`).waitFor();
    await shoot(page, `gap-${name}`);
    await gap.getByRole("button", { name: "go" }).click();
    await gap.waitFor({ state: "detached" });
    await until(
      () => /at=\d+/.test(page.url()) && BigInt(/at=(\d+)/.exec(page.url())[1]) - start_ns >= 62n * kSecond,
      "the moment of the button",
    );
    assert.ok(BigInt(/at=(\d+)/.exec(page.url())[1]) - start_ns < 63n * kSecond, page.url());
    await shoot(page, `gap-${name}-gone`);
    assert.deepEqual(problems, []);
  }
});

test("a retained value does not stretch the strip of a recording", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 4 });
  const { first_ns: start_ns } = spanOf(readSession(session));
  const path = join(session, "14.2.battery.mcap");
  const [[topic, { schema, messages }]] = readStreamed(readFileSync(path)).topics;
  const [first, ...others] = messages.map(({ logTime, data }) => ({ topic, logTime, data }));
  writeFileSync(
    path,
    await mcapOf(
      [{ topic, encoding: "protobuf", schema }],
      [{ ...first, logTime: first.logTime - 123n * kSecond }, ...others],
    ),
  );
  const server = await play(t, folder, session);
  const live = await Live.open(t, server);
  const { dataStartTime, dataEndTime } = live.infos[0];
  assert.equal(nanoseconds(dataStartTime), start_ns);
  assert.ok(nanoseconds(dataEndTime) - start_ns < 5n * kSecond);
  await live.subscribe(topic);
  assert.ok(
    [first.logTime - 123n * kSecond, ...others.map(({ logTime }) => logTime)].includes(
      (await live.newest(topic)).log_ns,
    ),
    "its time stays true",
  );
  const { page, problems } = await open(t, `${server.http}/#/14/2/field?at=${start_ns}`);
  await page.getByLabel("Elapsed").filter({ hasText: "0:00 / 0:04" }).waitFor();
  await shoot(page, "retained");
  assert.deepEqual(problems, []);
});

test("the field and the rules are in recordings and live streams, so that nobody has to choose them", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder);
  const { metadata } = readStreamed(readFileSync(join(session, "14.2.pose.mcap")));
  assert.equal(metadata.get("foresight.session").rules, "spl2025");
  const recorded = await play(t, folder, session);
  const attached = await start(
    t,
    folder,
    "foresight-robot",
    "--body",
    "attached",
    "--team",
    "14",
    "--player",
    "2",
    "--rules",
    "spl2012",
    "--door",
    join(folder, "door"),
  );
  for (const [server, rules] of [
    [recorded, "spl2025"],
    [attached, "spl2012"],
  ]) {
    const live = await Live.open(t, server);
    assert.equal(live.infos[0].metadata.rules, rules);
  }
  const { page, problems } = await open(t, `${recorded.http}/#/14/2/field`);
  await page.getByLabel("The field from above").waitFor();
  await until(async () => (await page.getByLabel("Size of the field").count()) === 0, "a field that is reported");
  assert.deepEqual(problems, []);
});
