// What an image shows of the ball: in view or not, hidden or not, detected or not, and with which noise.
#pragma once

#include "sim/perception/image.h"
#include "sim/perception/perception.h"

namespace sim::perception {

struct BallPercept {
  bool seen = false;
  Vec2 position;   // [m, robot]
  Vec2 velocity;   // [m/s, robot's axes] the true one; of what is no ball 0. No camera shows it: only for perfect eyes
  float heat = 0;  // [0..1] how much an opponent looks like kicking it
};

/// Where the image shows the ball: where it was `latency` ago, in whole ticks. [m, field]
///
/// What the robot itself moved meanwhile its odometry makes good; that this errs over 70 ms is left out.
inline Vec2 shown_ball(const Means& means, const Ball& ball) {
  const Tick ago = means.effects.latency ? ticks(means.model.camera.latency) : 0;
  return ago == 0 ? ball.position : ball.past[ago - 1];
}

/// The ball, if it is detected where it shows in the image. A body between camera and ball hides it; a ball at the feet
/// of one is in front of it.
BallPercept detect_ball(const Means& means, const World& world, int robot, const Sighting& sighting);

/// Now and then something that looks like a ball, anywhere in view.
BallPercept detect_false_ball(const Means& means, const World& world, int robot);
inline constexpr Tick kFalseInterval = 10;  // [ticks] between the images that may show one

/// The ball as the image of `world.tick` shows it to a robot, or something else that looks like it. `steps` [ticks]
/// since the last image.
inline BallPercept look_for_ball(const Means& means, const World& world, int robot, Tick steps) {
  const Body& body = world.bodies[robot];
  if (!has_eyes(body)) return {};
  const Camera& camera = means.model.camera;
  const Sighting sighting = sighting_of(body, shown_ball(means, world.ball), camera.height - means.ball.radius);
  if (!means.effects.limited_view || in_view(camera, body, look_of(body), means.model.ball.far_range, sighting)) {
    const BallPercept percept = detect_ball(means, world, robot, sighting);
    if (percept.seen) return percept;
  }
  if (!means.effects.false_balls || world.tick % kFalseInterval >= steps) return {};
  return detect_false_ball(means, world, robot);
}

}  // namespace sim::perception
