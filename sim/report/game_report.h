// The report of a game as text and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/contest/series.h"
#include "sim/io/matchup.h"
#include "sim/match/play.h"

namespace sim::report {

using Json = nlohmann::ordered_json;

/// A decision of the referee and its time on the match clock.
struct Decision {
  referee::Event event;
  int half;
  float clock;   // [s] of the half that had run
  int score[2];  // after it
};

struct GameReport {
  std::uint64_t seed = 0;
  Result result{};
  std::vector<Decision> decisions;
};

/// Returns the robot or side of the event, such as "home 3" or "away", or an empty string.
std::string who(const referee::Event& event);
/// Returns "07:31" for 451 s.
std::string clock_text(float seconds);

Json to_json(const GameReport& report, int players);
/// Returns the score, a table of both sides, and the events with their times.
std::string to_text(const GameReport& report, const io::Matchup& choice, const Params& params);

/// Return means with standard errors of several games.
Json to_json(const std::vector<GameReport>& reports, int players);
std::string to_text(const std::vector<GameReport>& reports, const io::Matchup& choice, const Params& params);

}  // namespace sim::report
