// When the steps of a walk begin. What a step does is settled then.
#pragma once

#include <cstdint>

#include "sim/math/tick.h"
#include "sim/motion/model.h"
#include "sim/world/body.h"

namespace sim::motion {

/// Where in the steps of the walk a tick lies; all that walk with one model step at once. In whole numbers: whoever asks
/// about many ticks at once gets the answers for single ones.
class Rhythm {
 public:
  explicit Rhythm(const Walk& walk)
      : a_tick_(static_cast<std::uint32_t>(static_cast<float>(kWhole) * kTickDuration / walk.step_duration)) {}

  /// The number of the step in which `tick` lies.
  Tick step_at(Tick tick) const { return tick * a_tick_ / kWhole; }
  bool begins_at(Tick tick) const { return begun_at(tick) < a_tick_; }
  /// [ticks] from `tick` to the next begin of a step, at least 1.
  Tick until_next(Tick tick) const { return (kWhole - 1 - begun_at(tick)) / a_tick_ + 1; }

 private:
  static constexpr std::uint32_t kWhole = 0x10000;

  std::uint32_t begun_at(Tick tick) const { return tick * a_tick_ % kWhole; }

  std::uint32_t a_tick_;  // what a tick is of a step, in 1 / kWhole
};

/// It is on its way with a step, which it has to finish: commands to the legs are heeded when the next one begins.
inline bool in_step(const Body& body) {
  if (body.doing == Body::Doing::walking) return true;
  return body.doing == Body::Doing::stopping && (body.velocity != Vec2{} || body.turn_rate != 0);
}

/// Likewise: what the legs are told at `now` has to wait.
inline bool in_step(const Rhythm& rhythm, const Body& body, Tick now) {
  return in_step(body) && !rhythm.begins_at(now);
}

}  // namespace sim::motion
