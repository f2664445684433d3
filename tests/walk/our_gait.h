// Our walk, as a gait under test.
#pragma once

#include "robot/nao/walk/walk.h"
#include "tests/walk/trial.h"

namespace robot::nao::walk {

class OurGait final : public Gait {
 public:
  explicit OurGait(const Parameters& parameters = {}) : walk_(parameters) {}

  Legs tick(const Sensors& sensors, const Command& command, double dt) override {
    return walk_.tick(sensors, command, dt);
  }
  bool steps() const override { return walk_.steps(); }

 private:
  Walk walk_;
};

/// Returns the legs of a robot that stands as the walk does.
inline Legs standing_legs(const Parameters& parameters = {}) {
  Walk walk(parameters);
  Sensors sensors;
  sensors.load[left][0] = sensors.load[right][0] = 2;
  return walk.tick(sensors, {}, 0.01);
}

}  // namespace robot::nao::walk
