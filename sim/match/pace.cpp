#include "sim/match/pace.h"

namespace sim {
namespace {

constexpr Tick kOutOfPlay = 5;  // [ticks] between turns before the ball is in play
constexpr Tick kFar = 3;        // and where a robot cannot matter

constexpr float kNear = 1.2f;       // [m] from the ball's path: more than a robot walks in the time it rolls there
constexpr float kForesight = 1;     // [s] of the ball's path that is looked at
constexpr float kTouching = 0.25f;  // [m] beyond two radii: what two robots may cover towards each other, and more

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

/// Ticks until it is the player's turn among those who have one every `period` ticks.
Tick to_turn(Tick period, Tick now, int robot) { return period - (now + static_cast<Tick>(player_of(robot))) % period; }

}  // namespace

Tick ticks_to_next_turn(const Params& params, const State& state, int robot) {
  if (params.pace == Pace::every_tick) return 1;

  const World& world = state.world;
  const Body& body = world.bodies[robot];
  if (may_touch_somebody(world, params.teams[0].models.contact.robot_radius, robot)) return 1;
  if (state.book.phase != agent::Game::Phase::playing) return to_turn(kOutOfPlay, world.tick, robot);

  const Robot& self = state.robots[robot];
  if (body.doing == Body::Doing::kicking || self.command.body == motion::Command::Body::kick) return 1;
  if (self.mind.role == agent::Role::chaser) return 1;
  if (squared_distance_from_path(world.ball, body.position) < kNear * kNear) return 1;
  return to_turn(kFar, world.tick, robot);
}

}  // namespace sim
