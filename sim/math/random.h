// Random numbers with an address instead of an order.
//
// A number is a function of who draws it for what: (seed, robot, kind of event, number of the event). Nothing is
// consumed, so it does not matter who asks first or whether anybody asks at all, and two behaviours on one seed meet
// the same luck. Philox4x32 with 7 rounds, which passes BigCrush (Salmon et al., SC 2011, table 2).
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "sim/math/angles.h"

namespace sim {

/// Which game: all randomness of a game follows from it.
struct RandomKey {
  std::uint64_t seed = 0;

  friend bool operator==(const RandomKey&, const RandomKey&) = default;
};

/// What a number is drawn for. Append only: the numbers of a game hang on the values.
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
};

/// 128 random bits for one event. `robot` is its index in the state (kNobody for the game's own events); `number`
/// is what tells two events of one kind apart, mostly the tick.
/// Inline, because then the words that nobody reads are not computed.
inline std::array<std::uint32_t, 4> draw(RandomKey key, std::uint32_t robot, Draw purpose, std::uint32_t number) {
  const philox4x32_ctr_t counter = {{number, static_cast<std::uint32_t>(purpose), robot, 0}};
  const philox4x32_key_t seed = {{static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32)}};
  const philox4x32_ctr_t words = philox4x32_R(7, counter, seed);
  return {words.v[0], words.v[1], words.v[2], words.v[3]};
}
inline constexpr std::uint8_t kNobody = 255;

/// [0, 1) of 24 bits.
constexpr float uniform(std::uint32_t word) { return static_cast<float>(word >> 8) * 0x1p-24f; }
/// Two independent draws of the standard normal distribution, from two words (Box and Muller); |value| < 6.
inline std::array<float, 2> normals(std::uint32_t first, std::uint32_t second) {
  const float radius = std::sqrt(-2.f * log(static_cast<float>((first >> 8) + 1) * 0x1p-24f));
  // the upper two bits are the quarter of the circle, the others a place in it
  const float rest = static_cast<float>(static_cast<std::int32_t>(second << 2)) * (kPi * 0x1p-33f);
  const SinCos place = detail::sin_cos_of_rest(rest, second >> 30);
  return {radius * place.cos, radius * place.sin};
}

}  // namespace sim
