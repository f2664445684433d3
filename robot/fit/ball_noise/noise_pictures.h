// Pictures of the errors of percepts, with the fitted noise.
#pragma once

#include "robot/fit/ball_noise/ball_places.h"
#include "robot/fit/ball_noise/image_noise.h"
#include "robot/fit/report.h"

namespace robot::fit {

/// Draws the errors of the distance over the distance, with one standard deviation of the fitted tilts and of the tilt
/// `before` [rad].
Picture range_picture(const ImageNoiseFit& fit, const BallPlaces& places, const ImageFacts& facts, double before);

/// Draws the errors of the bearing over the distance, with one standard deviation of the fitted roll and of the roll
/// `before` [rad].
Picture bearing_picture(const ImageNoiseFit& fit, const ImageFacts& facts, double before);

}  // namespace robot::fit
