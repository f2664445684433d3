// Finding a ball that was lost.
#pragma once

#include "sim/agent/skills.h"
#include "sim/motion/command.h"

namespace sim::agent {

struct SearchBall {
  float gain = 1;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("gain", self.gain, kGainRange, "share of the greatest speed");
  }
};
/// Goes to the place that a teammate reports if its report is newer than the own sight. Otherwise scans with the head,
/// turns all round towards the side where the ball was last, walks to another part of the field, and starts again.
motion::Command search_ball(const View& view, Mind& mind, const SearchBall& with);

}  // namespace sim::agent
