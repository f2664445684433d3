#include "sim/agent/features.h"

#include <iterator>
#include <limits>

#include "sim/agent/own.h"
#include "sim/agent/roles.h"

namespace sim::agent {
namespace {

using Kind = FeatureInfo::Kind;

constexpr const char* kRoleNames[] = {"keeper", "chaser", "supporter", "defender", nullptr};
constexpr const char* kSetPlayNames[] = {"none", "kick_off", "kick_in", "goal_kick", "corner_kick", nullptr};

constexpr FeatureInfo number(const char* name, const char* unit, float least, float most, const char* about) {
  return {name, Kind::number, unit, least, most, false, nullptr, about};
}
constexpr FeatureInfo lateral(const char* name, const char* unit, float most, const char* about) {
  return {name, Kind::number, unit, -most, most, true, nullptr, about};
}
constexpr FeatureInfo yes_no(const char* name, const char* about) {
  return {name, Kind::yes_no, "", 0, 1, false, nullptr, about};
}
constexpr FeatureInfo one_of(const char* name, const char* const* names, float most, const char* about) {
  return {name, Kind::name, "", 0, most, false, names, about};
}

// in the order of the enumeration
constexpr FeatureInfo kTable[] = {
    yes_no("ball_known", "own eyes or a teammate's report tell where the ball is"),
    yes_no("ball_visible", "the newest image shows it"),
    number("ball_age", "s", 0, 1000, "since the own eyes saw it"),
    number("team_ball_age", "s", 0, 1000, "since anybody of the team saw it"),
    number("ball_deviation", "m", 0, 30, "standard deviation of the own estimate along each axis"),
    number("ball_distance", "m", 0, 30, "from the own feet"),
    lateral("ball_bearing", "rad", 3.15f, "> 0: to the left"),
    number("ball_ahead", "m", -30, 30, "in front of the feet"),
    lateral("ball_left", "m", 30, "to the left of the feet"),
    number("ball_speed", "m/s", 0, 10, "over ground"),
    number("ball_x", "m", -15, 15, "in team_field: > 0 in the opponents' half"),
    lateral("ball_y", "m", 10, "in team_field: > 0 left of the middle"),
    number("ball_off_centre", "m", 0, 10, "from the long axis of the field"),
    yes_no("ball_in_own_half", "ball_x < 0"),
    number("ball_goal_distance", "m", 0, 30, "from the middle of the opponents' goal"),
    number("ball_own_goal_distance", "m", 0, 30, "from the middle of the own goal"),
    number("ball_heat", "", 0, 1, "how likely an opponent is to kick it soon"),
    number("ball_approach", "m/s", -10, 10, "speed towards oneself"),
    yes_no("ball_in_goal_soon", "it rolls towards the own goal and may get there"),
    number("crossing_time", "s", 0, 60, "until the rolling ball passes the line through both own feet"),
    lateral("crossing_left", "m", 10, "where it passes that line, > 0 to the left"),
    number("crossing_off", "m", 0, 10, "how far from the feet it passes that line"),
    lateral("goal_bearing", "rad", 3.15f, "of the opponents' goal, > 0: to the left"),
    number("goal_opening", "rad", 0, 3.15f, "the widest gap in the opponents' goal as seen from the ball"),
    number("shot_clearance", "m", 0, 10, "from the nearest opponent to the line between ball and goal"),
    number("line_error", "rad", 0, 3.15f, "between the way to the ball and the way from the ball to the goal"),
    yes_no("aligned", "the ball lies where the chosen kick wants it"),
    number("aligned_for", "decisions", 0, 255, "in a row in which it did"),
    number("kick_error", "rad", 0, 3.15f, "between the own heading and where the ball shall go"),
    number("time_to_ball", "s", 0, 1000, "until one stands behind it"),
    number("mates_time_to_ball", "s", 0, 1000, "of the quickest teammate, as last told"),
    number("mates_active", "robots", 0, 6, "teammates on the field heard of of late"),
    number("mate_distance", "m", 0, 30, "of the nearest teammate, as last told"),
    number("opponents_known", "robots", 0, 7, "seen in the last seconds"),
    number("opponent_distance", "m", 0, 30, "of the nearest one from oneself"),
    number("opponent_ball_distance", "m", 0, 30, "of the nearest one from the ball"),
    number("pass_gain", "m", -30, 30, "how much nearer to the goal the best free teammate is than the ball"),
    one_of("role", kRoleNames, 3, "keeper, chaser, supporter or defender"),
    {"lane", Kind::number, "", -3, 3, true, nullptr, "among those of the same role: 0 in the middle, > 0 to the left"},
    number("player", "", 1, 7, "the own number"),
    number("x", "m", -15, 15, "own, in team_field"),
    lateral("y", "m", 10, "own, in team_field"),
    number("off_centre", "m", 0, 10, "oneself from the long axis of the field"),
    lateral("heading", "rad", 3.15f, "own, 0 towards the opponents' goal"),
    number("pose_deviation", "m", 0, 15, "standard deviation of the own position along each axis"),
    number("own_goal_distance", "m", 0, 30, "from oneself to the middle of the own goal"),
    number("role_age", "s", 0, 1000, "since the own role last changed"),
    number("leaf_age", "s", 0, 1000, "since another leaf was decided for"),
    yes_no("our_kick", "a kick-off or set play of ours"),
    yes_no("their_kick", "a kick-off or set play of theirs"),
    one_of("set_play", kSetPlayNames, 4, "none, kick_off, kick_in, goal_kick or corner_kick"),
    number("phase_age", "s", 0, 1000, "since phase or set play last changed"),
    number("seconds_left", "s", 0, 36000, "of the half"),
    number("half", "", 1, 4, "which half it is"),
    number("score_difference", "goals", -100, 100, "own goals less theirs"),
    number("players", "", 1, 7, "a side"),
};
static_assert(std::size(kTable) == kFeatureCount);

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Where the ball passes the robot's own y axis, and when, turf slowing it by what is usual.
struct Crossing {
  float time = kUnknown;
  float left = kUnknown;
};
constexpr float kDeceleration = 0.3f;  // [m/s²] B-Human's ballSpecification.cfg

/// [s] until something of that speed has rolled so far; NaN when it stops before.
float rolling_time(float speed, float way) {
  const float left = speed * speed - 2 * kDeceleration * way;
  return left < 0 ? kUnknown : (speed - std::sqrt(left)) / kDeceleration;
}

Crossing crossing(const View& view) {
  const Vec2 velocity = turned_back(view.ball_velocity, view.facing);
  if (view.ball.x <= 0 || velocity.x > -0.05f) return {};
  const float ratio = view.ball.x / -velocity.x;
  const Vec2 way = ratio * velocity;
  const float time = rolling_time(length(velocity), length(way));
  return std::isnan(time) ? Crossing{} : Crossing{time, view.ball.y + way.y};
}

// a ball that is seen to roll beside the goal, or not quite so far, may still roll into it
constexpr float kBeside = 0.4f;  // [m] of a post
constexpr float kShort = 0.3f;   // of the way to the line: a fast ball seems slow at first

bool in_goal_soon(const View& view) {
  const Vec2 velocity = view.ball_velocity;
  const float to_line = view.ball_in_team.x + view.half_length;
  if (velocity.x > -0.05f || to_line <= 0) return false;
  const Vec2 way = (to_line / -velocity.x) * velocity;
  const float y = view.ball_in_team.y + way.y;
  if (std::abs(y) > 0.5f * view.around.field->goal_width + kBeside) return false;
  return !std::isnan(rolling_time(length(velocity), kShort * length(way)));
}

/// [m] from `from` to the nearest opponent; NaN when none is known.
float nearest_opponent(const View& view, Vec2 from) {
  float nearest = 1e6f;
  view.for_each_opponent([&](Vec2 opponent) {
    const float squared = squared_length(opponent - from);
    if (squared < nearest) nearest = squared;
  });
  return nearest < 1e6f ? std::sqrt(nearest) : kUnknown;
}

float nearest_mate(const View& view) {
  float nearest = 1e6f;
  view.for_each_mate([&](const Mate& mate, int) {
    const float squared = squared_length(mate.pose.position - view.position);
    if (squared < nearest) nearest = squared;
  });
  return nearest < 1e6f ? std::sqrt(nearest) : kUnknown;
}

/// [rad] without sign between two directions of any length.
float angle_between(Vec2 a, Vec2 b) { return atan2(std::abs(cross(a, b)), dot(a, b)); }

/// [rad] the angle under which the gap is seen from the ball.
float opening(const View& view) {
  const Gap gap = widest_gap(view);
  if (gap.left <= gap.right || view.ball_in_team.x >= view.half_length) return 0;
  const Vec2 right = Vec2{view.half_length, gap.right} - view.ball_in_team;
  const Vec2 left = Vec2{view.half_length, gap.left} - view.ball_in_team;
  return angle_between(right, left);
}

bool aligned(const View& view) {
  const motion::Model& model = *view.around.motion;
  if (view.mind.kick >= model.kick_count) return false;
  const motion::Kick& kick = model.kicks[view.mind.kick];
  return in_gate(kick, view.ball, true, 1) || in_gate(kick, view.ball, false, 1);
}

float quickest_mate(const View& view) {
  float quickest = kUnknown;
  view.for_each_mate([&](const Mate& mate, int index) {
    if (view.player_of_mate(index) == 1) return;
    if (!(quickest <= mate.time_to_ball())) quickest = mate.time_to_ball();
  });
  return quickest;
}

float seconds_since(Tick now, Tick then) {
  const float value = age(now, then);
  return value < 1e6f ? value : kUnknown;
}

/// What is about the ball, where it is known.
float ball_value(Feature feature, const View& view) {
  switch (feature) {
    case Feature::ball_distance: return view.ball_distance;
    case Feature::ball_bearing: return atan2(view.ball.y, view.ball.x);
    case Feature::ball_ahead: return view.ball.x;
    case Feature::ball_left: return view.ball.y;
    case Feature::ball_speed: return length(view.ball_velocity);
    case Feature::ball_x: return view.ball_in_team.x;
    case Feature::ball_y: return view.ball_in_team.y;
    case Feature::ball_off_centre: return std::abs(view.ball_in_team.y);
    case Feature::ball_in_own_half: return view.ball_in_team.x < 0 ? 1 : 0;
    case Feature::ball_goal_distance: return distance(view.ball_in_team, view.goal());
    case Feature::ball_own_goal_distance: return distance(view.ball_in_team, view.own_goal());
    case Feature::ball_approach: return dot(view.ball_velocity, unit(view.position - view.ball_in_team));
    case Feature::ball_in_goal_soon: return in_goal_soon(view) ? 1 : 0;
    case Feature::crossing_time: return crossing(view).time;
    case Feature::crossing_left: return crossing(view).left;
    case Feature::crossing_off: return std::abs(crossing(view).left);
    case Feature::goal_opening: return opening(view);
    case Feature::shot_clearance: return clearance(view, view.ball_in_team, view.goal());
    case Feature::line_error: return angle_between(view.ball_in_team - view.position, view.goal() - view.ball_in_team);
    case Feature::aligned: return aligned(view) ? 1 : 0;
    case Feature::time_to_ball: return view.mind.time_to_ball;
    case Feature::opponent_ball_distance: return nearest_opponent(view, view.ball_in_team);
    case Feature::pass_gain: return pass_mate(view) < 0 ? kUnknown : view.pass_gain;
    default: return kUnknown;
  }
}

const OwnFeature& own(Feature feature) { return own_features()[static_cast<std::size_t>(feature) - kFeatureCount]; }

}  // namespace

int feature_count() { return kFeatureCount + static_cast<int>(own_features().size()); }

const FeatureInfo& info_of(Feature feature) {
  return feature < Feature::count ? kTable[static_cast<int>(feature)] : own(feature).info;
}

float compute(Feature feature, const View& view) {
  const bool kick_on = view.game.set_play != Game::SetPlay::none;
  switch (feature) {
    case Feature::ball_known: return view.ball_known ? 1 : 0;
    case Feature::ball_visible: return view.beliefs.ball.visible ? 1 : 0;
    case Feature::ball_age: return age(view.now, view.beliefs.ball.seen);
    case Feature::team_ball_age: return age(view.now, view.ball_seen);
    case Feature::ball_deviation: return std::sqrt(view.beliefs.ball.variance);
    case Feature::ball_heat: return view.beliefs.ball.heat;
    case Feature::goal_bearing: {
      const Vec2 goal = view.to_robot(view.goal());
      return atan2(goal.y, goal.x);
    }
    case Feature::aligned_for: return static_cast<float>(view.mind.aligned);
    case Feature::kick_error: {
      const Vec2 wanted = turned_back(direction(view.mind.kick_direction), view.facing);
      return atan2(std::abs(wanted.y), wanted.x);
    }
    case Feature::mates_time_to_ball: return quickest_mate(view);
    case Feature::mates_active: {
      float count = 0;
      view.for_each_mate([&](const Mate&, int) { count += 1; });
      return count;
    }
    case Feature::mate_distance: return nearest_mate(view);
    case Feature::opponents_known: {
      float count = 0;
      view.for_each_opponent([&](Vec2) { count += 1; });
      return count;
    }
    case Feature::opponent_distance: return nearest_opponent(view, view.position);
    case Feature::role: return static_cast<float>(view.mind.role);
    case Feature::lane: return lane_of(view.mind);
    case Feature::player: return static_cast<float>(view.game.player);
    case Feature::x: return view.position.x;
    case Feature::y: return view.position.y;
    case Feature::off_centre: return std::abs(view.position.y);
    case Feature::heading: return view.beliefs.pose.pose.heading;
    case Feature::pose_deviation: return view.beliefs.pose.deviation;
    case Feature::own_goal_distance: return distance(view.position, view.own_goal());
    case Feature::role_age: return seconds_since(view.now, view.mind.role_since);
    case Feature::leaf_age: return seconds_since(view.now, view.mind.leaf_since);
    case Feature::our_kick: return kick_on && view.game.own_kick ? 1 : 0;
    case Feature::their_kick: return kick_on && !view.game.own_kick ? 1 : 0;
    case Feature::set_play: return static_cast<float>(view.game.set_play);
    case Feature::phase_age: return view.game.since_phase;
    case Feature::seconds_left: return view.game.remaining;
    case Feature::half: return static_cast<float>(view.game.half);
    case Feature::score_difference: return static_cast<float>(int{view.game.own_score} - int{view.game.opponent_score});
    case Feature::players: return static_cast<float>(view.game.players);
    default:
      if (feature >= Feature::count) return own(feature).value(view);
      return view.ball_known ? ball_value(feature, view) : kUnknown;
  }
}

Feature find_feature(std::string_view name) {
  for (int i = 0; i < feature_count(); ++i)
    if (name == info_of(static_cast<Feature>(i)).name) return static_cast<Feature>(i);
  return kNoFeature;
}

float clearance(const View& view, Vec2 from, Vec2 to) {
  const Vec2 way = unit(to - from);
  const float end = dot(to - from, way);
  float nearest = 100;  // [m²]
  view.for_each_opponent([&](Vec2 opponent) {
    const Vec2 offset = opponent - from;
    const float along = clamp(dot(offset, way), 0, end);
    const float squared = squared_length(offset - along * way);
    if (squared < nearest) nearest = squared;
  });
  return std::sqrt(nearest);
}

Gap widest_gap(const View& view) {
  constexpr float kShadow = 0.25f;  // [m] half of what a robot and the ball's own width take away
  const float post = 0.5f * view.around.field->goal_width - 0.1f;
  const Vec2 ball = view.ball_in_team;

  // what each opponent in front of the ball hides of the goal line
  Gap hidden[kMaxPlayers];
  int count = 0;
  view.for_each_opponent([&](Vec2 opponent) {
    const float ahead = opponent.x - ball.x;
    if (ahead < 0.05f || opponent.x > view.half_length + 0.1f) return;
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
    // equal gaps: the one on the side that the robot has to do with anyway
    const float wider = (left - right) - (best.left - best.right);
    if (wider > 0 || (wider == 0 && (left + right) * view.mind.search_side > 0)) best = {right, left};
  }
  return best;
}

int pass_mate(const View& view) {
  if (view.pass_mate != -2) return view.pass_mate;
  view.pass_mate = -1;
  const float ball_to_goal = distance(view.ball_in_team, view.goal());
  view.for_each_mate([&](const Mate& mate, int index) {
    if (view.player_of_mate(index) == 1) return;
    const float gain = ball_to_goal - distance(mate.pose.position, view.goal());
    const float way = squared_length(mate.pose.position - view.ball_in_team);
    if (way < 0.8f * 0.8f || way > 4.5f * 4.5f) return;
    if (view.pass_mate >= 0 && gain <= view.pass_gain) return;
    if (clearance(view, view.ball_in_team, mate.pose.position) < 0.4f) return;
    view.pass_mate = index, view.pass_gain = gain;
  });
  return view.pass_mate;
}

bool in_gate(const motion::Kick& kick, Vec2 ball, bool left, float care) {
  const float y = left ? kick.ball_y : -kick.ball_y;
  return std::abs(ball.x - kick.ball_x) <= care * kick.gate_x && std::abs(ball.y - y) <= care * kick.gate_y;
}

}  // namespace sim::agent
