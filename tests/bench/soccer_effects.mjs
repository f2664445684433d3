// The expected change by each effect of reality: the models match with this effect switched over, beside the models match.
import { both, Series } from "./games.mjs";
import { differenceOf, meanOf } from "./statistics.mjs";

export const kSure = 4; // standard errors; repeated looks after more games do not reach this by luck
const kFirst = 20; // games at first; then twice as many each time

const of =
  (figure, scale = 1) =>
  (game) =>
    scale * both(figure)(game);
const percent = (figure) => of(figure, 100);
const millimetres = (figure) => of(figure, 1000); // a change by 1 mm/s shows in a figure
const degrees = (figure) => of(figure, 180 / Math.PI);

/** `to`: the setting that match does not have. `sign`: +1 where the statistic must grow by that, -1 where it must shrink. */
const effect = (name, to, sign, statistic, value, unit = "") => ({ name, to, sign, statistic, value, unit });

export const kEffects = [
  effect("limited_view", "off", +1, "ball seen", percent("ball_seen"), "%"),
  effect("missed_ball", "off", +1, "ball seen", percent("ball_seen"), "%"),
  effect("occlusion", "off", +1, "ball seen", percent("ball_seen"), "%"),
  effect("false_balls", "off", -1, "ball seen where it is not", percent("ball_astray"), "%"),
  effect("ball_noise", "off", -1, "error of the ball in view", of("ball_error"), "m"),
  effect("latency", "off", -1, "error of a rolling ball in view", of("moving_ball_error"), "m"),
  effect("odometry_drift", "off", -1, "error of the own place", of("pose_error"), "m"),
  effect("pose_flips", "off", -1, "field believed turned round", percent("flipped"), "%"),
  effect("packet_limit", "off", +1, "packets of a side", of("packets")),
  effect("packet_delay", "off", -1, "age of mates' news", of("news_age"), "s"),
  effect("packet_loss", "off", -1, "age of mates' news", of("news_age"), "s"),
  effect("walk_acceleration", "off", +1, "speed while walking", millimetres("speed"), "mm/s"),
  effect("walk_noise", "off", +1, "speed while walking", millimetres("speed"), "mm/s"),
  effect("walk_spread", "off", +1, "speed while walking", millimetres("speed"), "mm/s"),
  effect("walk_delay", "off", -1, "time between standing and walking", percent("shifting"), "%"),
  effect("head_limits", "off", +1, "ball seen", percent("ball_seen"), "%"),
  effect("kick_noise", "off", -1, "kicked ball off its aim", degrees("kick_astray"), "deg"),
  effect("kick_whiff", "off", -1, "kicks that miss the ball", of("whiffs")),
  effect("partial_hits", "off", -1, "kicked ball off its aim", degrees("kick_astray"), "deg"),
  effect("push_noise", "off", -1, "pushed ball off its way", degrees("push_astray"), "deg"),
  effect("falls", "off", -1, "time on the ground", percent("down"), "%"),
  effect("lost_pose", "off", -1, "error of the own place", of("pose_error"), "m"),
  effect("duels", "off", -1, "pushed ball off its way", degrees("push_astray"), "deg"),
  effect("official", "on", -1, "ball seen", percent("ball_seen"), "%"),
];

/** Plays until the difference is sure, or `most` games. `plain` are games of match with the same seeds. */
export async function settle({ name, to, sign, value }, plain, most, jobs) {
  const switched = new Series({ models: `match,${name}=${to}` }, jobs);
  for (let count = Math.min(kFirst, most); ; count = Math.min(2 * count, most)) {
    const [without, after] = [(await plain.first(count)).map(value), (await switched.first(count)).map(value)];
    const difference = differenceOf(after, without);
    const sure = sign * difference.mean > kSure * difference.error;
    if (sure || count === most) return { games: count, without: meanOf(without).mean, difference };
  }
}
