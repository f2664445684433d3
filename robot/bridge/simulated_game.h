// A simulated game that is stepped tick by tick, with the facts of its last tick that the state does not hold.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "robot/bridge/simulated_vision.h"
#include "robot/bridge/to_messages.h"
#include "sim/agent/choice.h"
#include "sim/agent/trace.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/referee/event.h"
#include "sim/world/world.h"

namespace robot::bridge {

/// The names of a game: its rules and the numbers of its teams.
struct GameNames {
  std::string rules = "spl2012";  // as on the command line
  TeamNumbers teams;
};

/// A game with its decisions and odometry. No clock, no thread: the same state and parameters give the same game.
/// Used by one thread at a time.
class SimulatedGame {
 public:
  /// Starts at `state`. `params` outlive the game.
  SimulatedGame(const sim::Params& params, GameNames names, const sim::State& state);

  /// Continues at another state, with new odometry.
  void begin(const sim::State& state);

  /// A moment of the game between two ticks.
  struct Moment {
    sim::State state;
    std::array<sim::Pose2, sim::kMaxRobots> odometry;
  };
  Moment moment() const { return {.state = state_, .odometry = odometry_}; }
  /// Continues at a moment of this game. The decisions of the tick before it are not known.
  void go_to(const Moment& moment);

  /// Sets the strategy that a robot follows from now on, as its own process has chosen it.
  void follow(int robot, const sim::agent::Choice& choice);

  /// Changes the state between two ticks, for example to place a robot by hand. The odometry goes on.
  template <class Change>
  void change(Change&& change) {
    change(state_);
  }

  /// Plays one tick, 1/30 s, and keeps the decision of each robot. `events` get the referee's decisions.
  /// Not to be called after the end.
  void tick(sim::referee::Events& events);
  bool finished() const;

  const sim::Params& params() const { return params_; }
  const GameNames& names() const { return names_; }
  const sim::State& state() const { return state_; }
  const sim::Team& team_of(int robot) const { return params_.teams[static_cast<int>(sim::side_of(robot))]; }

  /// Returns the last tick's decision of the robot with that index, or null when it made none or its behaviour gives no
  /// reasons.
  const sim::agent::Trace* decision(int robot) const;

  /// Returns the image that the robot took at the begin of the last tick. Without a tick there is none. Costs some microseconds,
  /// which only recordings pay.
  SimulatedImage image(int robot) const { return seen_ ? image_of(params_, *seen_, robot) : SimulatedImage{}; }

  /// Returns the path that the robot believes to have walked since the state was set. It has the errors of the model's
  /// localisation: the robot's scales, and random ones. Places at which the referee puts the robot are no part of it.
  /// Frame: odometry, see proto/foresight/motion.proto.
  const sim::Pose2& odometry(int robot) const { return odometry_[static_cast<std::size_t>(robot)]; }

 private:
  void walk(const sim::World& before, const sim::World& after, int robot);

  const sim::Params& params_;
  const GameNames names_;
  sim::State state_;
  std::array<sim::agent::Trace, sim::kMaxRobots> decisions_;
  std::optional<sim::World> seen_;  // at the begin of the last tick
  std::array<sim::Pose2, sim::kMaxRobots> odometry_;
};

}  // namespace robot::bridge
