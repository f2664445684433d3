// foresight-sim match --statistics: are simulated games like real ones?
#pragma once

#include <string>

#include "sim/contest/lineup.h"
#include "sim/contest/openings.h"

namespace sim::app {

/// The games to be measured.
struct StatisticsTask {
  std::uint64_t seed = 1;  // of the first game
  int games = 1, threads = 1;
  float seconds = 0;        // [s] longest game; 0: no limit
  std::string real;         // name or file of the real games
  std::string html;         // file of the page; empty: none
  bool json = false;        // report as JSON
  io::Matchup choice = {};  // the game as typed, for sentences
};

/// Plays the games and prints their figures beside those of real games. Returns the exit status.
int run_statistics(const StatisticsTask& task, const contest::Lineup& lineup, const contest::Openings& openings);

}  // namespace sim::app
