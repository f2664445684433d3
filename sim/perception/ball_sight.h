// What an image shows of the ball: in view or not, hidden or not, detected or not, and with which noise.
#pragma once

#include "sim/perception/perception.h"

namespace sim::perception {

struct BallPercept {
  bool seen = false;
  Vec2 position;   // [m, robot]
  Vec2 velocity;   // [m/s, robot's axes] the true one; of what is no ball 0. No camera shows it: only for perfect eyes
  float heat = 0;  // [0..1] how much an opponent looks like kicking it
};

/// The ball as the image of `world.tick` shows it to a robot, or now and then something else that looks like it. `steps`
/// [ticks] since the last image.
BallPercept look_for_ball(const Means& means, const World& world, int robot, Tick steps);

}  // namespace sim::perception
