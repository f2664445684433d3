#include "sim/motion/walk.h"

#include <algorithm>
#include <cmath>

#include "sim/motion/gait.h"
#include "sim/motion/glide.h"

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

// Where in the steps of the walk a tick lies. In whole numbers: whoever asks about many ticks at once gets the answers
// for single ones.
struct Rhythm {
  static constexpr std::uint32_t kWhole = 0x10000;
  std::uint32_t a_tick;  // what a tick is of a step, in 1 / kWhole

  explicit Rhythm(const Walk& walk)
      : a_tick(static_cast<std::uint32_t>(static_cast<float>(kWhole) * kTickDuration / walk.step_duration)) {}

  Tick step_at(Tick tick) const { return tick * a_tick / kWhole; }
  bool begins_at(Tick tick) const { return tick * a_tick % kWhole < a_tick; }
  // how many of the `most` ticks from `tick` on are in the same step
  Tick same(Tick tick, Tick most) const {
    const std::uint32_t begun = tick * a_tick % kWhole;
    return begun + (most - 1) * a_tick < kWhole ? most : (kWhole - 1 - begun) / a_tick + 1;
  }
};

// triangular in [-√6, √6): standard deviation 1, and cheap
float deviate(std::uint32_t word) {
  return kTriangular * (static_cast<float>((word & 0xffff) + (word >> 16)) * 0x1p-16f - 1);
}

// A new step of the walk has its own luck; and the rounding of the many small turns before it is taken back. Seldom, so
// that it is kept out of the way of what happens in every tick.
[[gnu::noinline]] void begin_step(const Means& means, World& world, int robot, Tick step) {
  Body& body = world.bodies[robot];
  const SinCos heading = sin_cos(body.heading);
  body.facing = {heading.cos, heading.sin};

  body.noise = {1, 1};
  body.turn_noise = 0;
  if (!means.effects.walk_noise) return;
  const Walk& walk = means.model.walk;
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Event::walk_noise, step);
  body.noise.x = std::max(0.f, 1 + walk.speed_noise * deviate(words[0]));
  body.noise.y = std::max(0.f, 1 + walk.speed_noise * deviate(words[1]));
  body.turn_noise = walk.turn_noise * deviate(words[2]);
}

// standing, starting or stopping as the command wants; false when the body does not move yet
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

// how many ticks, at least one, until a body that stops may stand
Tick until_standing(const Walk& walk, Tick now, const Body& body) {
  const Tick end = body.since + ticks(walk.stop_delay);
  return end > now ? end - now : 1;
}

// what it aims at for the next `dt`
Gait gait_of(const Walk& walk, bool limited, const Command& command, const Errand& errand, float dt, const Body& body) {
  if (command.body == Command::Body::walk_speed) return at_speed(walk, limited, errand.walk, errand.turn, body);
  const float gain = std::clamp(command.gain, 0.f, 1.f);
  const float squared = squared_length(errand.walk);
  return squared > kNear * kNear ? towards_far(walk, limited, gain, errand.walk, squared, body)
                                 : towards_near(walk, limited, gain, errand, dt, body);
}

}  // namespace

void walk(const Means& means, const Command& command, int robot, Tick now, Tick left, World& world) {
  const Walk& model = means.model.walk;
  const bool limited = means.effects.walk_acceleration;
  Body& body = world.bodies[robot];
  Errand errand = errand_of(command);
  const Rhythm rhythm(model);

  // in pieces within which nothing changes
  while (true) {
    const bool wanted = wants_to_walk(command, errand);
    const bool was_walking = body.doing == Body::Doing::walking;
    if (!change_gear(model, means.effects, wanted, now, body)) {
      if (!wanted) return;
      const Tick delay = body.since + ticks(model.start_delay) - now;
      if (left <= delay) return;
      now += delay, left -= delay;
      continue;
    }

    Tick together = rhythm.same(now, left);
    if (rhythm.begins_at(now) || !was_walking) begin_step(means, world, robot, rhythm.step_at(now));
    if (!wanted) together = std::min(together, until_standing(model, now, body));

    const float dt = static_cast<float>(together) * kTickDuration;
    const Gait gait = wanted ? gait_of(model, limited, command, errand, dt, body) : Gait{};
    const Moved moved = glide(model, limited, gait, dt, body);
    if (together == left) return;

    // what is left, seen from where it is now
    now += together, left -= together;
    if (command.body == Command::Body::walk_to) {
      errand.walk = turned_back(errand.walk - moved.displacement, moved.facing);
      errand.turn = wrapped(errand.turn - moved.angle);
    }
  }
}

}  // namespace sim::motion
