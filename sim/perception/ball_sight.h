// What an image shows of the ball: in view or not, hidden or not, detected or not, and with which noise.
#pragma once

#include "sim/perception/perception.h"

namespace sim::perception {

/// The images that show the ball, when several are looked at together.
struct Images {
  float count = 1;   // as many as show it on average
  float middle = 0;  // [s] before the moment of looking: their mean
  float spread = 0;  // [s²] sum of the squared distances from that: 0 of a single one, which tells no velocity
};

struct BallPercept {
  bool seen = false;
  Vec2 position;   // [m, robot]
  Vec2 velocity;   // [m/s, robot's axes] by the spread of the images; perfect eyes see the true one, of no ball it is 0
  Images images;   // from which both are
  Tick ago = 0;    // [ticks] since the newest of them
  float heat = 0;  // [0..1] how much an opponent looks like kicking it
};

/// The ball as the last `steps` images show it to a robot, the newest at `world.tick`. Several are taken together:
/// position and velocity are those of the straight way through the places that all of them show, as far off as the noise
/// of each makes it. They all count only of a ball that was `followed` by the image before them, too: else the head may
/// have been turned away during all but the newest.
///
/// Now and then the newest image shows something else that looks like it. What earlier ones do is left out: by now
/// teammates and the robot's own eyes have put it right.
BallPercept look_for_ball(const PerceptionParams& params, const World& world, int robot, Tick steps, bool followed);

}  // namespace sim::perception
