// Figures of games beside those of real ones: the table, the JSON and the page.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/contest/series.h"
#include "sim/io/real_games.h"

namespace sim::report {

using Json = nlohmann::ordered_json;

/// One figure of real games and of measured ones.
struct RealismRow {
  io::RealFigure real;
  contest::Mean measured;
  std::size_t windows = 0;     // in which the figure was measured
  std::optional<bool> inside;  // the mean lies in the real interval; absent: one of the two is not known
};

struct Realism {
  std::string name;         // of the real games
  std::string measured;     // the measured games: "simulated" or "recorded"
  std::size_t windows = 0;  // measured
  std::vector<RealismRow> rows;

  /// Returns the number of figures that lie inside, and of those that can be judged.
  std::size_t inside() const;
  std::size_t judged() const;
};

/// Compares the figures of windows with those of real games.
Realism realism_of(const std::vector<statistics::Figures>& windows, const io::RealGames& real, std::string measured);

Json to_json(const Realism& realism);
/// Returns a table with a line for each figure, and the number of figures inside.
std::string to_text(const Realism& realism);
/// Returns the page: a row for each figure, with the real interval as a bar and the measured mean as a dot. `about` says
/// which games were measured.
std::string page_of(const Realism& realism, const std::string& about);

}  // namespace sim::report
