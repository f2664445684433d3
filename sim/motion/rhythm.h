// The rhythm of walking steps. A step is settled when it begins.
#pragma once

#include <cstdint>

#include "sim/math/tick.h"
#include "sim/motion/model.h"
#include "sim/world/body.h"

namespace sim::motion {

/// The steps of a walk over time. All robots with the same model step in the same ticks. Calculates with whole numbers,
/// so that many ticks at once give the same result as single ones.
class Rhythm {
 public:
  explicit Rhythm(const Walk& walk)
      : a_tick_(static_cast<std::uint32_t>(static_cast<float>(kWhole) * kTickDuration / walk.step_duration)) {}

  /// Returns the number of the step that contains `tick`.
  Tick step_at(Tick tick) const { return tick * a_tick_ / kWhole; }
  bool begins_at(Tick tick) const { return begun_at(tick) < a_tick_; }
  /// Returns the time from `tick` to the start of the next step [ticks], at least 1.
  Tick until_next(Tick tick) const { return (kWhole - 1 - begun_at(tick)) / a_tick_ + 1; }

 private:
  static constexpr std::uint32_t kWhole = 0x10000;  // one step, in the units of `a_tick_`

  std::uint32_t begun_at(Tick tick) const { return tick * a_tick_ % kWhole; }

  std::uint32_t a_tick_;  // [1/kWhole steps] length of a tick
};

/// Reports whether the body is walking, so that it must finish its step before it obeys a new command to the legs.
inline bool in_step(const Body& body) {
  if (body.doing == Body::Doing::walking) return true;
  return body.doing == Body::Doing::stopping && (body.velocity != Vec2{} || body.turn_rate != 0);
}

/// Reports whether a command to the legs at `now` has to wait for the next step.
inline bool in_step(const Rhythm& rhythm, const Body& body, Tick now) {
  return in_step(body) && !rhythm.begins_at(now);
}

}  // namespace sim::motion
