// The random part of walking. Internal to sim/motion.
#pragma once

#include <array>
#include <cstdint>

#include "sim/math/random.h"
#include "sim/math/vec2.h"
#include "sim/motion/clamped.h"
#include "sim/motion/model.h"

namespace sim::motion {

inline constexpr float kTriangular = 2.44949f;  // √6: standard deviation 1 for the sum of two uniform numbers

/// The noise of one step: factors of the forward and the sideward speed, and an added turn rate [rad/s].
struct Luck {
  Vec2 speed{1, 1};
  float turn = 0;
};

/// Four random words (sim/math/random.h).
using Words = std::array<std::uint32_t, 4>;

/// Returns a number in [-√6, √6) with a triangular distribution and standard deviation 1.
/// It is cheaper than a normal one.
inline float deviate(std::uint32_t word) {
  const auto sum = static_cast<std::int32_t>((word & 0xffff) + (word >> 16));
  return kTriangular * (static_cast<float>(sum) * 0x1p-16f - 1);
}

/// Returns the noise of a step from the words of Draw::walk_noise.
inline Luck luck_of(const Walk& walk, const Words& words) {
  return {
      {greater(0.f, 1 + walk.speed_noise * deviate(words[0])), greater(0.f, 1 + walk.speed_noise * deviate(words[1]))},
      walk.turn_noise * deviate(words[2])};
}

/// Returns the share of the model's speeds that a robot reaches, from the words of Draw::walk_pace.
inline float share_of(const Walk& walk, const Words& words) { return 1 - walk.spread * uniform(words[0]); }

/// Returns the walk of a robot that reaches this share of the model's speeds.
inline Walk walk_at(const Walk& model, float share) {
  Walk walk = model;
  walk.forward *= share, walk.backward *= share, walk.sideward *= share;
  return walk;
}

}  // namespace sim::motion
