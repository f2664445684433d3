// The ball's size in images of robots, beside its true distance.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"
#include "robot/fit/math/resampling.h"

namespace robot::fit {

/// Width [px] of the images to which radii are scaled. A ball beside the optical axis looks larger, by the cosine of the angle
/// between both; radii are scaled by that too if the vision reports the angle.
inline constexpr double kImageWidth = 640;

/// The ball in one image.
struct BallSize {
  std::size_t recording = 0;  // index of the robot's recording
  double at = 0;              // [s] by the clock of the truth, since its epoch
  double radius = 0;          // [px] as if it were in the middle of an image that is kImageWidth wide
  double distance = 0;        // [m] true, along the ground from the robot's origin to the middle of the ball
  double deviation = 0;       // [m] one standard deviation of that
  double rate = 0;            // [m/s] its growth
  double believed = 0;        // [m] as the robot's vision has it
};

struct BallSizes {
  std::vector<BallSize> sizes;          // ordered by recording and time
  std::vector<std::string> recordings;  // names of those with an image, by index
  std::vector<double> clock_deviation;  // [s] of each recording
  std::size_t without_truth = 0;        // images with a ball that the truth did not see
  std::size_t cut = 0;                  // images whose border cuts the ball
  std::size_t damaged = 0;              // images with a radius or a width that cannot be
  std::size_t thinned = 0;              // images of long recordings, left out by thin()
};

/// Reads the vision of each robot.
BallSizes read_ball_sizes(const Evidence& evidence);

/// Returns the passes: images of one recording without a pause of half a second, at most two seconds long.
std::vector<Group> passes_of(const std::vector<BallSize>& sizes);

/// Leaves the first and then each n-th image of a pass, so that about `most` images remain and no pass is lost. The images of a
/// pass are much alike, so hardly anything is lost. `passes` are then those of the images that remain.
void thin(BallSizes& seen, std::vector<Group>& passes, std::size_t most);

}  // namespace robot::fit
