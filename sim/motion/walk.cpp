#include "sim/motion/walk.h"

#include <algorithm>
#include <cmath>

#include "sim/motion/gait.h"
#include "sim/motion/glide.h"
#include "sim/motion/rhythm.h"

namespace sim::motion {
namespace {

constexpr float kTriangular = 2.44949f;  // √6: standard deviation 1 for the sum of two uniform numbers

bool wants_to_walk(const Command& command, const Errand& errand) {
  switch (command.body) {
    case Command::Body::walk_speed: return errand.walk.x != 0 || errand.walk.y != 0 || errand.turn != 0;
    case Command::Body::walk_to:
      return squared_length(errand.walk) > kArrived * kArrived || std::abs(errand.turn) > kArrivedTurn;
    default: return false;
  }
}

/// Returns a number in [-√6, √6) with a triangular distribution and standard deviation 1.
/// It is cheaper than a normal one.
float deviate(std::uint32_t word) {
  return kTriangular * (static_cast<float>((word & 0xffff) + (word >> 16)) * 0x1p-16f - 1);
}

Luck draw_luck(const Walk& walk, const World& world, int robot, Tick step) {
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::walk_noise, step);
  return {{std::max(0.f, 1 + walk.speed_noise * deviate(words[0])),
           std::max(0.f, 1 + walk.speed_noise * deviate(words[1]))},
          walk.turn_noise * deviate(words[2])};
}

/// Returns the walk of this robot: the speeds of the model times its own pace, which is the same in the whole game.
Walk walk_of(const MotionParams& params, const World& world, int robot) {
  Walk walk = params.model.walk;
  if (!params.effects.walk_spread) return walk;
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::walk_pace, 0);
  const float pace = 1 - walk.spread * uniform(words[0]);
  walk.forward *= pace, walk.backward *= pace, walk.sideward *= pace;
  return walk;
}

/// Changes between standing, starting, walking and stopping. Returns false when the body does not move yet.
bool change_gear(const Walk& walk, const Effects& effects, bool wanted, Tick now, Body& body) {
  using Doing = Body::Doing;
  const auto shift = [&](Doing doing) { body.doing = doing, body.since = now; };
  if (wanted) {
    if (body.doing == Doing::walking) return true;
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

/// Returns the time until a stopping body may stand [ticks], at least 1.
Tick until_standing(const Walk& walk, Tick now, const Body& body) {
  const Tick end = body.since + ticks(walk.stop_delay);
  return end > now ? end - now : 1;
}

/// Returns the time until a stopping body is still and its step ends [ticks], at least 1.
Tick until_still(const Walk& walk, bool limited, const Body& body) {
  if (!limited) return 1;
  const float seconds =
      std::max(length(body.velocity) / walk.acceleration, std::abs(body.turn_rate) / walk.turn_acceleration);
  return std::max<Tick>(1, static_cast<Tick>(std::ceil((1 - kRounding) * seconds * kTicksPerSecond)));
}

/// Returns the gait to aim at for the next `dt`.
Gait gait_of(const Walk& walk, bool limited, const Command& command, const Errand& errand, float dt, const Luck& luck) {
  if (command.body == Command::Body::walk_speed) return at_speed(walk, limited, errand.walk, errand.turn, luck);
  const float gain = std::clamp(command.gain, 0.f, 1.f);
  const float squared = squared_length(errand.walk);
  return squared > kNear * kNear ? towards_far(walk, limited, gain, errand.walk, squared, luck)
                                 : towards_near(walk, limited, gain, errand, dt, luck);
}

/// Settles the gait of the step that begins now, or of the present step when the body begins to walk within it. Also
/// removes the rounding of the small turns before. Not inline, because it is rare.
[[gnu::noinline]] void begin_step(const MotionParams& params, const Rhythm& rhythm, const Command& command,
                                  const Errand& errand, Tick now, int robot, World& world) {
  Body& body = world.bodies[robot];
  const SinCos heading = sin_cos(body.heading);
  body.facing = {heading.cos, heading.sin};
  body.step_velocity = {};
  body.step_turn_rate = 0;
  if (body.doing != Body::Doing::walking) return;

  const Walk walk = walk_of(params, world, robot);
  const Luck luck = params.effects.walk_noise ? draw_luck(walk, world, robot, rhythm.step_at(now)) : Luck{};
  const float dt = static_cast<float>(rhythm.until_next(now)) * kTickDuration;
  const Gait gait = gait_of(walk, params.effects.walk_acceleration, command, errand, dt, luck);
  body.step_velocity = gait.velocity;
  body.step_turn_rate = gait.turn_rate;
}

}  // namespace

void walk(const MotionParams& params, const Command& command, int robot, Tick now, Tick left, World& world) {
  const Walk& model = params.model.walk;
  const bool limited = params.effects.walk_acceleration;
  Body& body = world.bodies[robot];
  Errand errand = errand_of(command);
  const Rhythm rhythm(model);

  // move in pieces within which nothing changes
  while (true) {
    if (!in_step(rhythm, body, now)) {
      const bool wanted = wants_to_walk(command, errand);
      if (!change_gear(model, params.effects, wanted, now, body)) {
        if (!wanted) return;
        const Tick delay = body.since + ticks(model.start_delay) - now;
        if (left <= delay) return;
        now += delay, left -= delay;
        continue;
      }
      begin_step(params, rhythm, command, errand, now, robot, world);
    }

    Tick together = std::min(left, rhythm.until_next(now));
    if (body.doing == Body::Doing::stopping)
      together = std::min({together, until_standing(model, now, body), until_still(model, limited, body)});
    const Gait gait{body.step_velocity, body.step_turn_rate};
    const Moved moved = glide(model, limited, gait, static_cast<float>(together) * kTickDuration, body);
    if (together == left) return;

    // the rest, seen from the present pose
    now += together, left -= together;
    if (command.body == Command::Body::walk_to) {
      errand.walk = turned_back(errand.walk - moved.displacement, moved.facing);
      errand.turn = wrapped(errand.turn - moved.angle);
    }
  }
}

}  // namespace sim::motion
