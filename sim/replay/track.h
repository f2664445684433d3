// The recorded places of one thing over time: a robot or the ball.
#pragma once

#include <optional>
#include <vector>

#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim::replay {

/// One recorded place. Frame: field.
struct Sample {
  Tick at = 0;                   // [ticks] since the recording began
  Vec2 position;                 // [m]
  std::optional<float> heading;  // [rad]
  bool fallen = false;
};

/// A place at some time, with a heading in any case.
struct Place {
  Vec2 position;      // [m, field]
  float heading = 0;  // [rad]
  bool fallen = false;
  bool held = false;  // no data at this time: it stands where it was seen last
};

/// The longest gap in the data that is bridged: shorter ones are interpolated, at a longer one the robot stands still for
/// this time and is absent then.
inline constexpr Tick kBridged = 30;  // [ticks]

/// All recorded places of one thing.
class Track {
 public:
  Track() = default;
  /// Takes samples in ascending order of their ticks; of several with one tick the first counts. A heading that was not
  /// recorded is the direction of the walk, or the last one while the robot stands.
  explicit Track(std::vector<Sample> samples);

  bool empty() const { return samples_.empty(); }
  /// Returns the place at a tick, exactly the recorded one if there is a sample. Returns nothing while the thing is
  /// absent.
  std::optional<Place> at(Tick tick) const;
  /// Returns the velocity at a tick [m/s], from the samples around it; 0 without two samples that are near.
  Vec2 velocity_at(Tick tick) const;

 private:
  std::vector<Sample> samples_;  // with headings
};

}  // namespace sim::replay
