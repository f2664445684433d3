// The true motion of ball and robot as smooth curves.
#pragma once

#include <optional>

#include "robot/lab/clocks/series.h"
#include "robot/lab/clocks/truth_record.h"

namespace robot::lab {

/// The ball beside one robot, as the truth has it.
class TrueMotion {
 public:
  /// `own` is the path of the robot.
  TrueMotion(const TruthRecord& truth, const Path& own);

  struct Moment {
    PlaceAt ball;
    double speed = 0;     // [m/s] of the ball
    double distance = 0;  // [m] from the robot to the ball
    double rate = 0;      // [m/s] growth of the distance
  };

  /// Returns the moment [s, clock of the truth], or nothing if the ball or the robot was not seen around it.
  std::optional<Moment> at(double seconds) const;

 private:
  SmoothCurve ball_x_, ball_y_, own_x_, own_y_;
};

}  // namespace robot::lab
