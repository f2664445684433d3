// The percept of the ball in an image: in view, hidden, detected, and with which noise.
#pragma once

#include <span>

#include "sim/perception/look.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// Statistics of the images that show the ball, when one perception covers several images.
struct Images {
  float count;   // expected number; 1 for one image
  float middle;  // [s] their mean time before now
  float spread;  // [s²] sum of the squared distances from that time; 0 for one image, which shows no velocity
};

/// The ball as one perception measures it. No default values, because a pass has room for many.
struct BallPercept {
  bool seen;
  Vec2 position;  // [m, robot]
  Vec2 velocity;  // [m/s, robot's axes] measured from several images; the true one without noise; 0 of a false ball
  Images images;  // source of position and velocity
  Tick ago;       // [ticks] age of the newest of them
  float range;    // [m] true distance of the thing that the newest image shows
  float heat;     // [0..1] how likely an opponent is about to kick the ball
};

/// Computes the percepts[i] of looks[i]: of the robot's last `steps` images, the newest at `world.tick`. Position and
/// velocity are those of the straight line fitted through the places in all images; their errors follow from the noise
/// of each image. Several images count only if the ball is believed visible: the image before them showed it too.
/// Otherwise the head may have been turned away until the newest image.
///
/// Occasionally the newest image shows a false ball. False balls in earlier images are left out: teammates and the
/// robot's own later images would have corrected them by now.
void look_for_ball(const PerceptionParams& params, std::span<const Look> looks, std::span<BallPercept> percepts);

/// Returns the percept of the robot's image at `world.tick` alone.
BallPercept look_for_ball(const PerceptionParams& params, const World& world, int robot);

}  // namespace sim::perception
