// The game in which a robot plays, prepared for questions about it.
#pragma once

#include <string>
#include <utility>

#include "robot/core/result.h"
#include "robot/foresight/game_setting.h"
#include "robot/memory/channels.h"
#include "sim/io/matchup.h"

namespace robot::app {

/// Rules and models are read again only for another game than the last one. Used by one thread.
class KnownGame {
 public:
  /// `channels` outlive it. `rules` replace those of the simulation or of a real game, unless they are empty.
  KnownGame(const memory::Channels& channels, std::string rules) : channels_(channels), rules_(std::move(rules)) {}

  /// Returns the game of that robot, whose side is home. Its trees are the default ones.
  Result<sim::io::PreparedGame> of(const std::string& robot);

 private:
  const memory::Channels& channels_;
  const std::string rules_;
  foreseeing::GameSetting setting_;  // of `game_`
  sim::io::PreparedGame game_;
};

}  // namespace robot::app
