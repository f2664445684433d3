// The most decisive games of a comparison as recordings, with a page that links to them.
#pragma once

#include <filesystem>

#include "robot/core/result.h"
#include "sim/report/contest_report.h"

namespace sim::app {

/// Returns an Error unless `folder` is missing or empty, so that no earlier game is mixed with the new ones.
robot::Result<void> check_games_folder(const std::filesystem::path& folder);

/// Plays the games that the page of `report` shows, those of the most decisive pairs in which B is at home. Records each in
/// `folder` as seed-N.mcap, and writes the page there as report.html. Returns its path.
robot::Result<std::filesystem::path> save_decisive_games(const report::ContestReport& report,
                                                         const std::filesystem::path& folder);

}  // namespace sim::app
