// The start of games: the kick-off, one situation, or the situations of a folder in turn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/referee/event.h"

namespace sim::contest {

/// The start of one game.
struct Start {
  std::uint64_t seed = 0;
  std::uint64_t moment = 0;  // number that takes the situations of a folder in turn
  bool turned = false;       // each side has the other's moment, see io::parse_situation; without effect on a kick-off
};

/// The situations in which games begin. Thread-safe.
class Openings {
 public:
  /// Reads `from`: the name of an embedded situation, a file, a folder of files, or empty for the kick-off. With `fuzz`
  /// each game begins with slightly shifted robots and ball. Each situation must be possible by the rules in `params`.
  static robot::Result<Openings> read(const std::string& from, bool fuzz, const Params& params);

  /// Returns the state in which the game begins, and fills `events` with the referee's first decisions.
  State begin(const Params& params, const Start& start, referee::Events& events) const;
  /// Begins the game with this seed, which is also the number of its moment.
  State begin(const Params& params, std::uint64_t seed, referee::Events& events) const;
  State begin(const Params& params, std::uint64_t seed) const;

  /// Returns a hash of the descriptions.
  std::uint64_t content() const;

 private:
  struct Description {
    std::string text, called;
    State state, turned;
  };

  std::vector<Description> descriptions_;  // ordered by file name; empty: the kick-off
  bool fuzz_ = false;
};

}  // namespace sim::contest
