// The names that define a game, and the game prepared from them.
#pragma once

#include <memory>
#include <string>

#include "robot/core/result.h"
#include "sim/match/params.h"

namespace sim::io {

/// Rules, strategies and models of a game, as typed: each is a name or a path, with changes where they are allowed.
/// Models may differ for single robots (load_team_models in sim/io/models.h).
struct Matchup {
  std::string rules = "spl2012";
  std::string strategies[2] = {"baseline", "baseline"};  // by Side
  std::string models[2] = {"match", "match"};            // by Side
  int players = 0;                                       // per side; 0: by the rules
  Pace pace = Pace::thinned;
};

/// The parameters of a game, with the behaviours that they point to.
struct PreparedGame {
  Params params;
  std::shared_ptr<const agent::Behaviour> behaviours[2];  // by Side
};

/// Loads everything that the matchup names.
robot::Result<PreparedGame> prepare(const Matchup& matchup);

}  // namespace sim::io
