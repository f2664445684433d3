// A simulated game as sessions of several machines: the ground truth by its own clock, each robot by a clock that is ahead.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "proto/foresight/truth.pb.h"
#include "robot/memory/channels.h"

namespace tests {

/// The plan of the sessions.
struct RecordedTruthPlan {
  float from = 0, seconds = 60;                         // [s] of the game
  std::string models = "perfect";                       // of the robots' abilities and perception
  std::map<std::string, double> ahead;                  // [s] the clock of each recorded robot, "14/2"
  std::function<void(foresight::GroundTruth&)> change;  // of the truth before it is recorded; empty: none
};

/// Writes the sessions `folder`/truth and `folder`/14-2 …
void record_game(const std::filesystem::path& folder, const RecordedTruthPlan& plan);

/// Removes the numbers of the robots, and gives them tracks instead.
void leave_tracks(foresight::GroundTruth& truth);

/// Removes the numbers of the robots.
void leave_places(foresight::GroundTruth& truth);

}  // namespace tests
