#include "sim/agent/mixed.h"

namespace sim::agent {

Mixed::Mixed(const Behaviour& first, int changed, const Behaviour& rest)
    : first_(first), rest_(rest), changed_(changed), name_(first.name() + " of 1 .. " + std::to_string(changed)) {}

motion::Command Mixed::decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                              Mind& mind, Trace* trace) const {
  return of(game.player).decide(surroundings, game, beliefs, now, mind, trace);
}

}  // namespace sim::agent
