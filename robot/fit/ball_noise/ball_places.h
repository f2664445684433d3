// The places where robots saw and believed the ball, beside its true place.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "robot/fit/ball_noise/seen_balls.h"
#include "robot/fit/evidence.h"
#include "robot/fit/math/resampling.h"

namespace robot::fit {

/// The ball in one image, or as it was believed after one.
struct BallPlace {
  std::size_t recording = 0;                   // index of the robot's recording
  double at = 0;                               // [s] by the clock of the truth, since its epoch
  Gait gait = Gait::unknown;                   // of a percept
  double seen_distance = 0, seen_bearing = 0;  // [m], [rad, robot]
  double distance = 0;                         // [m] true
  double bearing = 0;                          // [rad, robot] true; NaN where the truth has no heading
  double away = 0, across = 0;  // [m/s] velocity of the ball over ground: along the line of sight, and to its left
  double acceleration = 0;      // [m/s²] of the ball, its length
  double distance_rate = 0, bearing_rate = 0;  // [m/s], [rad/s] by the motion of ball and robot
  double deviation = 0;                        // [m] of the true place of the ball relative to the robot, each axis
  double heading_deviation = 0;  // [rad] of the robot's true heading, as far as it differs from image to image
  double speed_deviation = 0;    // [m/s] of the ball's velocity, each axis
  double clock_deviation = 0;    // [s] of the robot's clock

  double speed() const { return std::hypot(away, across); }  // [m/s] of the ball
};

/// One recording of a robot.
struct BallRecording {
  std::string name;
  std::string clock;              // recordings of one clock have the same text; empty: that of the truth
  bool clock_by_ball = false;     // its offset was found from the motion of the ball, which hides a lag of the percepts
  double heading_scatter = 0;     // [rad] of the true headings, from place to place
  std::optional<double> writing;  // [s] as SeenBalls::writing
  bool has_gait = false;
};

struct BallPlaces {
  std::vector<BallPlace> percepts, beliefs;  // ordered by recording and time
  std::vector<BallRecording> recordings;
  std::size_t without_truth = 0;  // percepts while the truth did not see the ball or the robot
  std::size_t damaged = 0;        // percepts and beliefs with numbers that cannot be
  std::size_t headless = 0;       // percepts while the truth had no heading
};

/// Puts the balls of some robots beside their true places.
BallPlaces beside_truth(const std::vector<SeenBalls>& robots);
/// Reads the recordings of all robots, and does so.
BallPlaces read_ball_places(const Evidence& evidence);

/// Returns the passes of some places: those of one recording without a pause of half a second, at most two seconds
/// long. If there are more than `most`, successive ones of a recording are joined.
std::vector<Group> passes_of(const std::vector<BallPlace>& places, const std::vector<std::size_t>& chosen,
                             std::size_t most = 1000);

}  // namespace robot::fit
