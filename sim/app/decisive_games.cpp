#include "sim/app/decisive_games.h"

#include <string>
#include <system_error>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "sim/app/played_game.h"
#include "sim/report/contest_page.h"

namespace sim::app {
namespace {

namespace fs = std::filesystem;
using robot::Error;
using robot::Result;

/// Plays and records the game of a pair in which B is at home.
Result<void> record(const contest::Comparison& comparison, std::uint64_t seed, const fs::path& file) {
  const contest::Cast cast(comparison.lineup_of_b(), seed);
  Recording recording{.path = file.string(), .names = {.rules = comparison.choice().rules, .teams = {}}};
  const GameWish wish{.seed = seed, .seconds = static_cast<float>(comparison.choice().seconds)};
  if (const auto played = play_one(cast, comparison.openings_of_b(), wish, &recording, nullptr); !played)
    return played.failure();
  return {};
}

}  // namespace

Result<void> check_games_folder(const fs::path& folder) {
  std::error_code failed;
  if (!fs::exists(folder, failed)) return {};
  if (fs::is_directory(folder, failed) && fs::is_empty(folder, failed)) return {};
  return Error{"--games-to: expected a new or an empty folder, got " + folder.string()};
}

Result<fs::path> save_decisive_games(const report::ContestReport& report, const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return Error{"--games-to: cannot make the folder " + folder.string() + ": " + failed.message()};
  report::Json json = report::to_whole_json(report);
  for (report::Json* pair : report::shown_pairs(json)) {
    const std::uint64_t seed = report.comparison.seed_of(pair->at("pair").get<std::int64_t>());
    const std::string name = "seed-" + std::to_string(seed) + ".mcap";
    if (const Result<void> recorded = record(report.comparison, seed, folder / name); !recorded)
      return recorded.failure("--games-to");
    (*pair)["game"] = name;
  }
  const fs::path page = folder / "report.html";
  if (const Result<void> written = robot::replace_file(page, report::page_of(json)); !written)
    return written.failure("--games-to");
  return page;
}

}  // namespace sim::app
