#include "sim/debug/setup.h"

#include <string>

#include "sim/agent/follower.h"
#include "sim/agent/mixed.h"
#include "sim/guest/guest.h"
#include "sim/io/strategy.h"

namespace sim::debug {

using robot::Error;
using robot::Result;

namespace {

Error no_tree(const std::string& name) { return {"'" + name + "' is no decision tree, and one is needed here"}; }

}  // namespace

Result<SharedSetup> prepare(const contest::LineupChoice& choice) {
  auto setup = std::make_shared<Setup>();
  io::Matchup trees = choice.game;
  for (const int side : {0, 1}) {
    const bool is_outside = guest::is_guest(choice.game.strategies[side]);
    if (!choice.rest[side].empty() && (is_outside || guest::is_guest(choice.rest[side])))
      return Error{"the debugger needs a whole side for a behaviour from outside"};
    if (!is_outside) continue;
    trees.strategies[side] = "idle";
    if (setup->lineup) continue;
    auto lineup = contest::Lineup::prepare(choice);
    if (!lineup) return lineup.failure();
    setup->lineup = std::make_shared<contest::Lineup>(*std::move(lineup));
  }
  auto game = io::prepare(trees);
  if (!game) return game.failure();

  setup->params = game->params;
  for (const int side : {0, 1}) {
    if (guest::is_guest(choice.game.strategies[side])) {
      setup->behaviours.push_back(std::make_shared<Outside>(choice.game.strategies[side]));
      setup->params.teams[side].behaviour = setup->behaviours.back().get();
      continue;
    }
    agent::Behaviour const* played = game->behaviours[side].get();
    if (!dynamic_cast<const agent::TreeBehaviour*>(played)) return no_tree(choice.game.strategies[side]);
    setup->behaviours.push_back(game->behaviours[side]);
    if (choice.rest[side].empty()) continue;
    auto rest = io::load_strategy(choice.rest[side]);
    if (!rest) return rest.failure();
    if (auto kicks = io::check_kicks((*rest)->tree(), setup->params.teams[side]); !kicks) return kicks.failure();
    setup->behaviours.emplace_back(std::move(*rest));
    const agent::Behaviour& others = *setup->behaviours.back();
    setup->behaviours.push_back(std::make_shared<agent::Mixed>(*played, choice.changed, others));
    setup->params.teams[side].behaviour = setup->behaviours.back().get();
  }
  return SharedSetup(std::move(setup));
}

Result<SharedSetup> rest_of_game(const io::PreparedGame& game, const State& state) {
  auto setup = std::make_shared<Setup>();
  setup->params = game.params;
  for (const int side : {0, 1}) {
    std::shared_ptr<const agent::Behaviour> played = game.behaviours[side];
    if (const auto* follower = dynamic_cast<const agent::Follower*>(played.get()))
      played = follower->strategy(state.robots[robot_of(static_cast<Side>(side), 1)].mind.choice);
    if (!dynamic_cast<const agent::TreeBehaviour*>(played.get())) return no_tree(played->name());
    setup->params.teams[side].behaviour = played.get();
    setup->behaviours.push_back(std::move(played));
  }
  return SharedSetup(std::move(setup));
}

Result<void> check_trees(const Setup& setup) {
  for (const Team& team : setup.params.teams)
    if (dynamic_cast<const Outside*>(team.behaviour)) return no_tree(team.behaviour->name());
  return {};
}

const agent::TreeBehaviour* tree_of(const Params& params, int robot) {
  const agent::Behaviour* behaviour = params.teams[static_cast<int>(side_of(robot))].behaviour;
  if (const auto* mixed = dynamic_cast<const agent::Mixed*>(behaviour)) behaviour = &mixed->of(player_of(robot));
  return dynamic_cast<const agent::TreeBehaviour*>(behaviour);
}

SharedSetup with_tree(const SharedSetup& setup, int robot, agent::Tree tree) {
  auto changed = std::make_shared<Setup>(*setup);
  auto made = std::make_shared<agent::TreeBehaviour>(std::move(tree));
  Team& team = changed->params.teams[static_cast<int>(side_of(robot))];
  const agent::Behaviour* now = made.get();
  if (const auto* mixed = dynamic_cast<const agent::Mixed*>(team.behaviour)) {
    const agent::Behaviour &first = mixed->of(1), &rest = mixed->of(kMaxPlayers);
    int last = 1;  // player that plays the first behaviour
    while (last < kMaxPlayers && &mixed->of(last + 1) == &first) ++last;
    const bool is_first = player_of(robot) <= last;
    changed->behaviours.push_back(made);
    changed->behaviours.push_back(
        std::make_shared<agent::Mixed>(is_first ? *made : first, last, is_first ? rest : *made));
    now = changed->behaviours.back().get();
  } else {
    changed->behaviours.push_back(std::move(made));
  }
  team.behaviour = now;
  return changed;
}

}  // namespace sim::debug
