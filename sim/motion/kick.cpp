#include "sim/motion/kick.h"

#include <algorithm>
#include <cmath>

namespace sim::motion {
namespace {

/// Returns the quality of a kick by the place of the ball: 1 inside the gate, falling to
/// 0 at twice its size, < 0 beyond.
float quality_at(const Kick& kick, Vec2 ball, float side) {
  const float off_x = std::abs(ball.x - kick.ball_x) / kick.gate_x;
  const float off_y = std::abs(side * ball.y - kick.ball_y) / kick.gate_y;
  return std::min(1.f, 2 - std::max(off_x, off_y));
}

bool within_reach(Vec2 ball) { return ball.x > 0 && squared_length(ball) <= kReach * kReach; }

// Estimates: at the edge of the foot's reach a kick has half its range and three times its deviation.
float range_at(float quality) { return 0.5f + 0.5f * quality; }
float spread_at(float quality) { return 3 - 2 * quality; }

/// Returns the velocity of the kicked ball [m/s, field].
Vec2 ball_velocity(const MotionParams& params, const Kick& kick, float quality, int robot, Tick now,
                   const World& world) {
  const Body& body = world.bodies[robot];
  float range = kick.range * body.kick_gain * range_at(quality);
  float angle = kick.direction;
  float share = 1, spread = spread_at(quality);
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::kick_noise, now);
  const Hits& hits = params.model.hits;
  if (params.effects.partial_hits && uniform(words[2]) < hits.partial) {
    share = uniform(words[3]);
    spread *= hits.spread - (hits.spread - 1) * share;
  }
  if (params.effects.kick_noise) {
    const auto deviates = normals(words[0], words[1]);
    range *= std::max(0.f, 1 + spread_at(quality) * kick.range_deviation * deviates[0]);
    angle += spread * kick.direction_deviation * deviates[1];
  }
  if (!body.kick_left) angle = -angle;
  return share * speed_for_range(range, params.ball.deceleration) * turned(direction(angle), body.facing);
}

/// Lets the foot pass the place of the ball, in the tick `now`: a hit or a whiff.
void strike(const MotionParams& params, const Kick& kick, int robot, Tick now, World& world) {
  const Body& body = world.bodies[robot];
  const Vec2 ball = turned_back(world.ball.position - body.position, body.facing);
  float quality = quality_at(kick, ball, body.kick_left ? 1.f : -1.f);
  if (!params.effects.kick_whiff && (quality >= 0 || within_reach(ball))) quality = 1;
  if (quality < 0) {
    if (world.whiffed == kNobody || is_named_before(world, robot, world.whiffed))
      world.whiffed = static_cast<std::uint8_t>(robot);
    return;
  }

  // two hits in the same tick add up, so that the order of robots does not matter
  const Vec2 velocity = ball_velocity(params, kick, quality, robot, now, world);
  const bool first = world.kicked == kNobody;
  const float harder = squared_length(velocity) - squared_length(world.ball.velocity);
  if (first || harder > 0 || (harder == 0 && is_named_before(world, robot, world.kicked))) {
    world.kicked = static_cast<std::uint8_t>(robot);
    world.touched = world.kicked;
  }
  world.ball.velocity = first ? velocity : world.ball.velocity + velocity;
}

}  // namespace

int find_kick(const Model& model, std::string_view name) {
  for (int kick = 0; kick < model.kick_count; ++kick) {
    if (model.kicks[kick].name == name) return kick;
  }
  return -1;
}

void begin_kick(const Command& command, Tick now, Body& body) {
  body.doing = Body::Doing::kicking;
  body.since = now;
  body.velocity = {};
  body.turn_rate = 0;
  body.kind = command.kick;
  body.kick_left = command.kick_left;
  body.kick_gain = std::clamp(command.gain, 0.f, 1.f);
  body.kick_done = false;
}

Tick kick(const MotionParams& params, int robot, Tick now, Tick left, World& world) {
  Body& body = world.bodies[robot];
  const Kick& kick = params.model.kicks[body.kind];

  // a kick takes at least one tick, and the foot passes within its duration
  const Tick end = std::max<Tick>(1, ticks(kick.duration));
  const Tick impact = std::min(ticks(kick.delay), end - 1);
  const Tick elapsed = std::min(now - body.since, end - 1);
  const Tick used = std::min(left, end - elapsed);

  if (!body.kick_done && elapsed + used > impact) {
    strike(params, kick, robot, body.since + impact, world);
    body.kick_done = true;
  }
  // `stopping` lets the body walk on without a start delay
  if (elapsed + used == end) {
    body.doing = Body::Doing::stopping;
    body.since = now + used;
  }
  return used;
}

}  // namespace sim::motion
