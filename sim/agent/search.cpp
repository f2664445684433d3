#include "sim/agent/search.h"

#include "sim/agent/head.h"
#include "sim/agent/roles.h"
#include "sim/agent/walk.h"

namespace sim::agent {
namespace {

constexpr float kScanAngle = 1.3f;  // [rad] HULKs look_around
constexpr float kTurnScan = 0.5f;   // [rad] of the head while the body turns
constexpr Tick kScanning = 66;      // [ticks] with the head alone
constexpr Tick kTurning = 150;      // then turning
constexpr Tick kWalking = 240;      // then walking, then from the beginning

/// Returns the place to walk to [m, team_field]: the own part of the field, alternate sides.
Vec2 patrol(const View& view, Tick round) {
  const float side = round % 2 == 0 ? view.mind.search_side : -view.mind.search_side;
  const float y = 0.35f * side * view.half_width;
  switch (view.mind.role) {
    case Role::keeper: return {-0.9f * view.half_length, 0};
    case Role::defender: return {-0.45f * view.half_length, y};
    case Role::supporter: return {0.3f * view.half_length, y};
    case Role::chaser: break;
  }
  return {0, 0.5f * y};
}

}  // namespace

motion::Command search_ball(const View& view, Mind& mind, const SearchBall& with) {
  const float gain = with.gain;
  if (mind.search_since == kNever) mind.search_since = view.now;
  motion::Command command;

  // a teammate sees the ball: look there, and go near enough to see it
  const Tick own = view.beliefs.ball.seen;
  if (view.ball_known && (own == kNever || view.ball_seen > own)) {
    const Vec2 way = unit(view.ball);
    const float near = view.ball_distance - 1.2f;
    command = near > 0 ? walk_in_robot(view, near * way, angle_of(way), gain) : turn_to(view, way);
    keep_eye_on_ball(view, command);
    return command;
  }

  const Tick searched = view.now - mind.search_since;
  const Tick round = searched / (kScanning + kTurning + kWalking);
  const Tick time = searched % (kScanning + kTurning + kWalking);
  if (time < kScanning || mind.role == Role::keeper) {
    scan(view, command, kScanAngle);
    return command;
  }
  if (time < kScanning + kTurning) {
    command.body = motion::Command::Body::walk_speed;
    command.turn = mind.search_side * 0.8f * gain * view.around.motion->walk.turn_rate;
    scan(view, command, kTurnScan);
    return command;
  }
  command = walk_to_place(view, patrol(view, round), {1, 0}, gain);
  scan(view, command, kScanAngle);
  return command;
}

}  // namespace sim::agent
