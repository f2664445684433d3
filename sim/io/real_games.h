// Figures of real games, as JSON: {"name", "about", "figures": {"kicks": {"mean", "low", "high", "unit", "source"}, …}}.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/statistics/figures.h"

namespace sim::io {

/// A figure of real games.
struct RealFigure {
  /// The interval in which the mean of many games lies.
  struct Interval {
    double low, high;
  };

  std::string key, unit, about;
  double mean = 0;
  std::optional<Interval> interval;  // absent: not known
  std::string source;
};

/// All figures of statistics::Figures, in its order.
struct RealGames {
  std::string name, about;
  std::vector<RealFigure> figures;
};

/// Reads a description. An Error names a figure that is missing or unknown, a wrong unit, and an interval without the mean.
robot::Result<RealGames> parse_real_games(std::string_view text, const std::string& called);

/// Loads the description of that name, or in that file.
robot::Result<RealGames> load_real_games(const std::string& name);

/// The games of RoboCup 2019 in this program.
inline constexpr const char* kNewestRealGames = "robocup2019";

}  // namespace sim::io
