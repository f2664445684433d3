// Match mode on real network interfaces: tcpdump captures the packets on the wireless one during a game.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { asker, gameController, kWired, kWireless, network, questioner, State, viewer, whyNoHosts } from "./hosts.mjs";
import { atEnd, start, synthesize, temporaryFolder, until, within } from "./support.mjs";

/** All packets from the robot's wireless address: [{seconds, text}] since the capture began. */
function capture(t, host, file) {
  const child = spawn(host[0], [...host.slice(1), "tcpdump", "-i", "wlan0", "-U", "-w", file, "src", kWireless], {
    stdio: ["ignore", "ignore", "pipe"],
  });
  let talk = "";
  child.stderr.on("data", (bytes) => (talk += bytes));
  atEnd(t, () => child.kill("SIGKILL"));
  return {
    begun: () => until(() => talk.includes("listening on"), "tcpdump listens"),
    packets: async () => {
      child.kill("SIGINT");
      await within(new Promise((ended) => child.on("close", ended)), "the end of tcpdump");
      const text = execFileSync("tcpdump", ["-nn", "-tt", "-r", file], {
        encoding: "utf8",
        stdio: ["ignore", "pipe", "ignore"],
      });
      return text
        .trim()
        .split("\n")
        .filter(Boolean)
        .map((line) => ({ seconds: Number(line.split(" ")[0]), text: line }));
    },
  };
}

test(
  "during a game only messages that the rules allow leave over the wireless network",
  { skip: whyNoHosts("tcpdump") },
  async (t) => {
    const folder = temporaryFolder(t);
    const { robot, field, lab } = network(t);
    await start(
      t,
      folder,
      [...robot, "foresight-robot"],
      "--body",
      "attached",
      "--team",
      "14",
      "--player",
      "2",
      "--bind",
      "0.0.0.0",
      "--port",
      "8765",
      "--wireless",
      "wlan0",
      "--game-controller",
      "--return-packets",
      "--profile",
      "game",
    );
    const token = readFileSync(join(folder, "state/token"), "utf8").trim();

    const game = gameController(t, field);
    const besideTheField = viewer(t, field, kWireless, "");
    const byCable = viewer(t, lab, kWired, `?token=${token}`);
    const statusByAir = asker(t, field, kWireless, "/api/status");
    await until(() => besideTheField.said.some(({ op }) => op === "serverInfo"), "the viewer by air is served");
    await until(() => statusByAir.said.at(-1) === 200, "the status by air");

    const captured = capture(t, robot, join(folder, "wlan0.pcap"));
    await captured.begun();
    game.tell(State.ready);
    await until(() => besideTheField.said.at(-1).op === "closed", "the viewer by air is disconnected");
    await until(() => statusByAir.said.at(-1) === 0, "no status by air");
    const silence = Date.now() / 1000;

    // over a cable viewers are served
    const statusByCable = asker(t, lab, kWired, "/api/status");
    const logByCable = asker(t, lab, kWired, `/logs/any.mcap?token=${token}`);
    await until(() => statusByCable.said.at(-1) === 200, "the status by cable");
    await until(() => logByCable.said.at(-1) === 503, "a recording refused by cable");
    byCable.tell({ op: "setParameters", parameters: [{ name: "match_mode", value: false }] });
    await until(
      () => byCable.said.some(({ message }) => message?.includes("a game is in progress")),
      "a refusal by cable",
    );

    for (const state of [State.set, State.playing]) {
      game.tell(state);
      const knocked = statusByAir.said.length;
      await until(() => statusByAir.said.length > knocked + 1, "requests without an answer");
    }
    const finished = Date.now() / 1000;
    const packets = await captured.packets();
    game.tell(State.finished);
    await until(() => statusByAir.said.at(-1) === 200, "the status by air again");
    assert.equal(
      byCable.said.some(({ op }) => op === "closed"),
      false,
    );

    const during = packets.filter(({ seconds }) => seconds > silence && seconds < finished);
    const answers = during.filter(({ text }) => / > 10\.0\.14\.1\.3939: UDP/.test(text));
    assert.ok(answers.length >= 2, "it answers the GameController");
    assert.deepEqual(
      during.filter((packet) => !answers.includes(packet) && !/ARP/.test(packet.text)),
      [],
    );
  },
);

test(
  "a question with the token is answered by cable during PLAYING, and gets no answer over the wireless network",
  { skip: whyNoHosts() },
  async (t) => {
    const folder = temporaryFolder(t);
    const { robot, field, lab } = network(t);
    const words = [
      "--body",
      "replay",
      "--session",
      await synthesize(folder),
      "--loop",
      "--team",
      "14",
      "--player",
      "2",
    ];
    const reach = ["--bind", "0.0.0.0", "--port", "8765", "--wireless", "wlan0", "--game-controller"];
    await start(t, folder, [...robot, "foresight-robot"], ...words, ...reach);
    const token = readFileSync(join(folder, "state/token"), "utf8").trim();
    const question = { budget_ms: 200, horizon: 2 };
    const ask = async (who, what) => {
      const before = who.said.length;
      who.tell(question);
      return until(() => who.said.slice(before).find(({ op }) => op !== "ready"), what);
    };

    // before the game both networks answer
    const game = gameController(t, field);
    const byAir = questioner(t, field, kWireless, `?token=${token}`);
    const byCable = questioner(t, lab, kWired, `?token=${token}`);
    const stranger = questioner(t, lab, kWired, "");
    for (const [name, who] of Object.entries({ byAir, byCable, stranger }))
      await until(() => who.said.some(({ op }) => op === "ready"), `the services for ${name}`);
    const early = await until(async () => {
      const said = await ask(byAir, "the answer by air before the game");
      return !/there is no object game yet/.test(said.answer?.error) && said; // until the first packet has arrived
    }, "the robot knows of a game");
    assert.match(early.answer?.error ?? "", /the game has not begun/, JSON.stringify(early));

    const state = asker(t, lab, kWired, "/api/status", "(await answer.json()).game.state");
    for (const next of ["ready", "set", "playing"]) {
      game.tell(State[next]);
      await until(() => state.said.at(-1) === next, `the robot in ${next}`);
    }
    await until(() => byAir.said.at(-1).op === "closed", "the end of the connection by air");
    const answered = await ask(byCable, "the answer by cable");
    assert.equal(answered.answer?.ok, true, JSON.stringify(answered));
    assert.ok(answered.answer.forecast.strategies.length > 0, JSON.stringify(answered.answer).slice(0, 300));
    const refused = await ask(stranger, "the refusal without the token");
    assert.match(JSON.stringify(refused), /needs the control token/);

    const again = questioner(t, field, kWireless, `?token=${token}`);
    await until(() => again.said.at(-1)?.op === "closed", "no connection by air");
    assert.equal(again.said.length, 1, "not even our name was sent by air");

    game.tell(State.finished);
    const after = questioner(t, field, kWireless, `?token=${token}`);
    await until(
      () => after.said.some(({ op }) => op === "ready" || op === "closed"),
      "an answer by air after the game",
    );
  },
);
