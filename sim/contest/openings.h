// The start of games: the kick-off, a described moment, or the moments of a folder in turn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/referee/event.h"

namespace sim::contest {

/// The starts of a run's games. Any thread.
class Openings {
 public:
  /// Reads the starts. `from` names an embedded situation, a file or a folder of files; empty means the kick-off. With `fuzz`
  /// each game begins with slightly other places. Each moment must be possible by the rules in `params`.
  static robot::Result<Openings> read(const std::string& from, bool fuzz, const Params& params);

  /// Returns the first state of the game with that seed, and the referee's events.
  State begin(const Params& params, std::uint64_t seed, referee::Events& events) const;
  State begin(const Params& params, std::uint64_t seed) const;

  /// Returns a hash of the descriptions.
  std::uint64_t content() const;

 private:
  struct Start {
    std::string text, called;
    State state;
  };

  std::vector<Start> starts_;  // by file name; empty: the kick-off
  bool fuzz_ = false;
};

}  // namespace sim::contest
