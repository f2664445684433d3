#include "sim/agent/features.h"

#include <cassert>
#include <iterator>
#include <limits>

#include "sim/agent/own.h"
#include "sim/agent/roles.h"

namespace sim::agent {
namespace {

using Kind = FeatureInfo::Kind;
using Compute = float (*)(const View&);

constexpr float kDeceleration = 0.3f;  // [m/s²] usual on turf; B-Human's ballSpecification.cfg
constexpr float kRolls = 0.05f;        // [m/s] a slower ball does not come nearer
constexpr float kBeside = 0.4f;        // [m] a ball seen to pass a post at this distance may still go in
constexpr float kShort = 0.3f;         // share of the way to the line: a fast ball seems slow at first
constexpr float kFar = 1e6f;           // [m², s] more than any distance or age that counts

constexpr float kFarthestClearance = 10;  // [m]
constexpr float kShadow = 0.25f;          // [m] half of the width that a robot and the ball cover
constexpr float kBallRadius = 0.1f;       // [m] room between the middle of the ball and a post
constexpr float kInFront = 0.05f;         // [m] an opponent nearer than this in front of the ball hides nothing
constexpr float kBehindLine = 0.1f;       // [m] an opponent farther behind the goal line hides nothing

constexpr float kShortestPass = 0.8f;   // [m]
constexpr float kLongestPass = 4.5f;    // [m] about as far as the long kick carries
constexpr float kPassClearance = 0.4f;  // [m] from the line of the pass to the nearest opponent

/// Returns the time [s] in which a ball of that speed rolls `way` [m], or NaN when it stops before.
float rolling_time(float speed, float way) {
  const float left = speed * speed - 2 * kDeceleration * way;
  return left < 0 ? kUnknown : (speed - std::sqrt(left)) / kDeceleration;
}

/// Returns the distance [m] from `from` to the nearest opponent, or NaN when none is known.
float nearest_opponent(const View& view, Vec2 from) {
  float nearest = kFar;
  view.for_each_opponent([&](Vec2 opponent) {
    const float squared = squared_length(opponent - from);
    if (squared < nearest) nearest = squared;
  });
  return nearest < kFar ? std::sqrt(nearest) : kUnknown;
}

float nearest_mate(const View& view) {
  float nearest = kFar;
  view.for_each_mate([&](const Mate& mate, int) {
    const float squared = squared_length(mate.pose.position - view.position);
    if (squared < nearest) nearest = squared;
  });
  return nearest < kFar ? std::sqrt(nearest) : kUnknown;
}

float quickest_mate(const View& view) {
  float quickest = kUnknown;
  view.for_each_mate([&](const Mate& mate, int index) {
    if (view.player_of_mate(index) == 1) return;
    if (!(quickest <= mate.time_to_ball())) quickest = mate.time_to_ball();
  });
  return quickest;
}

float count_mates(const View& view) {
  float count = 0;
  view.for_each_mate([&](const Mate&, int) { count += 1; });
  return count;
}

float count_opponents(const View& view) {
  float count = 0;
  view.for_each_opponent([&](Vec2) { count += 1; });
  return count;
}

/// Returns the unsigned angle [rad] between two directions of any length.
float angle_between(Vec2 a, Vec2 b) { return atan2(std::abs(cross(a, b)), dot(a, b)); }

/// Returns the angle [rad] that the widest gap in the goal spans as seen from the ball.
float opening(const View& view) {
  const Gap gap = widest_gap(view);
  if (gap.left <= gap.right || view.ball_in_team.x >= view.half_length) return 0;
  const Vec2 right = Vec2{view.half_length, gap.right} - view.ball_in_team;
  const Vec2 left = Vec2{view.half_length, gap.left} - view.ball_in_team;
  return angle_between(right, left);
}

float bearing(Vec2 in_robot) { return atan2(in_robot.y, in_robot.x); }

bool aligned(const View& view) {
  const motion::Model& model = *view.around.motion;
  if (view.mind.kick >= model.kick_count) return false;
  const motion::Kick& kick = model.kicks[view.mind.kick];
  return in_gate(kick, view.ball, true, 1) || in_gate(kick, view.ball, false, 1);
}

float kick_error(const View& view) {
  const motion::Model& model = *view.around.motion;
  Vec2 wanted = turned_back(direction(view.mind.kick_direction), view.facing);
  const float bend = view.mind.kick < model.kick_count ? model.kicks[view.mind.kick].direction : 0;
  if (bend != 0) wanted = turned_back(wanted, direction(static_cast<float>(view.mind.search_side) * bend));
  return atan2(std::abs(wanted.y), wanted.x);
}

float pass_gain(const View& view) {
  const PassTarget target = pass_target(view);
  return target.mate < 0 ? kUnknown : target.gain;
}

/// Returns the seconds from `then` to `now`, or NaN when `then` never was.
float seconds_since(Tick now, Tick then) {
  const float value = age(now, then);
  return value < kFar ? value : kUnknown;
}

bool is_set_play(const View& view) { return view.game.set_play != Game::SetPlay::none; }

constexpr const char* kRoleNames[] = {"keeper", "chaser", "supporter", "defender", nullptr};

// makers of rows
constexpr FeatureInfo number(const char* name, const char* unit, float least, float most, const char* about,
                             Compute compute) {
  return {compute, false, false, Kind::number, name, unit, least, most, nullptr, about};
}
constexpr FeatureInfo lateral(const char* name, const char* unit, float most, const char* about, Compute compute) {
  return {compute, false, true, Kind::number, name, unit, -most, most, nullptr, about};
}
constexpr FeatureInfo yes_no(const char* name, const char* about, Compute compute) {
  return {compute, false, false, Kind::yes_no, name, "", 0, 1, nullptr, about};
}
constexpr FeatureInfo one_of(const char* name, const char* const* names, float most, const char* about,
                             Compute compute) {
  return {compute, false, false, Kind::name, name, "", 0, most, names, about};
}
/// Makes a row whose value is unknown while the ball is.
constexpr FeatureInfo with_ball(FeatureInfo row) {
  row.needs_ball = true;
  return row;
}
/// Makes a row whose value is unknown at times, although the ball is known.
constexpr FeatureInfo at_times_unknown(FeatureInfo row) {
  row.at_times_unknown = true;
  return row;
}
/// Makes a row whose value never changes during a game.
constexpr FeatureInfo fixed(FeatureInfo row) {
  row.fixed = true;
  return row;
}

// the table of features: name, unit, range, text and function
constexpr FeatureInfo kTable[] = {
    // the ball
    yes_no("ball_known", "the own eyes or a teammate report where the ball is",
           [](const View& view) { return view.ball_known ? 1.f : 0.f; }),
    yes_no("ball_visible", "the newest image shows the ball",
           [](const View& view) { return view.beliefs.ball.visible ? 1.f : 0.f; }),
    number("ball_age", "s", 0, 1000, "time since the own eyes saw the ball",
           [](const View& view) { return age(view.now, view.beliefs.ball.seen); }),
    number("team_ball_age", "s", 0, 1000, "time since anybody of the team saw the ball",
           [](const View& view) { return age(view.now, view.ball_seen); }),
    number("ball_deviation", "m", 0, 30, "standard deviation of the own estimate along each axis",
           [](const View& view) { return std::sqrt(view.beliefs.ball.variance); }),
    with_ball(number("ball_distance", "m", 0, 30, "distance from the own feet",
                     [](const View& view) { return view.ball_distance; })),
    with_ball(lateral("ball_bearing", "rad", 3.15f, "direction of the ball, > 0 to the left",
                      [](const View& view) { return bearing(view.ball); })),
    with_ball(number("ball_ahead", "m", -30, 30, "distance in front of the feet",
                     [](const View& view) { return view.ball.x; })),
    with_ball(lateral("ball_left", "m", 30, "distance to the left of the feet",
                      [](const View& view) { return view.ball.y; })),
    with_ball(number("ball_speed", "m/s", 0, 10, "speed over ground",
                     [](const View& view) { return length(view.ball_velocity); })),
    with_ball(number("ball_x", "m", -15, 15, "x in team_field, > 0 in the opponents' half",
                     [](const View& view) { return view.ball_in_team.x; })),
    with_ball(lateral("ball_y", "m", 10, "y in team_field, > 0 left of the middle",
                      [](const View& view) { return view.ball_in_team.y; })),
    with_ball(number("ball_off_centre", "m", 0, 10, "distance from the long axis of the field",
                     [](const View& view) { return std::abs(view.ball_in_team.y); })),
    with_ball(
        yes_no("ball_in_own_half", "ball_x < 0", [](const View& view) { return view.ball_in_team.x < 0 ? 1.f : 0.f; })),
    with_ball(number("ball_goal_distance", "m", 0, 30, "distance from the middle of the opponents' goal",
                     [](const View& view) { return distance(view.ball_in_team, view.goal()); })),
    with_ball(number("ball_own_goal_distance", "m", 0, 30, "distance from the middle of the own goal",
                     [](const View& view) { return distance(view.ball_in_team, view.own_goal()); })),
    number("ball_heat", "", 0, 1, "how likely an opponent is to kick the ball soon",
           [](const View& view) { return view.beliefs.ball.heat; }),
    with_ball(
        number("ball_approach", "m/s", -10, 10, "speed towards the robot",
               [](const View& view) { return dot(view.ball_velocity, unit(view.position - view.ball_in_team)); })),
    with_ball(yes_no("ball_in_goal_soon", "the ball rolls towards the own goal and may get there",
                     [](const View& view) { return rolls_into_own_goal(view) ? 1.f : 0.f; })),
    at_times_unknown(with_ball(number("crossing_time", "s", 0, 60,
                                      "time until the rolling ball passes the line through both own feet",
                                      [](const View& view) { return crossing(view).time; }))),
    at_times_unknown(with_ball(lateral("crossing_left", "m", 10, "point where it passes that line, > 0 to the left",
                                       [](const View& view) { return crossing(view).left; }))),
    at_times_unknown(with_ball(number("crossing_off", "m", 0, 10, "distance from the feet at which it passes that line",
                                      [](const View& view) { return std::abs(crossing(view).left); }))),
    // the way to the goal
    lateral("goal_bearing", "rad", 3.15f, "direction of the opponents' goal, > 0 to the left",
            [](const View& view) { return bearing(view.to_robot(view.goal())); }),
    with_ball(number("goal_opening", "rad", 0, 3.15f,
                     "angle of the widest gap in the opponents' goal as seen from the ball", &opening)),
    with_ball(number("shot_clearance", "m", 0, 10,
                     "distance of the nearest opponent from the line between ball and goal",
                     [](const View& view) { return clearance(view, view.ball_in_team, view.goal()); })),
    with_ball(
        number("line_error", "rad", 0, 3.15f, "angle between the way to the ball and the way from the ball to the goal",
               [](const View& view) {
                 return angle_between(view.ball_in_team - view.position, view.goal() - view.ball_in_team);
               })),
    with_ball(yes_no("aligned", "the ball lies in the gate of the chosen kick",
                     [](const View& view) { return aligned(view) ? 1.f : 0.f; })),
    number("aligned_for", "decisions", 0, 255, "number of decisions in a row in which it did",
           [](const View& view) { return static_cast<float>(view.mind.aligned); }),
    number("kick_error", "rad", 0, 3.15f,
           "angle between the wanted direction of the ball and the one in which the kick would send it now",
           &kick_error),
    // the others
    with_ball(number("time_to_ball", "s", 0, 1000, "time until the robot stands behind the ball",
                     [](const View& view) { return view.mind.time_to_ball(); })),
    at_times_unknown(number("mates_time_to_ball", "s", 0, 1000,
                            "the same of the quickest teammate, from its last message", &quickest_mate)),
    number("mates_active", "robots", 0, 6, "number of teammates on the field that were heard recently", &count_mates),
    at_times_unknown(
        number("mate_distance", "m", 0, 30, "distance of the nearest teammate, from its last message", &nearest_mate)),
    number("opponents_known", "robots", 0, 7, "number of opponents seen in the last seconds", &count_opponents),
    at_times_unknown(number("opponent_distance", "m", 0, 30, "distance of the nearest opponent from the robot",
                            [](const View& view) { return nearest_opponent(view, view.position); })),
    at_times_unknown(
        with_ball(number("opponent_ball_distance", "m", 0, 30, "distance of the nearest opponent from the ball",
                         [](const View& view) { return nearest_opponent(view, view.ball_in_team); }))),
    at_times_unknown(with_ball(number(
        "pass_gain", "m", -30, 30, "how much nearer to the goal the best free teammate is than the ball", &pass_gain))),
    // the robot itself
    one_of("role", kRoleNames, 3, "keeper, chaser, supporter or defender",
           [](const View& view) { return static_cast<float>(view.mind.role); }),
    lateral("lane", "", 3, "place among the robots of the same role, 0 in the middle, > 0 to the left",
            [](const View& view) { return lane_of(view.mind); }),
    fixed(number("player", "", 1, 7, "the own number",
                 [](const View& view) { return static_cast<float>(view.game.player); })),
    number("x", "m", -15, 15, "own x in team_field", [](const View& view) { return view.position.x; }),
    lateral("y", "m", 10, "own y in team_field", [](const View& view) { return view.position.y; }),
    number("off_centre", "m", 0, 10, "own distance from the long axis of the field",
           [](const View& view) { return std::abs(view.position.y); }),
    lateral("heading", "rad", 3.15f, "own heading, 0 towards the opponents' goal",
            [](const View& view) { return view.beliefs.pose.pose.heading; }),
    number("pose_deviation", "m", 0, 15, "standard deviation of the own position along each axis",
           [](const View& view) { return view.beliefs.pose.deviation; }),
    number("own_goal_distance", "m", 0, 30, "own distance from the middle of the own goal",
           [](const View& view) { return distance(view.position, view.own_goal()); }),
    number("role_age", "s", 0, 1000, "time since the own role last changed",
           [](const View& view) { return seconds_since(view.now, view.mind.role_since); }),
    number("leaf_age", "s", 0, 1000, "time since the decision last reached another leaf",
           [](const View& view) { return seconds_since(view.now, view.mind.leaf_since); }),
    // the game
    yes_no("our_kick", "a kick-off or set play of the own team",
           [](const View& view) { return is_set_play(view) && view.game.own_kick ? 1.f : 0.f; }),
    yes_no("their_kick", "a kick-off or set play of the opponents",
           [](const View& view) { return is_set_play(view) && !view.game.own_kick ? 1.f : 0.f; }),
    one_of("set_play", kSetPlayWords, kSetPlays - 1, "none, kick_off, kick_in, goal_kick or corner_kick",
           [](const View& view) { return static_cast<float>(view.game.set_play); }),
    number("phase_age", "s", 0, 1000, "time since phase or set play last changed",
           [](const View& view) { return view.game.since_phase; }),
    number("seconds_left", "s", 0, 36000, "time left in the half",
           [](const View& view) { return view.game.remaining; }),
    number("half", "", 1, 4, "number of the half", [](const View& view) { return static_cast<float>(view.game.half); }),
    number(
        "score_difference", "goals", -100, 100, "own goals minus theirs",
        [](const View& view) { return static_cast<float>(int{view.game.own_score} - int{view.game.opponent_score}); }),
    fixed(number("players", "", 1, 7, "players on a side",
                 [](const View& view) { return static_cast<float>(view.game.players); })),
    fixed(number("field_length", "m", 0, 30, "between the goal lines",
                 [](const View& view) { return 2 * view.half_length; })),
};
constexpr int kBuiltIn = static_cast<int>(std::size(kTable));
static_assert(kBuiltIn + kMaxOwnFeatures <= kMaxFeatures);

}  // namespace

int built_in_feature_count() { return kBuiltIn; }

int feature_count() { return kBuiltIn + static_cast<int>(own_features().size()); }

const FeatureInfo& info_of(Feature feature) {
  const auto index = static_cast<std::size_t>(feature);
  return index < kBuiltIn ? kTable[index] : own_features()[index - kBuiltIn];
}

float compute(Feature feature, const View& view) {
  const FeatureInfo& row = info_of(feature);
  return row.needs_ball && !view.ball_known ? kUnknown : row.compute(view);
}

Feature find_feature(std::string_view name) {
  for (int i = 0; i < feature_count(); ++i)
    if (name == info_of(static_cast<Feature>(i)).name) return static_cast<Feature>(i);
  return kNoFeature;
}

bool rolls_into_own_goal(const View& view) {
  const Vec2 velocity = view.ball_velocity;
  const float to_line = view.ball_in_team.x + view.half_length;
  if (velocity.x > -kRolls || to_line <= 0) return false;
  const Vec2 way = (to_line / -velocity.x) * velocity;
  const float y = view.ball_in_team.y + way.y;
  if (std::abs(y) > 0.5f * view.around.rules->field.goal_width + kBeside) return false;
  return !std::isnan(rolling_time(length(velocity), kShort * length(way)));
}

Crossing crossing(const View& view) {
  const Vec2 velocity = turned_back(view.ball_velocity, view.facing);
  if (view.ball.x <= 0 || velocity.x > -kRolls) return {kUnknown, kUnknown};
  const float ratio = view.ball.x / -velocity.x;
  const Vec2 way = ratio * velocity;
  const float time = rolling_time(length(velocity), length(way));
  return std::isnan(time) ? Crossing{kUnknown, kUnknown} : Crossing{time, view.ball.y + way.y};
}

float clearance(const View& view, Vec2 from, Vec2 to) {
  const Vec2 way = unit(to - from);
  const float end = dot(to - from, way);
  float nearest = kFarthestClearance * kFarthestClearance;  // [m²]
  view.for_each_opponent([&](Vec2 opponent) {
    const Vec2 offset = opponent - from;
    const float along = clamp(dot(offset, way), 0, end);
    const float squared = squared_length(offset - along * way);
    if (squared < nearest) nearest = squared;
  });
  return std::sqrt(nearest);
}

Gap widest_gap(const View& view) {
  const float post = 0.5f * view.around.rules->field.goal_width - kBallRadius;
  const Vec2 ball = view.ball_in_team;

  // the part of the goal line that each opponent in front of the ball hides
  Gap hidden[kMaxPlayers];
  int count = 0;
  view.for_each_opponent([&](Vec2 opponent) {
    const float ahead = opponent.x - ball.x;
    if (ahead < kInFront || opponent.x > view.half_length + kBehindLine) return;
    const float scale = (view.half_length - ball.x) / ahead;
    const float y = ball.y + (opponent.y - ball.y) * scale;
    const float half = kShadow * scale;
    if (y - half < post && y + half > -post) hidden[count++] = {y - half, y + half};
  });
  if (count == 0) return {-post, post};

  // a gap begins at a post or where a shadow ends, and ends at the next shadow or post
  Gap best{0, 0};
  for (int i = -1; i < count; ++i) {
    const float right = i < 0 ? -post : hidden[i].left;
    float left = post;
    bool open = right < post;
    for (int k = 0; k < count && open; ++k) {
      if (k != i && hidden[k].right <= right && hidden[k].left > right) open = false;
      if (hidden[k].right > right && hidden[k].right < left) left = hidden[k].right;
    }
    if (!open) continue;
    // of equal gaps the one on the side of the ball, as in Mind.search_side
    const float wider = (left - right) - (best.left - best.right);
    if (wider > 0 || (wider == 0 && (left + right) * view.mind.search_side > 0)) best = {right, left};
  }
  return best;
}

PassTarget pass_target(const View& view) {
  PassTarget best;
  const float ball_to_goal = distance(view.ball_in_team, view.goal());
  view.for_each_mate([&](const Mate& mate, int index) {
    if (view.player_of_mate(index) == 1) return;
    const float gain = ball_to_goal - distance(mate.pose.position, view.goal());
    const float way = squared_length(mate.pose.position - view.ball_in_team);
    if (way < kShortestPass * kShortestPass || way > kLongestPass * kLongestPass) return;
    if (best.mate >= 0 && gain <= best.gain) return;
    if (clearance(view, view.ball_in_team, mate.pose.position) < kPassClearance) return;
    best = {index, gain};
  });
  return best;
}

bool in_gate(const motion::Kick& kick, Vec2 ball, bool left, float care) {
  const float y = left ? kick.ball_y : -kick.ball_y;
  return std::abs(ball.x - kick.ball_x) <= care * kick.gate_x && std::abs(ball.y - y) <= care * kick.gate_y;
}

}  // namespace sim::agent
