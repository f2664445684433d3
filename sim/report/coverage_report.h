// The coverage of a tree by many games, as a table, as JSON and as a page: the tree as a heat map.
#pragma once

#include <string>

#include "sim/debug/coverage.h"
#include "sim/report/game_report.h"

namespace sim::report {

/// The games that were watched.
struct CoverageReport {
  const debug::Parts& parts;
  const debug::Coverage& coverage;
  std::string about;  // "of the home side against press, 200 games from seed 1"

  /// Returns the share of the time in play that the robots spent in a part [0 .. 1].
  double time_share(std::size_t part) const;
  /// Returns the parts without a decision, none of which lies in another one that has none.
  std::vector<std::size_t> never_reached() const;
  /// Returns the numbers of the comparisons that were asked and always gave the same answer.
  std::vector<std::size_t> always_same() const;
};

std::string to_text(const CoverageReport& report);
Json to_json(const CoverageReport& report);
/// Returns a single HTML file without scripts, which needs no other file.
std::string page_of(const CoverageReport& report);

}  // namespace sim::report
