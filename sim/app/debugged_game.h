// The game of the commands that look into decisions, from one start.
#pragma once

#include <cstdint>
#include <string>

#include "sim/app/commands.h"
#include "sim/contest/openings.h"
#include "sim/debug/setup.h"
#include "sim/io/situation.h"

namespace sim::app {

/// The team numbers in the names of robots, unless the user says otherwise.
inline constexpr io::SituationTeams kUsualTeams{.home = 14, .away = 5};

/// A game that is ready to begin.
struct DebuggedGame {
  debug::SharedSetup setup;
  contest::Openings openings;

  const Params& params() const { return setup->params; }
};

/// The options that choose it: those of ChoiceOptions, --seed and --from.
class DebuggedGameOptions {
 public:
  void add_to(CLI::App& command);
  robot::Result<DebuggedGame> prepare() const;
  /// Prepares a game in which trees play both sides.
  robot::Result<DebuggedGame> prepare_trees() const;

  std::uint64_t seed() const { return seed_; }
  io::Matchup choice() const { return choice_.choice(); }

 private:
  ChoiceOptions choice_;
  std::uint64_t seed_ = 1;
  std::string from_;
};

/// Adds --seconds, the length of a game [s]. 0: to its end.
void add_length(CLI::App& command, double& seconds);
/// Returns that length.
constexpr Tick length_of(double seconds) { return seconds > 0 ? ticks(static_cast<float>(seconds)) : kNever; }

}  // namespace sim::app
