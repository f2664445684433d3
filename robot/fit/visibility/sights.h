// Which percept is the ball, and in which images it should have been seen. Pure.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/fit/math/resampling.h"
#include "robot/fit/visibility/looks.h"

namespace robot::fit {

/// The errors of percepts [rad], one standard deviation, by those of the images themselves. They include the error of the truth's
/// heading, but not that of its places.
struct SightNoise {
  std::vector<double> bearing;       // of each recording
  double standing = 0, walking = 0;  // of the elevation
};

/// Measures the errors by the percepts of balls in view; they are medians, so false balls hardly count. Those of the bearing are never
/// smaller than the model's. With fewer than 30 percepts they are the model's, and that of a heading with 3°.
SightNoise noise_of(const Looks& looks, const sim::Models& base);

/// The places of percepts that are taken for the ball: those within five standard deviations or half a metre.
struct SightCounts {
  double nearest = 0, farthest = 0;  // [m] from the robot
  double bearing = 0, reach = 0;     // [rad] the middle, and the way to either side

  bool contain(double x, double y) const;
};

SightCounts ball_places(const Look& look, const SightNoise& noise);

/// Reports whether the ball in this image is the true one.
bool is_true_ball(const Look& look, const SightNoise& noise);

/// An image that should show the ball, seen or not.
struct Sight {
  std::size_t recording = 0;
  double at = 0;          // [s] as Look::at
  double distance = 0;    // [m] true
  double off_axis = 0;    // [rad] of the bearing, without a sign
  double head_speed = 0;  // [rad/s]
  bool hidden = false;
  bool seen = false;
  double plausible = 1;  // probability that noise puts a detected ball neither above the horizon nor too far away
};

struct Sights {
  std::vector<Sight> sights;            // ordered by recording and time
  std::vector<std::string> recordings;  // names, by index
  double error = 0;                     // [m] of the true distance, one standard deviation
  std::size_t near_border = 0;          // left out: the ball is in view, but by less than the error of the truth
  std::size_t unsure = 0;               // left out: hidden or not, by the errors of the truth
};

/// Returns the images in which the ball is in view by more than its radius and three standard deviations.
Sights sights_of(const Looks& looks, const sim::Models& base);

/// Returns the passes: images of one recording without a pause of half a second, at most two seconds long.
std::vector<Group> passes_of(const std::vector<Sight>& sights);

}  // namespace robot::fit
