// The images of robots beside the true place of the ball.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Whether another standing robot is between the camera and the ball.
enum class Hiding : std::uint8_t { free, unsure, hidden };

/// One image of a robot that stands. Frame: robot. Angles are bearings, counter-clockwise from ahead.
struct Look {
  std::size_t recording = 0;  // index of the robot's recording
  double at = 0;              // [s] by the clock of the truth, since its epoch
  double duration = 0;        // [s] since the image before, at most 0.1

  // the truth
  double distance = 0, bearing = 0;  // [m], [rad] of the ball
  double height = 0;                 // [m] of the camera above the middle of the ball
  double placed = 0;                 // [m] one standard deviation of the ball's place beside the robot
  Hiding hiding = Hiding::free;
  bool walking = false;

  // the camera that shows the ball best
  double across = 0, upright = 0;      // [rad] from the middle of the ball to the nearest borders, < 0 outside
  double axis = 0;                     // [rad] bearing of the optical axis
  double head_speed = 0;               // [rad/s] turning rate of the optical axis
  double width = 0;                    // [rad] of the view
  double nearest = 0, farthest = 1e9;  // [m] balls on the ground that any camera shows

  // the robot's vision
  bool has_ball = false;
  double seen_x = 0, seen_y = 0;  // [m]
};

struct Looks {
  std::vector<Look> looks;              // ordered by recording and time
  std::vector<std::string> recordings;  // names of those with a look, by index
  // images that are left out
  std::size_t without_truth = 0;  // the ball's place or the robot's is not known, or one of them was just put elsewhere
  std::size_t without_heading = 0;  // the truth has no heading of the robot
  std::size_t without_camera = 0;   // the recording has no camera matrix of that time
  std::size_t not_upright = 0;      // the robot lies
  std::size_t damaged = 0;          // the seen ball's place is not finite
};

/// Reads vision and cameras of each robot. `base` has the sizes of robots and ball, and the delay of the camera.
Looks read_looks(const Evidence& evidence, const sim::Models& base);

/// Returns why no image can be used, as the end of a sentence.
std::string reason_without(const Looks& looks);

/// Returns one sentence about the images that are left out.
std::string left_out(const Looks& looks);

}  // namespace robot::fit
