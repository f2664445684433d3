// What an image shows of the ball: in view or not, hidden or not, detected or not, and with which noise.
#pragma once

#include "sim/perception/perception.h"

namespace sim::perception {

struct BallPercept {
  bool seen = false;
  Vec2 position;  // [m, robot]
  Vec2 velocity;  // [m/s, robot's axes] the true one; of what is no ball 0. No camera shows it: only for perfect eyes
  float images = 1;  // of how many it is the mean
  Tick ago = 0;      // [ticks] since the newest of them
  float heat = 0;    // [0..1] how much an opponent looks like kicking it
};

/// The ball as the last `steps` images show it to a robot, the newest at `world.tick`, or now and then something else
/// that looks like it. They are taken together, as if nothing had moved since the first of them: the mean of all that
/// show it, as often as that is on average.
BallPercept look_for_ball(const Means& means, const World& world, int robot, Tick steps);

}  // namespace sim::perception
