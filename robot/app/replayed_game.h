// A recorded simulated game, played again from its seed.
#pragma once

#include <optional>
#include <string>

#include "proto/foresight/sim.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/app/recalled_decision.h"
#include "sim/debug/timeline.h"
#include "sim/io/situation.h"

namespace robot::app {

/// Keeps the last game, so that its other moments come at once. Used by one thread.
class ReplayedGame {
 public:
  struct Moment {
    sim::debug::SharedSetup setup;
    sim::State state;
    sim::io::SituationTeams teams;
  };

  /// Returns the game at the tick of `recorded`, agents' memories included. Returns nothing unless the places that it then
  /// has are those of `truth`, to the bit. So there is no answer for a game that did not begin with the kick-off, was
  /// edited, followed its captain to another strategy, or was recorded by another version. Names are never read as paths.
  std::optional<Moment> at(const foresight::Simulation& recorded, const foresight::GroundTruth& truth,
                           KnownTrees& trees);

 private:
  void begin(const foresight::Simulation& recorded, KnownTrees& trees);

  std::string played_;                            // rules, trees, models and seed of the games below
  std::optional<sim::debug::Timeline> games_[2];  // by sim::Pace
};

}  // namespace robot::app
