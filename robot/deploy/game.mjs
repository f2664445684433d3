// Whether a robot may be touched: not while it plays.
import { RobotFailed } from "./failure.mjs";

const kUnderWay = ["ready", "set", "playing"];

/** What /api/status says: {build, game, ...}; undefined where no runtime answers, or not as one does. */
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

/** "PLAYING", or undefined when no game is under way. */
export function gameUnderWay(status) {
  const { state = "", in_progress = false } = status?.game ?? {};
  if (kUnderWay.includes(state)) return state.toUpperCase();
  return in_progress ? (state.toUpperCase() || "in progress") : undefined;
}

/** Throws while a game is under way, unless `force`. A robot without a runtime that listens has none to disturb. */
export async function refuseInGame(connection, { force = false } = {}) {
  const game = gameUnderWay(await statusOf(connection));
  if (game && !force) throw new RobotFailed(`the game is ${game}; nothing was touched (--force does it all the same)`);
}
