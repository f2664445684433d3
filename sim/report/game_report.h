// What a game was like, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/contest/series.h"
#include "sim/io/matchup.h"
#include "sim/match/play.h"

namespace sim::report {

using Json = nlohmann::ordered_json;

/// A decision of the referee and when it fell, by the clock that people watch.
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

/// "home 3", "away", …; empty where it is about nobody.
std::string who(const referee::Event& event);
/// "07:31" of 451 s.
std::string clock_text(float seconds);

Json to_json(const GameReport& report, int players);
/// The score, a table of both sides, and what happened when.
std::string to_text(const GameReport& report, const io::Matchup& choice, const Params& params);

/// Several games: means with standard errors.
Json to_json(const std::vector<GameReport>& reports, int players);
std::string to_text(const std::vector<GameReport>& reports, const io::Matchup& choice, const Params& params);

}  // namespace sim::report
