#include "sim/motion/walk.h"

#include <algorithm>
#include <cmath>

namespace sim::motion {
namespace {

// what the body aims at while it walks: velocity [m/s, robot] and turn rate [rad/s]
struct Gait {
  Vec2 velocity;
  float turn_rate = 0;
};

constexpr float kCruising = 0.5f;        // [m] farther from a destination than this ...
constexpr Tick kCruisingTicks = 4;       // ... so many ticks are walked at once
constexpr float kTriangular = 2.44949f;  // √6: standard deviation 1 for the sum of two uniform numbers

bool wants_to_walk(const Command& command, const Errand& errand) {
  switch (command.body) {
    case Command::Body::walk_speed: return errand.walk.x != 0 || errand.walk.y != 0 || errand.turn != 0;
    case Command::Body::walk_to:
      return squared_length(errand.walk) > kArrived * kArrived || std::abs(errand.turn) > kArrivedTurn;
    default: return false;
  }
}

// the nearest gait the body is capable of: an ellipse of velocities, smaller while turning; `share` of the top speeds
Gait within_limits(const Walk& walk, bool turning_costs, float share, Gait gait) {
  const float top_turn = share * walk.turn_rate;
  gait.turn_rate = std::clamp(gait.turn_rate, -top_turn, top_turn);
  if (turning_costs) share *= 1 - walk.turn_cost * std::abs(gait.turn_rate) / walk.turn_rate;

  // (x / reach)² + (y / sideward)² <= share², multiplied out
  const float reach = gait.velocity.x >= 0 ? walk.forward : walk.backward;
  const float squared = squared_length({gait.velocity.x * walk.sideward, gait.velocity.y * reach});
  const float most = share * reach * walk.sideward;
  if (squared > most * most) gait.velocity = (most / std::sqrt(squared)) * gait.velocity;
  return gait;
}

// the speed from which `brake` still stops within `left`, and that does not lead beyond it within 1 / `rate` [s]; at most
// `most`
float slowing(float left, float most, float brake, float rate) {
  most = std::min(most, left * rate);
  const float squared = 2 * brake * left;
  return squared < most * most ? std::sqrt(squared) : most;
}

// towards a destination: far away it faces where it goes, near it faces as it shall on arrival
Gait towards(const Walk& walk, bool limited, float gain, const Errand& errand, float rate) {
  const float distance = length(errand.walk);
  const bool far = distance > kNear;
  const Vec2 ahead = distance > 0 ? 1 / distance * errand.walk : Vec2{};

  // the sine will do for the angle: wherever they differ much the body turns as fast as it can
  const float angle = !far ? errand.turn : ahead.x > 0 ? ahead.y : std::copysign(1.f, ahead.y);
  const float turn_brake = limited ? kBrakes * walk.turn_acceleration : 1e6f;
  const float turn = slowing(std::abs(angle), walk.turn_rate, turn_brake, rate);

  const float fastest = std::max({walk.forward, walk.backward, walk.sideward});
  const float speed = slowing(distance, fastest, limited ? brake_of(walk) : 1e6f, rate);
  Gait gait = within_limits(walk, limited, gain, {speed * ahead, std::copysign(turn, angle)});

  // a destination behind it is first turned to
  if (far) gait.velocity = std::max(0.f, ahead.x) * gait.velocity;
  return gait;
}

// index of the walk step that `tick` is in
Tick step_at(const Walk& walk, Tick tick) {
  return static_cast<Tick>(static_cast<float>(tick) * (kTickDuration / walk.step_duration));
}

// triangular in [-√6, √6): standard deviation 1, and cheap
float deviate(std::uint32_t word) {
  return kTriangular * (static_cast<float>((word & 0xffff) + (word >> 16)) * 0x1p-16f - 1);
}

void draw_noise(const Walk& walk, const World& world, int robot, Tick step, Body& body) {
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Event::walk_noise, step);
  body.noise.x = std::max(0.f, 1 + walk.speed_noise * deviate(words[0]));
  body.noise.y = std::max(0.f, 1 + walk.speed_noise * deviate(words[1]));
  body.turn_noise = walk.turn_noise * deviate(words[2]);
}

// leads `velocity` to `wanted` with at most `acceleration` and returns its mean over `dt`
Vec2 approach(Vec2& velocity, Vec2 wanted, float acceleration, float dt) {
  if (velocity == wanted) return wanted;
  const Vec2 before = velocity;
  const Vec2 change = wanted - before;
  const float size = length(change);
  const float most = acceleration * dt;
  if (size > most) {
    velocity = before + most / size * change;
    return 0.5f * (before + velocity);
  }
  velocity = wanted;
  return wanted - 0.5f * size / most * change;
}

float approach(float& rate, float wanted, float acceleration, float dt) {
  const float before = rate;
  const float change = wanted - before;
  const float most = acceleration * dt;
  if (std::abs(change) > most) {
    rate = before + std::copysign(most, change);
    return 0.5f * (before + rate);
  }
  rate = wanted;
  return wanted - 0.5f * std::abs(change) / most * change;
}

// moves the body for `dt` towards the gait; returns the displacement [m, field]
Vec2 advance(const Walk& walk, bool limited, const Gait& gait, float dt, Body& body) {
  Vec2 velocity = gait.velocity;
  float rate = gait.turn_rate;
  if (limited) {
    velocity = approach(body.velocity, gait.velocity, walk.acceleration, dt);
    rate = approach(body.turn_rate, gait.turn_rate, walk.turn_acceleration, dt);
  } else {
    body.velocity = gait.velocity;
    body.turn_rate = gait.turn_rate;
  }

  // along the arc: its chord lies between both facings
  Vec2 along = body.facing;
  float stretch = dt;
  if (rate != 0) {
    body.heading += rate * dt;
    if (body.heading > kPi) body.heading -= 2 * kPi;
    if (body.heading < -kPi) body.heading += 2 * kPi;
    const SinCos now = sin_cos(body.heading);
    body.facing = {now.cos, now.sin};
    along = 0.5f * (along + body.facing);
    // |along| = cos(half), chord / arc = sin(half) / half: together tan(half) / half
    const float half = 0.5f * rate * dt;
    const float square = half * half;
    stretch *= 1 + square * (1.f / 3 + 2.f / 15 * square);
  }
  const Vec2 displacement = stretch * turned(velocity, along);
  body.position += displacement;
  body.walked += length(displacement);
  return displacement;
}

// standing, starting or stopping as the command wants; false when the body does not move yet
bool change_gear(const Walk& walk, const Effects& effects, bool wanted, Tick now, Body& body) {
  using Doing = Body::Doing;
  const auto shift = [&](Doing doing) { body.doing = doing, body.since = now; };
  if (wanted) {
    if (body.doing == Doing::standing) shift(effects.walk_delay ? Doing::starting : Doing::walking);
    if (body.doing == Doing::stopping) shift(Doing::walking);
    if (body.doing == Doing::starting && now - body.since >= ticks(walk.start_delay)) shift(Doing::walking);
    return body.doing == Doing::walking;
  }
  if (body.doing == Doing::starting) shift(Doing::standing);
  if (body.doing == Doing::walking) shift(Doing::stopping);
  const bool still = body.velocity == Vec2{} && body.turn_rate == 0;
  const Tick delay = effects.walk_delay ? ticks(walk.stop_delay) : 0;
  if (body.doing == Doing::stopping && (still || !effects.walk_acceleration) && now - body.since >= delay) {
    body.velocity = {};
    body.turn_rate = 0;
    shift(Doing::standing);
  }
  return body.doing == Doing::stopping;
}

}  // namespace

Tick walk(const Means& means, const Command& command, int robot, Tick now, Tick left, Errand& errand, World& world) {
  const Walk& model = means.model.walk;
  const Effects& effects = means.effects;
  Body& body = world.bodies[robot];
  const bool was_walking = body.doing == Body::Doing::walking;
  const bool wanted = wants_to_walk(command, errand);

  // not on the move: nothing changes before the start delay is over
  if (!change_gear(model, effects, wanted, now, body)) {
    return wanted ? std::min(left, body.since + ticks(model.start_delay) - now) : left;
  }
  if (!wanted) {
    const Tick end = body.since + ticks(model.stop_delay);
    const Tick together = end > now ? std::min(left, end - now) : 1;
    advance(model, effects.walk_acceleration, {}, static_cast<float>(together) * kTickDuration, body);
    return together;
  }

  // as many ticks at once as change little: up to the next step with its own noise, one by one near a destination
  const bool to = command.body == Command::Body::walk_to;
  const bool cruising = squared_length(errand.walk) > kCruising * kCruising;
  Tick together = !to ? left : cruising ? std::min(left, kCruisingTicks) : 1;
  if (effects.walk_noise) {
    const Tick step = step_at(model, now);
    if (!was_walking || now == 0 || step_at(model, now - 1) != step) draw_noise(model, world, robot, step, body);
    Tick same = 1;
    while (same < together && step_at(model, now + same) == step) ++same;
    together = same;
  }

  const float dt = static_cast<float>(together) * kTickDuration;
  const float gain = std::clamp(command.gain, 0.f, 1.f);
  Gait gait = to ? towards(model, effects.walk_acceleration, gain, errand, 1 / dt)
                 : within_limits(model, effects.walk_acceleration, 1, {errand.walk, errand.turn});
  if (effects.walk_noise) {
    gait.velocity = {gait.velocity.x * body.noise.x, gait.velocity.y * body.noise.y};
    gait.turn_rate += body.turn_noise;
    gait = within_limits(model, false, 1, gait);
  }
  const Vec2 facing = body.facing;
  const float heading = body.heading;
  const Vec2 displacement = advance(model, effects.walk_acceleration, gait, dt, body);

  // what is left, seen from where it is now
  if (to && together < left) {
    errand.walk = turned_back(turned(errand.walk, facing) - displacement, body.facing);
    errand.turn -= body.heading - heading;
    if (errand.turn > kPi) errand.turn -= 2 * kPi;
    if (errand.turn < -kPi) errand.turn += 2 * kPi;
  }
  return together;
}

}  // namespace sim::motion
