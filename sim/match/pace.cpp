#include "sim/match/pace.h"

#include <algorithm>

namespace sim {
namespace {

using Phase = agent::Game::Phase;

/// [ticks] between turns by how far a robot is from the ball's path [m]: next to it, near, in sight of it, far. Each
/// is a small part of the time that it takes to get there.
struct Ring {
  float within;
  Tick ticks;
};
constexpr Ring kRings[] = {{0.6f, 1}, {0.8f, 2}, {1.2f, 3}};
constexpr Tick kFar = 6;
constexpr Tick kChasing = 3;    // at most, of whoever goes for the ball
constexpr Tick kOutOfPlay = 6;  // while everybody goes to his place
constexpr Tick kSet = 15;       // while everybody has to stand

constexpr float kForesight = 1;    // [s] of the ball's path that is looked at
constexpr float kTouching = 0.1f;  // [m] beyond two radii: what two robots cover towards each other in 6 ticks

/// Squared distance of `point` from the way the ball rolls in the next kForesight seconds, braking left aside.
float squared_distance_from_path(const Ball& ball, Vec2 point) {
  const Vec2 way = kForesight * ball.velocity;
  const Vec2 to_point = point - ball.position;
  const float along = dot(to_point, way);
  const float whole = squared_length(way);
  if (along <= 0) return squared_length(to_point);
  if (along >= whole) return squared_length(to_point - way);
  const float across = cross(way, to_point);
  return across * across / whole;
}

bool may_touch_somebody(const World& world, float radius, int robot) {
  const float reach = 2 * radius + kTouching;
  bool near = false;
  for_each_robot(world.players, [&](int other) {
    const Body& body = world.bodies[other];
    near |= other != robot && body.doing != Body::Doing::removed &&
            squared_length(body.position - world.bodies[robot].position) < reach * reach;
  });
  return near;
}

/// How often while the ball is in play.
Tick period_in_play(const World& world, const Robot& self, int robot) {
  const Body& body = world.bodies[robot];
  const bool begins_kick = self.command.body == motion::Command::Body::kick && body.doing != Body::Doing::kicking;
  if (begins_kick || (body.doing == Body::Doing::kicking && !body.kick_done)) return 1;

  const Tick most = self.mind.role == agent::Role::chaser ? kChasing : kFar;
  const float squared = squared_distance_from_path(world.ball, body.position);
  for (const Ring& ring : kRings)
    if (squared < ring.within * ring.within) return std::min(ring.ticks, most);
  return most;
}

/// How often it has a turn, contacts left aside.
Tick period_of(const State& state, int robot) {
  switch (state.book.phase) {
    case Phase::playing: return period_in_play(state.world, state.robots[robot], robot);
    case Phase::set: return kSet;
    default: return kOutOfPlay;
  }
}

}  // namespace

Tick ticks_to_next_turn(const Params& params, const State& state, int robot) {
  if (params.pace == Pace::every_tick) return 1;
  const World& world = state.world;
  const Tick period = period_of(state, robot);
  if (period == 1 || may_touch_somebody(world, params.teams[0].models.contact.robot_radius, robot)) return 1;

  // the next tick that is its number's; when set is over, everybody's
  Tick wait = period - (world.tick + static_cast<Tick>(player_of(robot))) % period;
  if (state.book.phase == Phase::set) {
    const Tick over = state.book.phase_since + ticks(params.rules.set_duration) + 1;
    if (over > world.tick) wait = std::min(wait, over - world.tick);
  }
  return wait;
}

}  // namespace sim
