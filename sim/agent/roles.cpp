#include "sim/agent/roles.h"

namespace sim::agent {
namespace {

// [s/s] The estimate of a chaser falls by this much: the mean of 25,000 intervals of 3 s in games by spl2025. It turns,
// goes round others and falls on its way.
constexpr float kProgress = 0.5f;
// [s] Lead over a mate with a lower number that also says that it chases. Without it, each of the two could leave the ball
// to the other until the next message, which may be 7 s away.
constexpr float kSameClaim = 4;

/// A candidate for the roles.
struct Candidate {
  float time;  // [s] to the ball, minus the hysteresis of the chaser
  float x;     // [m, team_field]; minus order_keep of a defender
  float y;     // [m, team_field]
  int player;
};

/// Returns whether `a` comes before `b`. The number breaks ties, also in a mirrored game.
bool quicker(const Candidate& a, const Candidate& b) {
  return a.time < b.time || (a.time == b.time && a.player < b.player);
}
bool farther_back(const Candidate& a, const Candidate& b) {
  // without branches, which would be mispredicted
  return (a.x < b.x) | ((a.x == b.x) & (a.player < b.player));
}

Candidate candidate(const Roles& roles, Role role, float time, Vec2 position, int player) {
  return {.time = role == Role::chaser ? time - roles.hysteresis : time,
          .x = role == Role::defender ? position.x - roles.order_keep : position.x,
          .y = position.y,
          .player = player};
}

/// Returns the time to the ball [s] of a robot that faces `facing` and has the ball at `ball` [robot], `far` [m] away.
float time_for(const View& view, Vec2 ball, float far, Vec2 facing) {
  const motion::Walk& walk = view.around.motion->walk;
  const float distance = far > 0.01f ? far : 0.01f;
  const Vec2 to_ball = (1 / distance) * ball;
  const Vec2 goal_from_ball = unit(view.goal() - view.ball_in_team);
  const float wrong_side = 1 - dot(turned(to_ball, facing), goal_from_ball);
  return distance / walk.forward + 0.5f * kPi / walk.turn_rate * (1 - to_ball.x) + 0.4f / walk.sideward * wrong_side;
}

/// Returns the time [s] that a teammate needs now. A chaser has come nearer since its message. One that should have
/// reached the ball has fallen or lost it: the longer ago that is, the less it counts. A message from before the set play
/// tells of the ball's former place: its time is estimated from the mate's own place.
float time_of(const View& view, const Mate& mate, Role role) {
  if (mate.sent < view.ball_put && view.ball_known) {
    const SinCos heading = sin_cos(mate.pose.heading);
    const Vec2 facing{heading.cos, heading.sin}, to_ball = view.ball_in_team - mate.pose.position;
    return time_for(view, turned_back(to_ball, facing), length(to_ball), facing);
  }
  const float since = static_cast<float>(view.now - mate.sent) * kTickDuration;
  const float progress = role == Role::chaser ? kProgress * since : 0;
  return std::abs(mate.time_to_ball() - progress);
}

void set_role(Mind& mind, Role role, Tick now) {
  if (mind.role != role) mind.role_since = now;
  mind.role = role;
}

}  // namespace

const char* name_of(Role role) {
  static constexpr const char* kNames[kRoleCount] = {"keeper", "chaser", "supporter", "defender"};
  const auto index = static_cast<unsigned>(role);
  return index < kRoleCount ? kNames[index] : "unknown";
}

float time_to_ball(const View& view) { return time_for(view, view.ball, view.ball_distance, view.facing); }

void assign_role(const View& view, Mind& mind) {
  const Roles& roles = view.settings.roles;
  mind.settled = static_cast<std::uint8_t>(view.now);
  // rounded as the others hear it; otherwise they would not agree
  mind.time_to_ball_cs = centiseconds(view.ball_known ? time_to_ball(view) : 1e6f);
  if (view.game.player == 1) {
    set_role(mind, Role::keeper, view.now);
    mind.slot = kMiddleLane;
    return;
  }

  // all field players, this robot first
  Candidate all[kMaxPlayers];
  all[0] = candidate(roles, mind.role, mind.time_to_ball(), view.position, view.game.player);
  int count = 1, chaser = 0;
  view.for_each_mate([&](const Mate& mate, int index) {
    const int player = view.player_of_mate(index);
    if (player == 1) return;
    const auto role = static_cast<Role>(mate.role);
    const bool gives_way = role == Role::chaser && mind.role == Role::chaser && view.game.player < player;
    const float time = time_of(view, mate, role) + (gives_way ? kSameClaim : 0);
    all[count] = candidate(roles, role, time, mate.pose.position, player);
    if (quicker(all[count], all[chaser])) chaser = count;
    ++count;
  });

  // the quickest chases
  if (chaser == 0) {
    set_role(mind, Role::chaser, view.now);
    mind.slot = kMiddleLane;
    return;
  }

  // those farthest back defend
  all[chaser] = all[--count];
  const float share = roles.defenders * static_cast<float>(count);
  const int whole = static_cast<int>(share);
  const int defenders = share - static_cast<float>(whole) >= 0.5f ? whole + 1 : whole;
  bool defends[kMaxPlayers] = {};
  for (int i = 0; i < count; ++i) {
    int behind = 0;
    for (int k = 0; k < count; ++k) behind += farther_back(all[k], all[i]);
    defends[i] = behind < defenders;
  }
  set_role(mind, defends[0] ? Role::defender : Role::supporter, view.now);

  // lanes from right to left; level robots share one, so that a mirrored team has mirrored lanes
  int lane = kMiddleLane;
  for (int k = 1; k < count; ++k)
    if (defends[k] == defends[0]) lane += (all[k].y < all[0].y) - (all[k].y > all[0].y);
  mind.slot = static_cast<std::uint8_t>(lane);
}

}  // namespace sim::agent
