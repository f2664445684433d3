// node tests/bench/run.mjs NAME [--seconds N] [--minutes N] [--speed N] [--games N] [--kills N] [--jobs N] [--probes N] [--length N] [--large N] [--rollouts N] [--choices N] [--moments N] [--files N]; see scripts/bench.
import { budget } from "./budget.mjs";
import { compare } from "./compare.mjs";
import { debuggerTimes } from "./debugger.mjs";
import { deploy } from "./deploy.mjs";
import { door } from "./door.mjs";
import { environment } from "./environment.mjs";
import { learning } from "./learn.mjs";
import { equivalence } from "./equivalence.mjs";
import { fanout } from "./fanout.mjs";
import { faults } from "./faults.mjs";
import { fit } from "./fit.mjs";
import { foresight } from "./foresight.mjs";
import { half } from "./half.mjs";
import { interference } from "./interference.mjs";
import { lola } from "./lola.mjs";
import { matchDays } from "./match_days.mjs";
import { mcap } from "./mcap.mjs";
import { nao } from "./nao.mjs";
import { realism } from "./realism.mjs";
import { shaped } from "./shaped.mjs";
import { sim } from "./sim.mjs";
import { soak } from "./soak.mjs";
import { soccer } from "./soccer.mjs";
import { streaming } from "./streaming.mjs";
import { thesis } from "./thesis.mjs";
import { truth } from "./truth.mjs";
import { verdicts } from "./verdicts.mjs";
import { viewer } from "./viewer.mjs";
import { vivid } from "./vivid.mjs";
import { walk } from "./walk.mjs";

const benches = {
  streaming,
  half,
  interference,
  shaped,
  fanout,
  soak,
  faults,
  "match-days": matchDays,
  door,
  sim,
  environment,
  learn: learning,
  equivalence,
  soccer,
  realism,
  nao,
  vivid,
  lola,
  budget,
  viewer,
  deploy,
  compare,
  verdicts,
  thesis,
  foresight,
  debugger: debuggerTimes,
  mcap,
  truth,
  fit,
  walk,
};

const [name, ...words] = process.argv.slice(2);
const options = {};
for (let i = 0; i < words.length; i += 2) options[words[i].slice(2)] = Number(words[i + 1]);

let met = true;
for (const bench of name === "all" ? Object.values(benches) : [benches[name]]) {
  try {
    met = (await bench(options)) && met;
  } catch (error) {
    console.error(`bench: ${error.message}`);
    met = false;
  }
}
// no child program is left that would keep this process running
process.exit(met ? 0 : 1);
