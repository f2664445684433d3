// The simulator's localisation on recorded walks: the errors that it would leave.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/fit/localisation/pose_errors.h"
#include "robot/fit/localisation/watched_motion.h"
#include "sim/field/field.h"
#include "sim/match/params.h"
#include "sim/math/vec2.h"

namespace robot::fit {

/// One moment of a walk, at the time of a believed pose.
struct MarkMoment {
  double at = 0;              // [s, clock of the truth]
  sim::Pose2 pose;            // [field] true, smoothed
  float way = 0, turned = 0;  // [m], [rad] since the moment before, by the robot's speeds
  float yaw = 0;              // [rad] of the head
  float upper_edge = 0;       // [rad] of the image below the horizon
  bool upright = true;
  bool falls = false;      // since the moment before
  bool enters = false;     // likewise, or there was a gap
  bool counts = false;     // its error is compared
  double square = 0;       // [m²] of the recorded error, at most kMostPlace² beside the noise of the truth
  double square_turn = 0;  // [rad²] likewise
};

/// The walk of one robot.
struct MarkWalk {
  std::vector<MarkMoment> moments;
  float scale = 1, turn_scale = 1;  // of its odometry
  bool knows_head = false;          // else it looks ahead
};

/// Mean squares of errors.
struct MarkErrors {
  double place = 0;    // [m²] of the distance
  double heading = 0;  // [rad²]
  std::size_t moments = 0;
  std::array<double, 40> histogram{};  // of the distance in bins of kMarkBin, shares
};

inline constexpr double kMarkBin = 0.02;                  // [m]
inline constexpr double kMostPlace = 1, kMostTurn = 0.6;  // [m], [rad] greater errors count as these
inline constexpr double kSettled = 5;                     // [s] after a fall or an entrance errors count

/// Returns the walk of a robot, in its team's frame, with the errors that it recorded. Without motion_status it is empty.
MarkWalk mark_walk(const WatchedMotion& motion, const std::vector<PoseError>& errors, const TruthNoise& noise);

/// Returns the errors that were recorded.
MarkErrors recorded_errors(const std::vector<MarkWalk>& walks);

/// The squared errors of one moment.
struct MarkSquares {
  double place = 0, heading = 0;  // [m²], [rad²]
};

/// Plays the simulator's localisation on the walks and returns its errors. The same seed gives the same luck. `seen`, if it is
/// not null, receives the squares of each moment that counts, in their order.
MarkErrors simulated_errors(const std::vector<MarkWalk>& walks, const sim::Models& models,
                            const sim::field::Field& field, std::uint64_t seed,
                            std::vector<MarkSquares>* seen = nullptr);

}  // namespace robot::fit
