#include "sim/agent/policy.h"

#include <cassert>
#include <utility>

#include "sim/agent/trace.h"

namespace sim::agent {

motion::Command play_choice(const Tree& tree, int choice, const View& view, Mind& mind, Trace* trace) {
  const std::uint16_t entry = tree.menu[static_cast<std::size_t>(choice)];
  return play_leaf(tree, leaf_from(tree, entry, view), view, mind, trace);
}

PolicyBehaviour::PolicyBehaviour(Frame frame, Net net) : frame_(std::move(frame)), net_(std::move(net)) {
  assert(net_.inputs() == frame_.columns.count());
  assert(net_.outputs() == static_cast<int>(frame_.tree.menu.size()));
}

motion::Command PolicyBehaviour::decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs,
                                        Tick now, Mind& mind, Trace* trace) const {
  if (trace) trace->clear(), trace->strategy = name().c_str();
  const View view(surroundings, frame_.tree.settings, game, beliefs, now, mind);
  if (!plays(game)) return wait(view, mind, trace);

  prepare(view, mind);
  float observation[kMaxColumns], outputs[kMaxWidth];
  frame_.columns.observe(view, observation);
  evaluate(net_, observation, outputs);
  return play_choice(frame_.tree, largest(outputs, net_.outputs()), view, mind, trace);
}

}  // namespace sim::agent
