// From the ground before the camera to the field: by the places of the two goalkeepers.
#pragma once

#include <array>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/import/label_camera.h"

namespace robot::lab::labels {

/// The two teams of a file by the colours of their jerseys, ascending. The goalkeepers wear number 1.
using Teams = std::array<int, 2>;

/// Returns the two colours with the most boxes, or an Error if there are fewer.
Result<Teams> teams_of(const std::vector<Frame>& frames);

/// Returns the team 0 or 1 of a robot, or -1 if its colour is another one.
int team_of(const RobotBox& robot, const Teams& teams);

/// The view of a camera on the field. The first team defends the goal at -x.
struct FieldView {
  Camera camera;
  Ground middle;                    // of the field, before the camera
  double ahead_x = 1, ahead_y = 0;  // unit vector of the field's +x, before the camera
  double scale = 1;                 // metres of the field for one of the camera's
  double stretch = 1;               // of y, which the fit may compress

  /// Returns the point of the field [m] seen at a pixel, if it is `above` [m] the ground.
  Ground at(double x_px, double y_px, double above = 0) const;
  Ground feet(const Box& robot) const { return at(robot.middle(), robot.bottom); }
  Ground ball(const Box& ball) const { return at(ball.middle(), (ball.top + ball.bottom) / 2, 0.05); }
};

/// Finds the field: the median places of the goalkeepers are 8.5 m apart, the middle is between them. Returns an Error if
/// a goalkeeper is hardly seen.
Result<FieldView> find_field(const Camera& camera, const std::vector<Frame>& frames, const Teams& teams);

}  // namespace robot::lab::labels
