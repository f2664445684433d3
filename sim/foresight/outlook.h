// The value of the last moment of a rollout for the time after it.
#pragma once

#include <cstdint>

#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/math/tick.h"

namespace sim::foresight {

/// The table of values, fitted from whole games of equal teams (foresight-sim outlook). Symmetric: an advantage of one
/// side is the same disadvantage of the other.
struct Outlook {
  static constexpr int kZones = 8;  // of equal length, from the own goal line to the opponents'

  float reach = 60;             // [s] goals within this time count; later ones do not depend on the moment
  float worth[kZones][2] = {};  // [goals] own minus opponents', by zone of the ball and by last touch: own, opponents'
};

/// Returns the expected goal difference [goals] of `side` from this moment on; less when the half ends within `reach`.
float worth(const Outlook& outlook, const Params& params, const State& state, Side side);

/// Returns the indices of Outlook::worth: the zone of the ball as `side` counts it, and the side of the last touch.
struct Place {
  int zone;
  int touch;
};
Place place_of(const field::Field& field, const State& state, Side side);

}  // namespace sim::foresight
