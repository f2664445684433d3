#include "sim/match/pace.h"

#include <algorithm>
#include <span>

#include "sim/motion/rhythm.h"

namespace sim {
namespace {

using Phase = agent::Game::Phase;
using Doing = Body::Doing;

/// The waiting time of robots within a distance: between two turns, and between two pieces of a walking body's move.
struct Ring {
  float within;  // [m]
  Tick ticks;
};
/// By the distance to the ball's path. Each time is a small part of the time needed to reach the ball; next to the ball
/// it is less than half a walking step.
constexpr Ring kToBall[] = {{0.35f, 2}, {0.6f, 4}, {0.8f, 6}, {1.2f, 9}};
/// By the gap to the nearest other robot: two that walk towards each other cover 0.5 m in a second.
constexpr Ring kToRobot[] = {{0.1f, 4}, {0.2f, 9}};
constexpr Tick kFar = 18;      // [ticks] beyond all rings
constexpr Tick kFarSteps = 2;  // [walking steps] between turns of a walking robot beyond all rings
constexpr Tick kHalfStep = 4;  // [ticks] least time between turns of a walking robot: its legs wait for the next step
constexpr Tick kStanding = 2;  // [ticks] between turns of a standing robot within the rings: it may have to block
constexpr Tick kChasing = 9;   // [ticks] longest time between turns of the chaser
constexpr Tick kSet = 15;      // [ticks] between turns in SET, where all robots stand

constexpr float kForesight = 1;  // [s] length of the ball's path that counts

/// Returns the time of the innermost ring that contains this distance, or kFar.
Tick ticks_at(float squared_distance, std::span<const Ring> rings, float radius) {
  for (const Ring& ring : rings)
    if (squared_distance < (radius + ring.within) * (radius + ring.within)) return ring.ticks;
  return kFar;
}

/// Returns the squared distance [m²] of `point` from the ball's path in the next kForesight seconds, without friction.
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

/// Returns the squared distance [m²] of the nearest other robot.
float squared_distance_from_robots(const World& world, int robot) {
  const Vec2 own = world.bodies[robot].position;
  float nearest = 1e6f;
  for_each_robot(world.players, [&](int other) {
    const float squared = squared_length(world.bodies[other].position - own);
    // removed robots count too: they wait beside the field, far enough away
    if (other != robot) nearest = std::min(nearest, squared);
  });
  return nearest;
}

/// Returns the time until the foot passes the place of the ball [ticks], at least 1, or 0 for a robot without a kick.
Tick until_impact(const motion::Model& model, const World& world, const Robot& self, int robot) {
  const Body& body = world.bodies[robot];
  const bool kicks = body.doing == Doing::kicking;
  if (body.doing > Doing::kicking) return 0;
  if (kicks ? body.kick_done : self.command.body != motion::Command::Body::kick) return 0;
  const Tick impact = ticks(model.kicks[kicks ? body.kind : self.command.kick].delay);
  const Tick elapsed = kicks ? world.tick - body.since : 0;
  return elapsed < impact ? impact - elapsed : 1;
}

/// Returns the waiting time that follows from the distance to the ball [ticks].
Tick until_ball(const State& state, int robot) {
  if (state.book.phase != Phase::playing) return kFar;
  const World& world = state.world;
  const Tick ball = ticks_at(squared_distance_from_path(world.ball, world.bodies[robot].position), kToBall, 0);
  return state.robots[robot].mind.role == agent::Role::chaser ? std::min(ball, kChasing) : ball;
}

/// Returns the waiting time that follows from the distance to other robots [ticks], at most `most`.
Tick until_robots(const Params& params, const World& world, int robot, Tick most) {
  if (most <= kToRobot[0].ticks) return most;
  const float touch = 2 * params.teams[0].models.contact.robot_radius;
  return std::min(most, ticks_at(squared_distance_from_robots(world, robot), kToRobot, touch));
}

Tick next_multiple(Tick now, Tick period) { return period - now % period; }

/// Returns the time to the start of the next walking step whose number is a multiple of `steps` [ticks].
Tick next_step(const motion::Rhythm& rhythm, Tick now, Tick steps) {
  Tick wait = rhythm.until_next(now);
  while (rhythm.step_at(now + wait) % steps != 0) wait += rhythm.until_next(now + wait);
  return wait;
}

}  // namespace

Wait wait_of(const Params& params, const State& state, int robot) {
  if (params.pace == Pace::every_tick) return {1, 1};
  const World& world = state.world;
  const Body& body = world.bodies[robot];
  const motion::Command& command = state.robots[robot].command;
  const motion::Model& motion = models_of(params, robot).motion;
  const motion::Rhythm rhythm(motion.walk);
  const auto at_once = [](Tick ticks) { return Wait{ticks, ticks}; };

  // a kick: wait for the contact
  const bool waits = motion::in_step(rhythm, body, world.tick);
  if (!waits)
    if (const Tick impact = until_impact(motion, world, state.robots[robot], robot); impact > 0) return at_once(impact);

  // SET: all robots stand until one tick after the whistle
  if (state.book.phase == Phase::set) {
    const Tick over = state.book.phase_since + ticks(params.rules.set_duration) + 1;
    const Tick wait = next_multiple(world.tick, kSet);
    return at_once(over > world.tick ? std::min(wait, over - world.tick) : wait);
  }

  // a walking robot, then all others
  const Tick ball = until_ball(state, robot);
  if (motion::in_step(body)) {
    const Tick steps = next_step(rhythm, world.tick, waits || ball < kFar ? 1 : kFarSteps);
    const Tick turn = std::min(steps, std::max(ball, kHalfStep));
    return {turn, until_robots(params, world, robot, std::min(turn, ball))};
  }
  const bool stands = body.doing == Doing::standing, rests = stands && command.body == motion::Command::Body::stand;
  const Tick turn = stands && ball < kFar ? kStanding : ball;
  return at_once(next_multiple(world.tick, rests ? turn : until_robots(params, world, robot, turn)));
}

World between_turns(const State& state) {
  World world = state.world;
  for_each_robot(world.players, [&](int robot) {
    const Tick turn = state.schedule.turn[robot];
    if (turn == kNever || turn <= world.tick) return;
    Body& body = world.bodies[robot];
    const Pose2& from = state.robots[robot].cognition.last;
    const Tick left = until_move(body, world.tick);
    const Tick rested = world.tick - (turn - state.schedule.lag[robot]);
    const float ahead = static_cast<float>(left) / static_cast<float>(left + rested);
    body.position -= ahead * (body.position - from.position);
    body.heading = normalized(body.heading - ahead * normalized(body.heading - from.heading));
    body.facing = direction(body.heading);
  });
  return world;
}

}  // namespace sim
