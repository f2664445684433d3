// The way that a walking robot believes it has gone.
#pragma once

#include <optional>

#include "robot/nao/walk/sensors.h"

namespace robot::nao::walk {

/// A pose since the beginning. Frame: that of the robot at the beginning.
struct Way {
  double x = 0, y = 0;  // [m]
  double heading = 0;   // [rad] (-π, π]
};

/// Returns the place [m, robot] of a robot that has gone to `now`, of what lay at `place` [m, robot] at `then`.
Point passed(const Way& then, const Point& place, const Way& now);

/// The odometry of one robot. The support foot stays where it is, so the torso moves against it. The gyroscope gives the
/// heading; its bias is learned while the robot stands. In physics the way is 2 % too short with stiff servos and 16 % with
/// soft ones, at 0.2 m/s (medians).
class Odometry {
 public:
  /// Takes a frame of sensors, `dt` [s] after the last one. `support` is the foot that carries the robot, or nothing while
  /// it stands on both feet.
  void see(const Sensors& sensors, std::optional<Side> support, double dt);

  const Way& way() const { return way_; }

 private:
  Way way_;
  std::optional<Side> support_;
  Point foot_;       // [m, torso] of the support foot in the last frame
  double bias_ = 0;  // [rad/s] of the gyroscope about z
};

}  // namespace robot::nao::walk
