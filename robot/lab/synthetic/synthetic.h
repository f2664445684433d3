// A small synthetic recording, for demonstrations and tests without real data.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"
#include "robot/lab/synthetic/synthetic_messages.h"

namespace robot::lab {

/// Robot 14/2, which walks, looks around, shoots and scores. synthetic_world.h describes its story of 20 s.
/// Every message is a function of its time, so the same options produce the same bytes, as a whole or in parts.
///
/// 100 Hz: joints, inertial, fsr, touch, odometry, motion_status. 33 Hz: vision, ball, pose, decision, motion_command.
/// 17 Hz: camera_top (YUYV, drawn) with camera_top_matrix. 10 Hz: /truth/world. 2 Hz: game. 1 Hz: battery, team.
/// At each event: log.
class SyntheticRobot {
 public:
  struct Options {
    double seconds = 20;                              // [s] 0 .. 600; after 20 s everything stands still
    std::uint64_t seed = 1;                           // of the noise
    std::uint64_t epoch_ns = 1795269600'000'000'000;  // [ns since the epoch] of the start: 2026-11-21 14:00 UTC
    int image_width = 320;                            // [px] even, 64 .. 640; the height is three quarters of it
  };

  explicit SyntheticRobot(const Options& options);
  SyntheticRobot() : SyntheticRobot(Options()) {}

  /// Passes all messages to `sink`, ordered by time. Returns the Error of the sink, if any.
  Result<ImportReport> write(ImportSink& sink) const;

  /// Passes the messages with from <= time < to, [s] since the start.
  Result<ImportReport> write(double from, double to, ImportSink& sink) const;

 private:
  Options options_;
  synthetic::Noise noise_;
  std::vector<synthetic::Sight> sights_;  // one per image searched
};

}  // namespace robot::lab
