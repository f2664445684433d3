// All that a game needs, by name: rules, two strategies, two models.
#pragma once

#include <memory>
#include <string>

#include "robot/core/result.h"
#include "sim/match/params.h"

namespace sim::io {

/// As one types it; each may be a name, a path, and where that is allowed a variation.
struct Matchup {
  std::string rules = "spl2012";
  std::string strategies[2] = {"baseline", "baseline"};  // by Side
  std::string models[2] = {"match", "match"};            // by Side
  int players = 0;                                       // a side; 0: as the rules say
  Pace pace = Pace::thinned;
};

/// The parameters, and the behaviours that they point to.
struct PreparedGame {
  Params params;
  std::shared_ptr<const agent::Behaviour> behaviours[2];  // by Side
};

robot::Result<PreparedGame> prepare(const Matchup& matchup);

}  // namespace sim::io
