// The check before each change of a robot: no game may be in progress.
import { RobotFailed } from "./failure.mjs";

const kUnderWay = ["ready", "set", "playing"];

/** Returns the answer of /api/status, {build, game, ...}; undefined if no runtime answers or the answer is not its own. */
export async function statusOf(connection) {
  const answer = await connection.get("/api/status");
  if (answer?.status === 503 && /game (is )?in progress/.test(answer.body)) return { game: { state: "", in_progress: true } };
  if (answer?.status !== 200) return undefined;
  try {
    return JSON.parse(answer.body);
  } catch {
    return undefined;
  }
}

/** Returns the state of the game, such as "PLAYING", or undefined if no game is in progress. */
export function gameUnderWay(status) {
  const { state = "", in_progress = false } = status?.game ?? {};
  if (kUnderWay.includes(state)) return state.toUpperCase();
  return in_progress ? (state.toUpperCase() || "in progress") : undefined;
}

/** Throws while a game is in progress, unless `force`. A robot without a running runtime counts as not in a game. */
export async function refuseInGame(connection, { force = false } = {}) {
  const game = gameUnderWay(await statusOf(connection));
  if (game && !force) throw new RobotFailed(`the game is ${game}; nothing was changed (--force does it anyway)`);
}
