// Walking in lanes: one robot in each. Internal to sim/motion.
#pragma once

#include <bit>
#include <cstdint>

#include "sim/math/lanes.h"
#include "sim/motion/glide.h"
#include "sim/world/effects.h"

namespace sim::motion {

/// A gait in each lane.
struct GaitLanes {
  Lane<Vec2> velocity;
  Lane<float> turn_rate;

  Gait operator[](int i) const { return {velocity[i], turn_rate[i]}; }
  void set(int i, const Gait& gait) { velocity.set(i, gait.velocity), turn_rate[i] = gait.turn_rate; }
};

/// Returns `a` if `first` is true, `b` otherwise. By bits, because the compiler moves loads into the arms of a choice,
/// and SSE2 cannot load under a condition.
inline float pick(bool first, float a, float b) {
  const std::uint32_t mask = 0u - static_cast<std::uint32_t>(first);
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(a) & mask) | (std::bit_cast<std::uint32_t>(b) & ~mask));
}
inline Vec2 pick(bool first, Vec2 a, Vec2 b) { return {pick(first, a.x, b.x), pick(first, a.y, b.y)}; }
inline Gait pick(bool first, const Gait& a, const Gait& b) {
  return {pick(first, a.velocity, b.velocity), pick(first, a.turn_rate, b.turn_rate)};
}

/// The walks of up to kLanes robots, for one piece of time in which nothing changes but what is here.
struct WalkLanes {
  // the bodies
  Lane<Vec2> position, facing, velocity;
  Lane<float> heading, turn_rate, walked;
  // their present steps
  DrawLanes draws;            // number: of the step
  Lane<std::int32_t> begins;  // 1: the piece begins a step
  Lane<std::int32_t> walks;   // 1: walking; 0: stopping
  Lane<float> until_next;     // [s] from the begin of the piece to the next step
  Lane<float> share;          // of the model's speeds that the robot reaches
  Lane<Vec2> luck_speed;      // Luck::speed
  Lane<float> luck_turn;      // Luck::turn
  GaitLanes gait;
  // their errands
  Lane<Vec2> target;            // Errand::walk
  Lane<float> turn;             // Errand::turn
  Lane<std::int32_t> by_speed;  // Errand::by_speed
  Lane<float> gain;
  Lane<float> dt;  // [s] length of the piece

  /// Returns the walk of this robot.
  Walk walk(int i, const Walk& model) const { return walk_at(model, share[i]); }
  Luck luck(int i) const { return {luck_speed[i], luck_turn[i]}; }
  void set_luck(int i, const Luck& luck) { luck_speed.set(i, luck.speed), luck_turn[i] = luck.turn; }
  /// Returns the words that settle the robot's share: the same in the whole game.
  Words pace_words(int i) const {
    const RandomKey key{draws.low[i] | static_cast<std::uint64_t>(draws.high[i]) << 32};
    return draw(key, draws.robot[i], Draw::walk_pace, 0);
  }
  Errand errand(int i) const { return {target[i], turn[i], by_speed[i] != 0}; }
  void set_errand(int i, const Errand& errand) {
    target.set(i, errand.walk), turn[i] = errand.turn, by_speed[i] = errand.by_speed ? 1 : 0;
  }
  Walking body(int i) const { return {position[i], heading[i], facing[i], velocity[i], turn_rate[i], walked[i]}; }
  void set_body(int i, const Walking& body) {
    position.set(i, body.position), facing.set(i, body.facing), velocity.set(i, body.velocity);
    heading[i] = body.heading, turn_rate[i] = body.turn_rate, walked[i] = body.walked;
  }
};

/// Settles the gait of the steps that begin, and removes the rounding of the small turns before.
template <bool Limited>
void begin_steps(const Walk& model, const Effects& effects, WalkLanes& a) {
  const Walk walk = model;
  SIM_FOR_LANES(i) a.share[i] = 1;
  if (effects.walk_spread) SIM_FOR_LANES(i) a.share[i] = share_of(walk, a.pace_words(i));

  SIM_FOR_LANES(i) a.set_luck(i, {});
  if (effects.walk_noise) SIM_FOR_LANES(i) a.set_luck(i, luck_of(walk, a.draws.draw(i, Draw::walk_noise)));

  GaitLanes by_speed, far, near;
  SIM_FOR_LANES(i) by_speed.set(i, at_speed(a.walk(i, walk), Limited, a.errand(i), a.luck(i)));
  SIM_FOR_LANES(i) far.set(i, towards_far(a.walk(i, walk), Limited, a.gain[i], a.errand(i), a.luck(i)));
  SIM_FOR_LANES(i)
  near.set(i, towards_near(a.walk(i, walk), Limited, a.gain[i], a.errand(i), a.until_next[i], a.luck(i)));

  SIM_FOR_LANES(i) {
    const bool begins = a.begins[i] != 0, walks = a.walks[i] != 0;
    const Gait gait = pick(a.by_speed[i] != 0, by_speed[i], pick(is_far(a.target[i]), far[i], near[i]));
    a.facing.set(i, pick(begins, direction(a.heading[i]), a.facing[i]));
    a.gait.set(i, pick(begins, pick(walks, gait, Gait{}), a.gait[i]));
  }
}

/// Moves the bodies through the piece.
template <bool Limited>
void glide_on(const Walk& model, WalkLanes& a) {
  const Walk walk = model;
  SIM_FOR_LANES(i) {
    const Glide glided = glide(walk, Limited, a.gait[i], a.dt[i], a.body(i));
    a.set_body(i, glided.body);
    a.set_errand(i, after(a.errand(i), glided.moved));
  }
}

}  // namespace sim::motion
