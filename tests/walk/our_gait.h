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
  bool kicks() const override { return walk_.kick() != KickStep::none; }

 private:
  Walk walk_;
};

}  // namespace robot::nao::walk
