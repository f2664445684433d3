// What does one small message to one viewer cost, beside the plain way of one async_write per message?
import { start } from "./programs.mjs";
import { median, Report } from "./report.mjs";

const kRounds = 3;

export async function fanout({ seconds = 3 }) {
  const report = new Report(
    "fanout",
    "how many messages does a second of CPU time carry, beside one async_write per message?",
  );
  console.log(
    "   counted: CPU time of the whole server process, the thread that feeds it included but not the making of the",
  );
  console.log(
    "   messages, and messages that arrived. Clients are another process; the same bytes, as many clients, in turns.",
  );
  for (const [bytes, bar] of [
    [64, 10],
    [1024, 3],
  ])
    for (const clients of [1, 4]) {
      const found = { ours: [], beast: [] };
      for (let round = 0; round < kRounds; ++round)
        for (const server of ["ours", "beast"]) {
          const args = ["--server", server, "--bytes", bytes, "--clients", clients, "--seconds", seconds];
          found[server].push((await start("bench_fanout", args).report).per_cpu_second);
        }
      const name = `${bytes} B, ${clients} client${clients > 1 ? "s" : ""}`;
      report.figure(`${name}: net::Server`, median(found.ours) / 1e6, "M messages per CPU-s");
      report.figure(`${name}: async_write per message`, median(found.beast) / 1e6, "M messages per CPU-s");
      report.figure(`${name}: ratio`, median(found.ours) / median(found.beast), "x", { atLeast: bar });
    }
  return report.finish();
}
