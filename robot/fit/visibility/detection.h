// The simulator's own model of a detection, fitted to images. Pure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/figure.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/visibility/sights.h"
#include "sim/perception/model.h"

namespace robot::fit {

/// The probability of sim::perception::probability(), in double.
struct DetectionCurve {
  double near = 0, far = 0;              // [0..1]
  double near_range = 0, far_range = 0;  // [m]

  double probability(double distance) const;
};

DetectionCurve curve_of(const sim::perception::Detection& model);

/// Returns the probability that the simulator shows the ball in this image: 0 if it is hidden.
double shown_by(const DetectionCurve& curve, const Sight& sight);

struct DetectionFit {
  DetectionCurve curve;           // parameters that are not fitted are those of the default
  std::vector<Figure> figures;    // ball_detection.near …, without those that are not known
  std::vector<std::string> kept;  // the reasons
};

/// Fits the curve to the balls that no robot hides, by maximum likelihood. Intervals are those of resampled passes.
///
/// Nothing is fitted with fewer than 20 passes, nor if the distances differ by less than a metre or by less than half of the nearest.
/// `far` needs balls at three quarters of its range. `near_range` needs a share that falls within the distances that were seen.
/// `far_range` stays, unless three passes show balls beyond it, each in three images.
DetectionFit fit_detection(const Sights& sights, const std::vector<Group>& passes, const DetectionCurve& standard);

/// As fit_detection() on the chosen passes, but without intervals.
DetectionCurve detection_of(const Sights& sights, const std::vector<Group>& passes, const DetectionCurve& standard);

}  // namespace robot::fit
