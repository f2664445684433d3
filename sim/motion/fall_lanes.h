// Falling in lanes: one robot in each. Internal to sim/motion.
#pragma once

#include <cstdint>

#include "sim/math/lanes.h"
#include "sim/math/random.h"
#include "sim/math/tick.h"

namespace sim::motion {

/// Reports whether the random word lets a body fall that falls at `rate` [1/s], within these ticks.
inline bool falls_by(std::uint32_t word, float rate, float ticks) {
  return uniform(word) < rate * ticks * kTickDuration;
}

/// Up to kLanes bodies that may fall.
struct FallLanes {
  DrawLanes draws;           // number: the tick
  Lane<float> rate;          // [1/s]
  Lane<float> ticks;         // the duration of their moves
  Lane<std::int32_t> falls;  // 1: it falls
};

/// Draws the falls.
inline void draw_falls(FallLanes& a) {
  SIM_FOR_LANES(i) a.falls[i] = falls_by(a.draws.draw(i, Draw::fall)[0], a.rate[i], a.ticks[i]) ? 1 : 0;
}

}  // namespace sim::motion
