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
#include "sim/foresight/reliability.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// Hears forecasts and the game in the order of their capture times, of a live robot or of a recording. Used by one thread.
class Scorer {
 public:
  /// A forecast of the moment `capture_ns` [ns since the epoch]. What cannot be scored is passed over: an edited
  /// situation, one that was refused, and one that looks to the end of a half or game.
  void foretell(const pb::Forecast& forecast, std::uint64_t capture_ns);

  /// The game at `capture_ns`. True: at least one forecast more was scored.
  bool see(const pb::GameState& game, std::uint64_t capture_ns);

  pb::ForecastScore score() const;

 private:
  /// One forecast whose time has not passed.
  struct Open {
    std::string strategy;
    float horizon = 0;  // [s]
    std::uint64_t due_ns = 0;
    std::uint64_t rollouts = 0;
    double score = 0, concede = 0;      // [0..1] as foretold
    std::uint32_t own = 0, others = 0;  // goals when it was made
    int next = 0;                       // whose the next goal was: 1 the own team's, -1 the others', 0 nobody's yet
  };

  struct Event {
    sim::foresight::Reliability reliability;
    double log_loss = 0;  // [nats] sum

    void add(double foretold, bool came, std::uint64_t rollouts);
    void fill(pb::ForecastScore::Event& message) const;
  };

  std::uint32_t own_ = 0, others_ = 0;  // goals, as last seen
  bool seen_ = false;
  std::vector<Open> open_;
  std::map<std::pair<std::string, float>, std::array<Event, 2>> entries_;  // by strategy and horizon: score, concede
};

/// A few lines for people: per strategy and horizon how often it came, and the Brier scores. Empty without forecasts.
std::string to_text(const pb::ForecastScore& score);

/// The fields of the message by their names.
nlohmann::json to_json(const pb::ForecastScore& score);

}  // namespace robot::foreseeing
