// Who is on the field and where, packed: most of the time one look tells that nobody is near anything.
#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace sim {

struct Crowd {
  static constexpr int kBlock = 4;  // as many are looked at together
  static constexpr int kRoom = (kMaxRobots + kBlock - 1) / kBlock * kBlock;

  int count = 0;
  bool somebody_lies = false;
  bool somebody_touched = false;  // another one, when that was last counted
  float x[kRoom];                 // [m, field]; the rest of the last block is far from everything
  float y[kRoom];
  std::uint8_t robot[kRoom];  // index in the world

  Vec2 middle(int i) const { return {x[i], y[i]}; }
};

inline bool lies(const Body& body) {
  return body.doing == Body::Doing::fallen || body.doing == Body::Doing::getting_up;
}

inline Crowd crowd_of(const World& world) {
  Crowd crowd;
  unsigned lying = 0, touching = 0;
  for_each_robot(world.players, [&](int robot) {
    // whoever is removed is overwritten by the next
    const Body& body = world.bodies[robot];
    crowd.x[crowd.count] = body.position.x;
    crowd.y[crowd.count] = body.position.y;
    crowd.robot[crowd.count] = static_cast<std::uint8_t>(robot);
    crowd.count += body.doing != Body::Doing::removed;
    lying |= lies(body);
    touching |= body.touching;
  });
  for (int i = crowd.count; i % Crowd::kBlock != 0; ++i) crowd.x[i] = crowd.y[i] = 1e9f;
  crowd.somebody_lies = lying != 0;
  crowd.somebody_touched = touching != 0;
  return crowd;
}

}  // namespace sim
