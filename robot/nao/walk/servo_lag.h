// The lag of the servos behind their targets, measured while walking.
#pragma once

#include "robot/nao/walk/legs.h"
#include "robot/nao/walk/parameters.h"

namespace robot::nao::walk {

/// The lag of one robot's servos. It is the regression of the error of the swing leg's joints on the speed of their
/// targets. Targets that lead by this lag are reached in time.
class ServoLag {
 public:
  explicit ServoLag(const Parameters& parameters) : parameters_(parameters) {}

  /// Compares the measured joints with the targets of the last tick. `plan` are the targets of this one, without lead,
  /// `dt` [s] later. Measures only while the leg `swing` swings.
  void see(const Legs& measured, const Legs& plan, Side swing, double dt);

  /// Returns `plan` with the lead. `plan` becomes the last one. `dt` [s] since then.
  Legs led(const Legs& plan, double dt);

  /// Notes the targets of a tick without lead, while the robot stands. Returns them.
  const Legs& unled(const Legs& plan) { return last_ = plan; }

 private:
  const Parameters& parameters_;
  Legs last_{};          // the last plan
  double products_ = 0;  // [rad²/s] mean of error times speed
  double squares_ = 0;   // [rad²/s²] mean of squared speed
  double lag_ = 0;       // [s]
};

}  // namespace robot::nao::walk
