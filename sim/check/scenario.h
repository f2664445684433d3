// Situations that are tests of a behaviour: a situation (sim/io/situation.h) with the object "check".
//
//   "check": {
//     "home": "baseline", "away": "baseline",
//     "rules": "spl2012", "models": "match", "players": 4,
//
//     "seconds": 20, "seeds": 100, "fuzz": false,
//     "events": ["at 5 s: penalise home/3", "at 8 s: ball at 1.2 m, 0.5 m"],
//
//     "metrics": { "two touches": "our touch then our touch within 5 s", "first shot": "time of our shot" },
//     "expect": { "two touches": { "at_least": 0.6 } }
//   }
//
// The behaviour of "home" is tested. "seconds" is the longest game [s], "seeds" the number of games, and "fuzz" shifts
// robots and ball a little in each. Everything but "metrics" may be missing. The values above are the defaults, except
// those of "players" (by the rules), events and limits. Metrics are described in measure.h. Other commands ignore
// "check".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/check/event.h"
#include "sim/check/measure.h"
#include "sim/contest/lineup.h"
#include "sim/contest/openings.h"

namespace sim::check {

/// A metric, and the limits of its mean.
struct NamedMetric {
  std::string name;
  std::string text;  // as written
  Metric metric;
  std::optional<double> at_least = {}, at_most = {};
};

/// A prepared situation. Any thread may play it.
struct Scenario {
  std::string name;  // of the file, without the folder
  std::string about;
  io::Matchup game;
  double seconds = 20;
  int seeds = 100;
  std::vector<Event> events;  // by time
  std::vector<NamedMetric> metrics;
  std::optional<contest::Lineup> lineup;
  std::optional<contest::Openings> openings;
};

/// Values of the command line that replace those of the file.
struct Overrides {
  std::string home, away;  // empty: by the file
  int seeds = 0;           // 0: by the file
};

/// Loads the situation at that path.
robot::Result<Scenario> load_scenario(const std::string& path, const Overrides& overrides);

/// Loads all situations below the folder, by name; or one file. Each must have "check".
robot::Result<std::vector<Scenario>> load_scenarios(const std::string& path, const Overrides& overrides);

}  // namespace sim::check
