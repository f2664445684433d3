// A simulated game and what one needs beside its state to tell of it.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "robot/agent/convert.h"
#include "sim/agent/choice.h"
#include "sim/agent/trace.h"
#include "sim/io/matchup.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/math/vec2.h"
#include "sim/world/world.h"

namespace robot::body {

/// What games are played with; the same for all games of one run.
struct Setup {
  sim::io::PreparedGame game;
  std::string rules;  // as they were named, e.g. "spl2012"
  agent::TeamNumbers teams;

  const sim::Params& params() const { return game.params; }
  const sim::Team& team_of(int robot) const { return game.params.teams[static_cast<int>(sim::side_of(robot))]; }
};

/// One game after the other. No clock, no thread: the same seed gives the same game. Used by one thread at a time.
class Game {
 public:
  /// At the beginning of the game of `seed`.
  Game(Setup setup, std::uint64_t seed);

  /// Another game, from its beginning or from a situation in the middle.
  void begin(std::uint64_t seed);
  void begin(const sim::State& situation);

  /// What a robot follows of its team's strategies from now on, as its own process has it.
  void follow(int robot, const sim::agent::Choice& choice);

  /// One tick, 1/30 s; explains the decision of every robot. Not after the end.
  void tick();
  bool finished() const;

  const Setup& setup() const { return setup_; }
  const sim::State& state() const { return state_; }

  /// Why the robot with that index decided so in the last tick; nullptr: it has not, or its behaviour does not explain.
  const sim::agent::Trace* decision(int robot) const;

  /// How far that robot believes to have walked since the game began. Frame: odometry, see proto/foresight/motion.proto.
  const sim::Pose2& odometry(int robot) const { return odometry_[static_cast<std::size_t>(robot)]; }

 private:
  void walk(int robot);

  const Setup setup_;
  sim::State state_;
  std::array<sim::agent::Trace, sim::kMaxRobots> decisions_;
  std::array<sim::Pose2, sim::kMaxRobots> odometry_;
};

}  // namespace robot::body
