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

Error no_tree(const std::string& name) { return {"'" + name + "' is no decision tree, and the debugger needs one"}; }

}  // namespace

Result<SharedSetup> prepare(const contest::LineupChoice& choice) {
  for (const int side : {0, 1})
    for (const std::string& name : {choice.game.strategies[side], choice.rest[side]})
      if (guest::is_guest(name)) return no_tree(name);
  auto game = io::prepare(choice.game);
  if (!game) return game.failure();

  auto setup = std::make_shared<Setup>();
  setup->params = game->params;
  for (const int side : {0, 1}) {
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
