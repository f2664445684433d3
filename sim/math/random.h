// Random numbers with an address instead of an order.
//
// A random number is a function of its address: (seed, robot, purpose, number). No draw consumes anything, so neither
// the order of the draws nor an omitted draw changes a number. Two behaviours on one seed therefore have the same luck.
// The generator is Philox4x32 with 7 rounds, which passes BigCrush (Salmon et al., SC 2011, table 2).
#pragma once

// philox is plain C++: without these two lines the library includes all vector intrinsics of the compiler
#define R123_USE_SSE 0
#define R123_USE_X86INTRIN_H 0
#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "sim/math/angles.h"

namespace sim {

/// The seed of a game. All randomness of the game follows from it.
struct RandomKey {
  std::uint64_t seed = 0;

  friend bool operator==(const RandomKey&, const RandomKey&) = default;
};

/// The purpose of a random number. Append only: the values are part of the address of each number.
enum class Draw : std::uint32_t {
  ball_seen = 1,
  ball_noise = 2,
  false_ball = 3,
  opponent_seen = 4,
  odometry_bias = 5,
  odometry_noise = 6,
  pose_correction = 7,
  pose_flip = 8,
  packet = 9,
  walk_noise = 11,
  kick_noise = 12,
  kick_whiff = 13,
  push_noise = 14,
  fall = 15,
  get_up = 16,
  kick_off = 17,
  official = 18,
  situation = 19,
  belief = 20,
  walk_pace = 21,
  lost_pose = 22,
  duel = 23,
  ball_size = 24,
  drill = 25,
  episode = 26,
  learning = 27,
  servos = 28,
  collision = 29,
};

/// Returns 128 random bits. `robot` is the robot's index in the state, or kNobody when the draw belongs to no robot.
/// `number` distinguishes two draws of one robot for one purpose; it is usually the tick.
/// Inline, so that the compiler drops words that the caller does not read.
inline std::array<std::uint32_t, 4> draw(RandomKey key, std::uint32_t robot, Draw purpose, std::uint32_t number) {
  const philox4x32_ctr_t counter = {{number, static_cast<std::uint32_t>(purpose), robot, 0}};
  const philox4x32_key_t seed = {{static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32)}};
  const philox4x32_ctr_t words = philox4x32_R(7, counter, seed);
  return {words.v[0], words.v[1], words.v[2], words.v[3]};
}
inline constexpr std::uint8_t kNobody = 255;

/// Returns a number in [0, 1) with 24 random bits.
constexpr float uniform(std::uint32_t word) {
  return static_cast<float>(static_cast<std::int32_t>(word >> 8)) * 0x1p-24f;
}
/// Returns two independent numbers of the standard normal distribution from two words (Box and Muller); |value| < 6.
inline std::array<float, 2> normals(std::uint32_t first, std::uint32_t second) {
  const float radius = std::sqrt(-2.f * log(static_cast<float>((first >> 8) + 1) * 0x1p-24f));
  // the upper two bits select the quarter of the circle, the others a place in it
  const float rest = static_cast<float>(static_cast<std::int32_t>(second << 2)) * (kPi * 0x1p-33f);
  const SinCos place = detail::sin_cos_of_rest(rest, second >> 30);
  return {radius * place.cos, radius * place.sin};
}

/// Returns four draws, two from each pair of words.
inline std::array<float, 4> normals(const std::array<std::uint32_t, 4>& words) {
  const auto first = normals(words[0], words[1]), second = normals(words[2], words[3]);
  return {first[0], first[1], second[0], second[1]};
}

}  // namespace sim
