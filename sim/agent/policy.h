// A learned policy: a net that chooses between the rules of a menu.
#pragma once

#include "sim/agent/columns.h"
#include "sim/agent/net.h"
#include "sim/agent/tree.h"

namespace sim::agent {

/// The choices and the observations of a learner. `tree.menu` has the rules, 1 .. kMaxMenu.
struct Frame {
  Tree tree;
  Columns columns;
};

/// Plays rule `choice` of the menu in a decision during play. `view` is prepared.
motion::Command play_choice(const Tree& tree, int choice, const View& view, Mind& mind, Trace* trace);

/// The behaviour of a net: it observes, and plays the rule of the largest output. Outside play the robot stands or goes
/// to its place.
class PolicyBehaviour final : public Behaviour {
 public:
  /// The net has as many inputs as the frame has columns, and as many outputs as the menu has rules.
  PolicyBehaviour(Frame frame, Net net);

  const std::string& name() const override { return frame_.tree.name; }
  motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                         Mind& mind, Trace* trace) const override;
  const Frame& frame() const { return frame_; }
  const Net& net() const { return net_; }

 private:
  Frame frame_;
  Net net_;
};

}  // namespace sim::agent
