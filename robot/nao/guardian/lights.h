// How the robot shows what it is: the colours that the league asks of the chest, and ours of eyes and ears.
#pragma once

#include <cstdint>

#include "robot/nao/guardian/link.h"
#include "robot/nao/lola/actuators.h"

namespace robot::nao {

struct Shown {
  Mode mode = Mode::unstiff;
  GameState game = GameState::none;  // what the GameController said; none: it was not heard
  bool crashed = false;
  bool troubled = false;  // something keeps the body from doing what it was told
  float charge = 1;       // [0..1] of the battery
  std::uint64_t now_ns = 0;
};

/// Chest: blinks blue while unstiff, red while penalised, off in initial and finished, blue in ready, yellow in set, green
/// while playing, cyan in standby. Eyes: red after three crashes, orange while something is in the way, else white.
/// Ears: a light for each tenth of the battery.
Lights lights_of(const Shown& shown);

}  // namespace robot::nao
