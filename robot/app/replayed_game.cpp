#include "robot/app/replayed_game.h"

#include <utility>

#include "robot/bridge/to_messages.h"
#include "sim/io/matchup.h"
#include "sim/io/source.h"
#include "sim/match/pace.h"
#include "sim/match/step.h"

namespace robot::app {
namespace {

constexpr sim::Tick kLongest = 30 * 60 * 60 * 2;  // [ticks] two hours of game

/// Returns the name without the changes behind it: "spl2025" of "spl2025:5,half_duration=60".
std::string plain(const std::string& name) { return name.substr(0, name.find_first_of(":,")); }

}  // namespace

void ReplayedGame::begin(const foresight::Simulation& recorded, KnownTrees& trees) {
  for (auto& game : games_) game.reset();
  const foresight::SimulatedTeam* const teams[2] = {&recorded.home(), &recorded.away()};
  const std::string& rules = recorded.rules();
  if (!sim::io::is_embedded("rules", plain(rules))) return;
  for (const auto* team : teams)
    if (!sim::io::is_embedded("models", plain(team->models()))) return;
  auto game = sim::io::prepare({.rules = rules, .models = {teams[0]->models(), teams[1]->models()}});
  if (!game) return;
  for (const int side : {0, 1}) {
    const auto tree = trees.named(teams[side]->strategy());
    if (!tree) return;
    game->behaviours[side] = *tree;
    game->params.teams[side].behaviour = tree->get();
  }
  for (const sim::Pace pace : {sim::Pace::every_tick, sim::Pace::thinned}) {
    game->params.pace = pace;
    sim::referee::Events events;
    const sim::State start = sim::begin(game->params, {recorded.seed()}, events);
    const auto setup = sim::debug::rest_of_game(*game, start);
    if (!setup) return;
    games_[static_cast<int>(pace)].emplace(*setup, start);
  }
}

std::optional<ReplayedGame::Moment> ReplayedGame::at(const foresight::Simulation& recorded,
                                                     const foresight::GroundTruth& truth, KnownTrees& trees) {
  if (recorded.tick() > kLongest) return {};
  std::string wanted = recorded.rules() + "\n" + std::to_string(recorded.seed());
  for (const auto* team : {&recorded.home(), &recorded.away()})
    wanted += "\n" + team->strategy() + "\n" + team->models();
  if (wanted != std::exchange(played_, wanted)) begin(recorded, trees);
  const bridge::TeamNumbers teams{.home = recorded.home().number(), .away = recorded.away().number()};
  for (auto& game : games_) {
    if (!game || recorded.tick() < game->first()) continue;
    const sim::State state = game->at(recorded.tick());
    foresight::GroundTruth replayed;
    bridge::to_proto(sim::between_turns(state), teams, replayed);
    if (state.world.tick != recorded.tick() || replayed.SerializeAsString() != truth.SerializeAsString()) continue;
    return Moment{.setup = game->setup_at(recorded.tick()),
                  .state = state,
                  .teams = {.home = static_cast<int>(teams.home), .away = static_cast<int>(teams.away)}};
  }
  return {};
}

}  // namespace robot::app
