// The robots on the field, packed in arrays: usually one quick test shows that nothing is near anything else.
#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace sim {

/// The positions of all robots, home 1.., then away 1... A removed robot is far from everything.
struct Crowd {
  static constexpr int kBlock = 4;  // robots tested together, in vector registers
  static constexpr int kRoom = 24;  // kMaxRobots, the rest of their last block, and half as many again

  int count = 0;  // both sides
  bool somebody_lies = false;
  float x[kRoom];  // [m, field]; after the last robot they begin anew with the first
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

  /// Moves a robot to `place` [m, field].
  void place(int i, Vec2 place) {
    x[i] = place.x, y[i] = place.y;
    if (i + count < kRoom) x[i + count] = place.x, y[i + count] = place.y;
  }
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
    // far from everything, also from other removed robots
    if (lies(body))
      crowd.somebody_lies = true;
    else
      crowd.x[i] = 1e6f * static_cast<float>(i + 2), crowd.y[i] = 0;
  });
  const int blocks = (crowd.count + Crowd::kBlock - 1) / Crowd::kBlock;
  for (int i = crowd.count; i < blocks * Crowd::kBlock + crowd.count / 2; ++i) {
    crowd.x[i] = crowd.x[i - crowd.count];
    crowd.y[i] = crowd.y[i - crowd.count];
  }
  return crowd;
}

}  // namespace sim
