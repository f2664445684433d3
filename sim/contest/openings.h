// Where games begin: at the kick-off, in a described moment, or in the moments of a folder, evenly.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/referee/event.h"

namespace sim::contest {

/// Any thread.
class Openings {
 public:
  /// `from`: the name of an embedded situation, a file or a folder of them; empty: the kick-off. `fuzz`: each game begins
  /// with everybody a little elsewhere. `params` are of the games: each moment must be possible by their rules.
  static robot::Result<Openings> read(const std::string& from, bool fuzz, const Params& params);

  /// The state in which the game of that seed begins, and what the referee says then.
  State begin(const Params& params, std::uint64_t seed, referee::Events& events) const;
  State begin(const Params& params, std::uint64_t seed) const;

  /// A number for what the descriptions say.
  std::uint64_t content() const;

 private:
  struct Description {
    std::string text, called;
    State state;
  };

  std::vector<Description> descriptions_;  // by name of the file; none: the kick-off
  bool fuzz_ = false;
};

}  // namespace sim::contest
