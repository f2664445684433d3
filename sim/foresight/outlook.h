// What the moment at which a rollout ends is worth for what comes after.
#pragma once

#include <cstdint>

#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/math/tick.h"

namespace sim::foresight {

/// Fitted from whole games of equal teams (foresight-sim outlook), and symmetric: what is good for one side is as bad for
/// the other.
struct Outlook {
  static constexpr int kZones = 8;  // of equal length along the field, from the own goal line to the others'

  float reach = 60;  // [s] the goals of so long are counted; later ones do not depend on this moment
  float worth[kZones][2] =
      {};  // [goals] own less others', by the ball's zone and whose touch was the last: own, others'
};

/// [goals] that `side` will score more than the others from this moment on; less where the half ends within `reach`.
float worth(const Outlook& outlook, const Params& params, const State& state, Side side);

/// The zone of the ball, as `side` counts them, and whose touch was the last: indices of Outlook::worth.
struct Place {
  int zone;
  int touch;
};
Place place_of(const field::Field& field, const State& state, Side side);

}  // namespace sim::foresight
