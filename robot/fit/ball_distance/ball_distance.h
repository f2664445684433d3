// The distance of the ball from its size in the image: figure 11 of the thesis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/fit/ball_distance/curve.h"
#include "robot/fit/figure.h"
#include "robot/lab/clocks/belief_error.h"

namespace robot::fit {

/// The errors of a curve on images that it was not fitted to.
struct HeldOut {
  std::string curve;         // "pinhole", or "the robot's own"
  double from = 0, to = 0;   // [m] true distance
  bool is_whole = false;     // all distances
  lab::ErrorFigures errors;  // of the absolute error; a sample is an image
  double bias = 0;           // [m] mean error, > 0: too far
};

/// The fitted curve at one radius.
struct CurvePoint {
  double radius = 0;                       // [px]
  double distance = 0, low = 0, high = 0;  // [m] and the interval that covers 95 %
};

struct BallDistance {
  BallSizes seen;
  Curve pinhole, power_law;
  std::vector<Figure> figures;    // of the pinhole: scale [m px], offset [px], height [m above the ball's middle]
  std::vector<CurvePoint> curve;  // from the smallest to the largest radius
  std::string parts;              // how images were held out: "each of 3 recordings"
  std::vector<HeldOut> held_out;  // for each curve all distances first, then the bins that have images
  double least_radius = 0, most_radius = 0;  // [px] of the images: the domain

  /// Returns the distance [m] for a radius in an image of kImageWidth [px], or nothing outside the domain.
  std::optional<double> distance(double radius) const;
};

/// Fits the curves. The interval of a figure covers the luck of whole passes and the error of each recording's clock. Returns an
/// Error with the reason if the images cannot carry a fit: too few images or passes, or distances that are too alike.
Result<BallDistance> fit_ball_distance(BallSizes seen);

/// Returns the errors of each curve: all distances first, then the same bins.
std::vector<std::vector<HeldOut>> by_curve(const std::vector<HeldOut>& held_out);
/// Formats the range of true distances [m]: "0.5-1.0", or "all".
std::string range_of(const HeldOut& errors);

/// Returns the images with the radius, the true distance, that of the robot's vision and that of the curve.
Table table_of(const BallDistance& fit);

/// Formats the fit for a terminal, with the figure drawn in characters.
std::string to_text(const BallDistance& fit);

}  // namespace robot::fit
