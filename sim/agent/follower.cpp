#include "sim/agent/follower.h"

#include <cassert>
#include <utility>

namespace sim::agent {
namespace {

constexpr int kKeeper = 1;

/// Sets the choice; another strategy starts without a leaf.
void change(const Choice& choice, Mind& mind) {
  if (choice.played() != mind.choice.played()) mind.leaf = kNoLeaf;
  mind.choice = choice;
}

}  // namespace

Follower::Follower(std::string name, std::vector<std::shared_ptr<const Behaviour>> strategies, Tick stale)
    : name_(std::move(name)), strategies_(std::move(strategies)), stale_(stale) {
  assert(!strategies_.empty());
}

motion::Command Follower::decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                                 Mind& mind, Trace* trace) const {
  hear(game, beliefs, now, mind, false);
  return play(surroundings, game, beliefs, now, mind, trace);
}

void Follower::hear(const Game& game, const Beliefs& beliefs, Tick now, Mind& mind, bool leads) const {
  const int captain = captain_of(game, beliefs, now, stale_);
  Choice choice = mind.choice;
  for (int i = 0; i + 1 < game.players; ++i) {
    const Mate& mate = beliefs.mates[i];
    if (mate.sent == kNever || now - mate.sent >= stale_) continue;
    const bool known = static_cast<std::size_t>(mate.choice.played()) < strategies_.size();
    const bool followed = choice.strategy != kNoStrategy;
    if (!known || !follow(mate.choice, player_of_mate(game.player, i) == captain, choice)) continue;
    if (!followed || now - mate.sent < since(now, mind.told)) mind.told = static_cast<std::uint16_t>(mate.sent);
  }
  if (!leads && since(now, mind.told) >= stale_) let_go(choice);
  change(choice, mind);
}

motion::Command Follower::play(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                               Mind& mind, Trace* trace) const {
  return strategy(mind.choice)->decide(surroundings, game, beliefs, now, mind, trace);
}

void take_over(const Choice& choice, Tick now, Mind& mind) {
  change(choice, mind);
  mind.told = static_cast<std::uint16_t>(now);
}

int captain_of(const Game& game, const Beliefs& beliefs, Tick now, Tick stale) {
  for (int player = kKeeper + 1; player <= game.players; ++player) {
    if (player == game.player) {
      if (!game.penalised) return player;
      continue;
    }
    const Mate& mate = beliefs.mates[index_of_mate(game.player, player)];
    if (mate.active && mate.sent != kNever && now - mate.sent < stale) return player;
  }
  return 0;
}

}  // namespace sim::agent
