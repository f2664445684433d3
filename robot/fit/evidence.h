// Recordings of robots beside the ground truth of the same games.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/clocks/data_offset.h"
#include "robot/lab/clocks/truth_record.h"
#include "robot/logging/sessions/session.h"

namespace robot::fit {

/// One recording of ground truth.
struct TrueGame {
  std::string name;  // of its session
  lab::TruthRecord record;
};

/// One robot's recording, and its place in the truth.
struct WatchedRobot {
  std::string name;          // of its session, and its own if that holds several robots
  logging::Session session;  // `info.robot` is this one
  std::shared_ptr<const TrueGame> game;
  lab::Path path;         // of this robot in the truth
  lab::DataOffset clock;  // of its clock to that of the truth; exact if both are in one recording
  std::string clock_by;   // how that was found: lab::TruthOffset::by; empty: both are in one recording

  /// Returns a capture time of the robot by its own clock [s] since the epoch of the truth, for `clock`.
  double own_seconds(std::uint64_t capture_ns) const;
  /// Returns the same moment by the clock of the truth.
  double true_seconds(std::uint64_t capture_ns) const;
};

/// A robot's recording without a place in any truth. It carries what needs no truth: the team's packets.
struct UntrackedRobot {
  std::string name;          // as of a WatchedRobot
  logging::Session session;  // likewise
};

struct Evidence {
  std::vector<std::shared_ptr<const TrueGame>> games;
  std::vector<WatchedRobot> robots;
  std::vector<UntrackedRobot> untracked;  // each has a sentence in `left_out`, too
  std::vector<std::string> left_out;      // one sentence for each robot that cannot be compared with a truth
};

/// Reads recordings of robots and of ground truth, and finds for each robot the truth of its game. That is the truth in its own
/// recording, else one whose times overlap and whose clock can be compared. A recording with its own truth may hold several
/// robots: a simulated game. The robots of one that was recorded without --every-tick are left out. A robot without one is `untracked`, and `left_out` has the reason. Returns an
/// Error if a recording cannot be read, or if `truths` names one without /truth/world. Clocks may differ by at most `most_ns`.
Result<Evidence> gather(const std::vector<std::filesystem::path>& robots,
                        const std::vector<std::filesystem::path>& truths, std::uint64_t most_ns);

}  // namespace robot::fit
