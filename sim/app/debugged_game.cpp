#include "sim/app/debugged_game.h"

namespace sim::app {

void DebuggedGameOptions::add_to(CLI::App& command) {
  choice_.add_to(command);
  command.add_option("--seed", seed_, "seed of the game, or of the first one")
      ->check(CLI::Range(std::uint64_t{0}, kMostSeed))
      ->capture_default_str();
  command.add_option("--from", from_, "start of the game: name or file of a described moment");
}

robot::Result<DebuggedGame> DebuggedGameOptions::prepare() const {
  auto setup = debug::prepare(choice_.lineup_choice());
  if (!setup) return setup.failure();
  auto openings = contest::Openings::read(from_, false, (*setup)->params);
  if (!openings) return openings.failure();
  return DebuggedGame{*std::move(setup), *std::move(openings)};
}

robot::Result<DebuggedGame> DebuggedGameOptions::prepare_trees() const {
  auto game = prepare();
  if (!game) return game;
  if (const auto trees = debug::check_trees(*game->setup); !trees) return trees.failure();
  return game;
}

void add_length(CLI::App& command, double& seconds) {
  command.add_option("--seconds", seconds, "[s] length of a game; 0: to its end")->check(CLI::Range(0., 36000.));
}

}  // namespace sim::app
