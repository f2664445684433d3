// The direction of the head while the body does something else.
#pragma once

#include "sim/agent/skills.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// Follows the ball and looks away for marks now and then, to alternate sides. Scans when the ball is
/// unknown. Each player has its own rhythm.
void look_at_ball(const View& view, motion::Command& command);
/// Follows the ball without looking away.
void keep_eye_on_ball(const View& view, motion::Command& command);
/// Swings the head to both sides by `angle` [rad], beginning on the side Mind.search_side.
void scan(const View& view, motion::Command& command, float angle);

/// Stands, with the head on the ball.
motion::Command stand(const View& view);
struct LookRound {
  float angle = 1;  // [rad]

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("angle", self.angle, Range{"rad", 0.1f, 2}, "to each side");
  }
};
/// Stands and swings the head.
motion::Command look_round(const View& view, Mind& mind, const LookRound& with);

}  // namespace sim::agent
