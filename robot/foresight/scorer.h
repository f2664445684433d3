// Did it come as it was foretold? Compares forecasts with the game as it went on.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
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

/// Hears what is played, forecasts and the game, of a live robot or of a recording. The game comes in the order of its
/// capture times, the others before the game of the moment at which they are due. Where time was moved back, what was
/// open is not scored. Used by one thread.
///
/// Goals are those that the robot was told of, as long as nobody tells how it truly stands.
///
/// A forecast is scored when its time has passed, by what it said of the strategy that was played all that time. One
/// that the end of the game or a change of strategy cut short is not: of those, only goals would count.
class Scorer {
 public:
  /// Robots are told of a goal `goal_delay` [s of game time] after it fell (sim::field::Rules::goal_message_delay).
  explicit Scorer(float goal_delay = 0);

  /// A forecast of the moment `capture_ns` [ns since the epoch]. What cannot be scored is passed over: one that was refused,
  /// one without advice, one that looks to the end of a half or game, and one of another world than the robot's own, that
  /// is of an edited situation, or of others who play anything but kDefaultOpponent.
  void foretell(const pb::Forecast& forecast, std::uint64_t capture_ns);

  /// What the team plays from `capture_ns` on. Until this was told forecasts are taken for those of their first strategy,
  /// and for ever where neither the captain nor people asked but a team's own behaviour: it decides by itself.
  void see(const pb::Strategy& strategy, std::uint64_t capture_ns);

  /// The game at `capture_ns`. True: at least one forecast more was scored.
  bool see(const pb::GameState& game, std::uint64_t capture_ns);

  /// How it truly stands at `capture_ns`, in a simulation that the robot's team plays in. From the first on its goals alone
  /// count, at once when they fall, and what was scored against the robot's memory is forgotten. True as above.
  bool see(const pb::Simulation& simulation, std::uint64_t capture_ns);

  pb::ForecastScore score() const;

 private:
  /// One forecast whose time has not passed.
  struct Open {
    pb::Forecast forecast;
    std::uint64_t asked_ns = 0, due_ns = 0;
    std::uint64_t delay_ns = 0;  // after which a goal is told
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

  struct Event {
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
  std::uint32_t own_team_ = 0;           // 0: no game was seen
  bool by_truth_ = false;                // a simulation was seen
  std::uint32_t tick_ = 0;               // of the simulation
  std::array<std::uint32_t, 2> told_{};  // goals, as last seen: the own team's, the others'
  bool seen_ = false;
  std::uint64_t seen_ns_ = 0;
  std::vector<Goal> goals_;  // of this game
  std::vector<Play> plays_;  // by time, each another strategy than the one before
  std::vector<Open> open_;
  std::map<std::pair<std::string, float>, std::array<Event, 2>> entries_;  // by strategy and horizon: score, concede
};

/// A few lines for people: per strategy and horizon how often it came, all in all and by deciles of what was foretold, the
/// Brier scores and the log-loss; and what tells of the goals. Empty without forecasts.
std::string to_text(const pb::ForecastScore& score);

/// The fields of the message by their names.
nlohmann::json to_json(const pb::ForecastScore& score);

}  // namespace robot::foreseeing
