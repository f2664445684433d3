// Colours that show the robot's state: the league's for the chest, our own for eyes and ears.
#pragma once

#include <cstdint>

#include "robot/nao/guardian/link.h"
#include "robot/nao/lola/actuators.h"

namespace robot::nao {

/// The state that the lights show.
struct Shown {
  Mode mode = Mode::unstiff;
  GameState game = GameState::none;  // from the GameController; none: no packet yet
  bool crashed = false;
  bool troubled = false;  // the body does not obey, for some reason
  float charge = 1;       // [0..1] of the battery
  std::uint64_t now_ns = 0;
};

/// Returns the lights of a state.
///
/// Chest: blinks blue while unstiff, red while penalised, off in initial and finished, blue in ready, yellow in set,
/// green while playing, cyan in standby. Eyes: red after three crashes, orange while `troubled`, else white. Ears: one
/// light for each tenth of the battery's charge.
Lights lights_of(const Shown& shown);

}  // namespace robot::nao
