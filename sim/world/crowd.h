// The robots on the field, packed in arrays: usually one quick test shows that nothing is near anything else.
#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace sim {

/// The positions of all robots on the field.
struct Crowd {
  static constexpr int kBlock = 4;  // robots tested together, in vector registers
  static constexpr int kRoom = (kMaxRobots + kBlock - 1) / kBlock * kBlock;

  int count = 0;
  bool somebody_lies = false;
  float x[kRoom];  // [m, field]; the last block is filled up with places far from everything
  float y[kRoom];
  std::uint8_t robot[kRoom];  // index in the world

  Vec2 middle(int i) const { return {x[i], y[i]}; }

  /// Reports whether the middle of any robot is nearer to `place` than `reach` [m].
  bool anybody_within(Vec2 place, float reach) const {
    std::uint32_t hits[kBlock] = {};
    for (int block = 0; block < count; block += kBlock)
      for (int lane = 0; lane < kBlock; ++lane)
        hits[lane] |= squared_length(middle(block + lane) - place) < reach * reach ? 1u : 0u;
    return (hits[0] | hits[1] | hits[2] | hits[3]) != 0;
  }
};

/// Returns a different bit for each value of Doing.
constexpr std::uint32_t bit_of(Body::Doing doing) { return 1u << static_cast<unsigned>(doing); }
inline constexpr std::uint32_t kLying = bit_of(Body::Doing::fallen) | bit_of(Body::Doing::getting_up);

/// Returns the robots of `world` that are on the field.
inline Crowd crowd_of(const World& world) {
  Crowd crowd;
  std::uint32_t count = 0, doing = 0;
  for_each_robot(world.players, [&](int robot) {
    // the next robot overwrites a removed one
    const Body& body = world.bodies[robot];
    crowd.x[count] = body.position.x;
    crowd.y[count] = body.position.y;
    crowd.robot[count] = static_cast<std::uint8_t>(robot);
    count += body.doing != Body::Doing::removed ? 1u : 0u;
    doing |= bit_of(body.doing);
  });
  crowd.count = static_cast<int>(count);
  for (int i = crowd.count; i % Crowd::kBlock != 0; ++i) crowd.x[i] = crowd.y[i] = 1e9f;
  crowd.somebody_lies = (doing & kLying) != 0;
  return crowd;
}

}  // namespace sim
