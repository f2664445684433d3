// The report of a game, as text and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/contest/series.h"
#include "sim/io/matchup.h"
#include "sim/match/play.h"
#include "sim/match/shoot_out.h"

namespace sim::report {

using Json = nlohmann::ordered_json;

/// A decision of the referee and its time on the game clock.
struct Decision {
  referee::Event event;
  int half;
  float clock;   // [s] since the start of the half, without stopped time
  int score[2];  // after it
};

struct GameReport {
  std::uint64_t seed = 0;
  std::uint64_t hash = 0;  // of the game (hash_of_game): games with the same hash are the same game
  Result result{};
  std::vector<Decision> decisions;
  std::optional<ShootOut> shoot_out;  // after a draw, if one was asked for
};

/// Returns "home 3", "away", …, or an empty string for an event of no side.
std::string who(const referee::Event& event);
/// Returns "07:31" for 451 s.
std::string clock_text(float seconds);

Json to_json(const GameReport& report, int players);
/// Returns the score, a table of both sides, and the list of events.
std::string to_text(const GameReport& report, const io::Matchup& choice, const Params& params);

/// Returns the number of different games among the reports.
std::int64_t different_games(const std::vector<GameReport>& reports);

/// Return the means of several games with their standard errors.
Json to_json(const std::vector<GameReport>& reports, int players);
std::string to_text(const std::vector<GameReport>& reports, const io::Matchup& choice, const Params& params);

}  // namespace sim::report
