// The trail of one thing through a recording, and its smoothing.
#pragma once

#include <optional>
#include <vector>

#include "robot/truth/tracks/ball_paths.h"
#include "robot/truth/tracks/fused_truth.h"

namespace robot::truth {

/// One image that shows a thing, or comes shortly after one of another sensor that did.
struct Moment {
  std::size_t image = 0;  // index in the recording
  std::uint64_t capture_ns = 0;
  std::uint32_t track = 0;  // the tracker's number for it then; 0: not confirmed yet
  std::optional<Measurement> measurement;
};

/// All moments of one thing, in the order of time. The first one has a measurement.
struct Trail {
  std::uint32_t track = 0;
  std::vector<Moment> moments;
};

/// Returns the estimate of the filter at the last measurement of a robot.
Estimate last_of(const Trail& robot, const std::vector<Sensor>& sensors);

/// Returns the smoothed place at each moment; nothing where the measurement shows something else.
/// Needs 2 kB of memory for each measurement.
std::vector<std::optional<FusedPlace>> smoothed_robot(const Trail& robot, const std::vector<Sensor>& sensors);
std::vector<std::optional<FusedPlace>> smoothed_ball(const Trail& ball, const std::vector<Sensor>& sensors);

/// Returns the most likely event before each measurement of a ball: the whole recording decides, not the past alone.
std::vector<BallEvent> ball_events(const Trail& ball, const std::vector<Sensor>& sensors);

}  // namespace robot::truth
