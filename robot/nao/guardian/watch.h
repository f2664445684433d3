// The state of the body: falling, lying or upright, heat of the joints, charge of the battery.
#pragma once

#include <cstdint>

#include "robot/nao/lola/sensors.h"

namespace robot::nao {

/// Thresholds of our choice, based on those of other teams; none was tried on a robot of ours.
struct WatchBounds {
  float upright = 0.4f;     // [rad] it may stand up if the torso leans less
  float falls = 0.65f;      // [rad] it falls if the torso leans more
  float falls_soon = 0.9f;  // [rad] it falls if it will lean this much after `ahead` at its rate, and half as much now
  float ahead = 0.25f;      // [s]
  float warm = 70, cool = 66;            // [°C] half the speed from here on, until here
  float hot = 76, cooled = 68;           // [°C] sits from here on, until here
  float low = 0.1f;                      // [0..1] of the battery: half the speed below
  float empty = 0.05f;                   // [0..1] sits below, until it is charged or above `low`
  float on_feet = 1;                     // [kg] that the foot sensors must carry together
  float still = 0.3f;                    // [rad/s] a robot that lies still turns more slowly
  std::uint64_t lasts_ns = 500'000'000;  // shorter states count as wrong readings
};

/// The watch over falls, heat and battery.
class Watch {
 public:
  explicit Watch(WatchBounds bounds = {}) : bounds_(bounds) {}

  void see(const Sensors& sensors, std::uint64_t now_ns);

  bool upright() const { return upright_; }
  bool upright_lasts() const { return upright_lasts_.value; }
  bool falls() const { return falls_; }
  bool on_feet() const { return on_feet_; }
  bool still() const { return still_.value; }
  bool warm() const { return warm_.value; }
  bool hot() const { return hot_.value; }
  bool battery_low() const { return low_.value; }
  bool battery_empty() const { return empty_.value; }

 private:
  /// A state that changes only when the new value lasts.
  struct Lasting {
    bool value = false;
    std::uint64_t since_ns = 0;
    void see(bool now, std::uint64_t now_ns, std::uint64_t lasts_ns);
    /// Likewise, but the state ends at once.
    void see_or_end(bool now, std::uint64_t now_ns, std::uint64_t lasts_ns);
  };

  WatchBounds bounds_;
  bool upright_ = false, falls_ = false, on_feet_ = false;
  Lasting upright_lasts_, still_, warm_, hot_, low_, empty_;
};

}  // namespace robot::nao
