// Writes label files of the Standard Platform League as a known camera sees a known game.
#pragma once

#include <string>
#include <vector>

#include "robot/lab/import/label_camera.h"

namespace tests {

/// A camera 1.5 m beside the touch line at -y. It looks straight across the field.
robot::lab::labels::Camera label_camera();

/// A robot of the known game, or the ball with number 0 [m, field].
struct Labelled {
  int colour, number;
  double x, y;
  bool down = false;
};

/// Returns the robots of the known game after `seconds`: five of colour 2 that defend the goal at -x, five of colour 5,
/// and the ball. Robot 2 of colour 2 lies from second 10 to 14.
std::vector<Labelled> labelled_game(double seconds);

/// Returns the file of the first `seconds` of that game. Boxes are exact: a box ends at the feet and begins at the head.
std::string label_file(const robot::lab::labels::Camera& camera, double seconds);

}  // namespace tests
