// Compares forecasts with the later course of the game.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "proto/foresight/forecast.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/sim.pb.h"
#include "proto/foresight/strategy.pb.h"
#include "sim/foresight/reliability.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// The score of forecasts of a live robot or a recording. It needs strategies, forecasts and the game. The game comes
/// in the order of capture times, the others before the game of the moment at which they are due. Open forecasts are
/// not scored after time was moved back. Used by one thread.
///
/// Goals are those reported to the robot, until the true score of a simulation is known.
///
/// A forecast is scored when its time has passed, by its statement about the strategy that was played all that time. A
/// forecast cut short by the end of the game or a change of strategy is not scored: of those, only goals would count.
class Scorer {
 public:
  /// `goal_delay` [s of game time] is the delay between a goal and its report (sim::field::Rules::goal_message_delay).
  explicit Scorer(float goal_delay = 0);

  /// Adds a forecast of the moment `capture_ns` [ns since the epoch]. It ignores forecasts that cannot be scored:
  /// refused ones, those without advice, and those up to the end of a half or game. It also ignores those of an edited
  /// situation and those against another opponent than kDefaultOpponent.
  void foretell(const pb::Forecast& forecast, std::uint64_t capture_ns);

  /// Sets the team's strategy from `capture_ns` on. Before the first call a forecast counts for its first strategy. A
  /// forecast that a team's own behaviour asked for always does, because that behaviour decides by itself.
  void see(const pb::Strategy& strategy, std::uint64_t capture_ns);

  /// Adds the game at `capture_ns`. Returns true if at least one more forecast was scored.
  bool see(const pb::GameState& game, std::uint64_t capture_ns);

  /// Adds the true score at `capture_ns` of a simulation in which the robot's team plays. From the first call on only
  /// its goals count, without delay, and scores against the robot's memory are dropped. Returns the same as above.
  bool see(const pb::Simulation& simulation, std::uint64_t capture_ns);

  pb::ForecastScore score() const;

 private:
  /// One forecast whose time has not passed.
  struct Open {
    pb::Forecast forecast;
    std::uint64_t asked_ns = 0, due_ns = 0;
    std::uint64_t delay_ns = 0;  // between a goal and its report
    bool by_behaviour = false;
  };
  struct Goal {
    bool own = false;
    std::uint64_t told_ns = 0;
  };
  struct Play {
    std::string strategy;
    std::uint64_t from_ns = 0;
  };

  struct EventScore {
    sim::foresight::Reliability reliability;
    double log_loss = 0;  // [nats] sum

    void add(double foretold, bool came, std::uint64_t rollouts);
    void fill(pb::ForecastScore::Event& message) const;
  };

  bool see_goals(std::uint32_t own, std::uint32_t opponent, std::uint64_t capture_ns);
  void forget_open() { open_.clear(), goals_.clear(); }
  void count(std::uint32_t goals, bool own, std::uint64_t told_ns);
  const std::string* played(const Open& open) const;
  bool enter(const Open& open);

  const float goal_delay_;
  std::uint32_t own_team_ = 0;           // 0: no game yet
  bool by_truth_ = false;                // a simulation is known
  std::uint32_t tick_ = 0;               // of the simulation
  std::array<std::uint32_t, 2> told_{};  // last known goals: own, opponents'
  bool seen_ = false;
  std::uint64_t seen_ns_ = 0;
  std::vector<Goal> goals_;  // of this game
  std::vector<Play> plays_;  // by time; each differs from the one before
  std::vector<Open> open_;
  // by strategy and horizon: score, concede
  std::map<std::pair<std::string, float>, std::array<EventScore, 2>> entries_;
};

/// Returns a few lines for people, empty without forecasts. Per strategy and horizon they have the observed frequency
/// (in total and by deciles of the forecast), the Brier scores and the log-loss. The last
/// one names the source of the goals.
std::string to_text(const pb::ForecastScore& score);

/// Returns the fields of the message by their names.
nlohmann::json to_json(const pb::ForecastScore& score);

}  // namespace robot::foreseeing
