// How exactly the robots place the ball: the noise of the camera model, from percepts beside the truth.
#pragma once

#include "robot/fit/ball_noise/ball_places.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits `noise.tilt` (robots that stand), `noise.tilt_walking` (others that are upright) and `noise.roll` (bearing)
/// to percepts of balls that lie. `noise.pixels` of `base` is contained in all errors and is not fitted: tilt and
/// pixels cannot be distinguished. An error of the elevation displaces far balls more than near ones, so angles are
/// fitted, not distances.
///
/// Errors count from the median of each recording: a constant heading error of the truth has no part in the noise.
/// The variances of the true place, of the heading's scatter and of the clock are subtracted. Intervals cover the
/// luck of passes.
///
/// `ball_noise.range_bias` (share of the distance) and `ball_noise.bearing_bias` (rad) are only reported. Results:
/// coverage and score of images held out beside `base`, errors of percepts and beliefs over distance, biases of each
/// recording.
///
/// A parameter with fewer than 40 images in 8 passes is kept: without motion status the tilts, without true headings
/// the roll.
Report fit_ball_noise(const BallPlaces& places, const sim::Models& base);
/// Reads the places and fits them.
Report fit_ball_noise(const Evidence& evidence, const sim::Models& base);

}  // namespace robot::fit
