// foresight-lab smooth: the ground truth of a recording once more, now that the future is known too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/result.h"

namespace robot::app {

/// The options of foresight-lab smooth.
struct SmoothOptions {
  std::filesystem::path truth;                // a recording of foresight-lab truth
  std::vector<std::filesystem::path> robots;  // recordings of robots of the same game, which say who is who
  std::filesystem::path session;              // folder that is created; empty: that of the truth with "_smoothed"
  double max_clock_offset = 60;               // [s] greatest accepted offset of a robot's clock
};

/// One recorded robot of a smoothed truth.
struct NamedRobot {
  std::string robot;        // "14/2"
  std::string clock;        // "0.350 s ahead (± 0.4 ms), by the ball, …"
  std::string refused;      // the reason why its poses could not be used, or empty
  std::size_t moments = 0;  // of the truth that have this robot
};

struct Smoothed {
  std::filesystem::path session;
  std::size_t sensors = 0, images = 0, moments = 0;
  std::size_t left_out = 0;         // images from before the last calibration of their sensor
  std::size_t unnamed_moments = 0;  // robots without a player, counted once in each moment
  std::vector<NamedRobot> robots;
};

/// Writes a copy of the truth's recording whose /truth/world is smoothed (robot/truth/tracks/smoother.h). The robots' poses
/// are used at the truth's times, by the offset of their clocks as foresight-lab info finds it. A robot whose clock or place
/// is not known is named with the reason; the others count. Returns an Error without detections of calibrated sensors.
/// After an Error there is no copy.
Result<Smoothed> smooth_session(const SmoothOptions& options);

/// Formats the result for a terminal.
std::string to_text(const Smoothed& smoothed);

}  // namespace robot::app
