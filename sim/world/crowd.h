// The robots on the field, packed in arrays: usually one quick test shows that nothing is near anything else.
#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace sim {

/// The positions of all robots, home 1.., then away 1... A removed robot is far from everything.
struct Crowd {
  static constexpr int kBlock = 4;  // robots tested together, in vector registers
  static constexpr int kRoom = (kMaxRobots + kBlock - 1) / kBlock * kBlock;

  int count = 0;  // both sides
  bool somebody_lies = false;
  float x[kRoom];  // [m, field]; the last block is filled up with places far from everything
  float y[kRoom];

  Vec2 middle(int i) const { return {x[i], y[i]}; }
  /// Returns the index in the world.
  int robot(int i) const { return 2 * i < count ? i : i - count / 2 + kMaxPlayers; }

  /// Reports whether the middle of any robot is nearer to `place` than `reach` [m].
  bool anybody_within(Vec2 place, float reach) const {
    std::uint32_t hits[kBlock] = {};
    for (int block = 0; block < count; block += kBlock)
      for (int lane = 0; lane < kBlock; ++lane)
        hits[lane] |= squared_length(middle(block + lane) - place) < reach * reach ? 1u : 0u;
    return (hits[0] | hits[1] | hits[2] | hits[3]) != 0;
  }

  /// Places a robot far from everything, also from other robots with such a place.
  void take_away(int i) { x[i] = 1e6f * static_cast<float>(i + 2), y[i] = 0; }
};

/// Returns the robots of `world`.
inline Crowd crowd_of(const World& world) {
  Crowd crowd;
  for_each_robot(world.players, [&](int robot) {
    const Body& body = world.bodies[robot];
    const int i = crowd.count++;
    crowd.x[i] = body.position.x;
    crowd.y[i] = body.position.y;
    if (body.doing < Body::Doing::fallen) return;
    if (lies(body))
      crowd.somebody_lies = true;
    else
      crowd.take_away(i);
  });
  for (int i = crowd.count; i % Crowd::kBlock != 0; ++i) crowd.take_away(i);
  return crowd;
}

}  // namespace sim
