// A simulated game as evidence for fits: every robot with its recording, beside a truth that may have errors.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "robot/fit/evidence.h"
#include "sim/match/params.h"

namespace robot::tests {

struct SimulatedPlan {
  std::string rules = "spl2025";
  std::string strategy = "baseline";  // of both sides
  int players = 5;                    // a side
  std::string models = "match";       // of all robots, with changes: "match,walk.forward=0.3" (sim/io/models.h)
  double seconds = 300;               // of game, with dead time
  std::uint64_t seed = 1;
  sim::Pace pace = sim::Pace::every_tick;
  // the truth's errors, one standard deviation each
  double place_error = 0;    // [m] of each place and each axis
  double heading_error = 0;  // [rad] of each heading
  double clock_error = 0;    // [s] of its clock in the whole game
};

/// Plays the game, records it to the new folder `folder`, and gathers the recording. The
/// times of the truth are shifted by a random offset that the evidence does not know; it knows the deviation of it.
fit::Evidence simulated_robots(const std::filesystem::path& folder, const SimulatedPlan& plan);

/// Adds the evidence of another game.
void append(fit::Evidence& evidence, fit::Evidence other);

}  // namespace robot::tests
