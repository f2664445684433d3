// How often a robot sees a ball where there is none.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"
#include "robot/fit/report.h"
#include "robot/fit/visibility/sights.h"
#include "sim/match/params.h"

namespace robot::fit {

/// A ball in an image that is not the true one.
struct FalseBall {
  std::size_t recording = 0;
  double at = 0;                  // [s] as Look::at
  double x = 0, y = 0;            // [m, robot] where it was seen
  double true_x = 0, true_y = 0;  // [m, robot] where the ball was
  bool first = true;              // false: it goes on from an image shortly before
};

struct FalseBalls {
  std::vector<FalseBall> balls;
  std::vector<FalseBall> seen;  // some of the true balls that were seen, to compare with
  double exposure = 0;          // [s] of images in which a false ball would have been noticed
  double seconds = 0;           // [s] of all images without the true ball
};

/// Finds the false balls, and the time in which they would have been noticed.
///
/// The simulator draws a false ball only if the image shows no true one. Its range is 0.3 m up to the end of the detection's, its
/// bearing any in view; one above or below the image is dropped. So an image without the true ball counts by the share of these places
/// that is in the image and is not taken for the true ball.
FalseBalls false_balls_in(const Looks& looks, const sim::Models& base);

/// Fits `ball_filter.false_per_second`: false percepts per second of those images. A false ball in successive images counts once for
/// the interval, which is an exact one of Poisson. Without any the value is 0, with the same upper end.
///
/// The figure replaces the default if half its interval is at most 0.01 1/s, a false ball in 100 s, or half of the value. The truth
/// needs headings, and the recording camera matrices.
Report fit_false_balls(const Evidence& evidence, const sim::Models& base);

/// As fit_false_balls() for images that are read already.
Report false_balls_of(const Looks& looks, const sim::Models& base);

}  // namespace robot::fit
