// Games of the simulator, each as one line of foresight-sim match --lines.
import { cases } from "./programs.mjs";

const kOptions = {
  rules: "--rules",
  home: "--home",
  away: "--away",
  models: "--models",
  homeModels: "--home-models",
  awayModels: "--away-models",
  players: "--players",
};

/** The words of foresight-sim for a choice: {rules, home, away, models, homeModels, awayModels, players, everyTick}. */
export const words = (choice) => [
  ...Object.entries(kOptions).flatMap(([key, option]) => (choice[key] === undefined ? [] : [option, choice[key]])),
  ...(choice.everyTick ? ["--every-tick"] : []),
];

/** The games with the seeds first .. first + count - 1, in this order, on `jobs` processors. */
export function play(choice, count, { jobs, first = 1 }) {
  const args = ["match", "--lines", "--games", count, "--seed", first, "--threads", jobs, ...words(choice)];
  return cases("foresight-sim", args);
}

/** A series that grows on demand. */
export class Series {
  #choice;
  #jobs;
  #games = [];

  constructor(choice, jobs) {
    this.#choice = choice;
    this.#jobs = jobs;
  }

  /** The first `count` games. */
  async first(count) {
    const known = this.#games.length;
    if (known < count)
      this.#games.push(...(await play(this.#choice, count - known, { jobs: this.#jobs, first: known + 1 })));
    return this.#games.slice(0, count);
  }
}

/** Of a figure that both sides have: their mean, their sum, home less away. */
export const both = (name) => (game) => (game.home[name] + game.away[name]) / 2;
export const sum = (name) => (game) => game.home[name] + game.away[name];
export const lead = (name) => (game) => game.home[name] - game.away[name];

/** Time until the first goal [s]; in a goalless game its whole length. */
export const firstGoal = (game) => game.first_goal_seconds ?? game.seconds;
