// A whole robot in the physics: the motion and the guardian of the runtime, and a body that obeys them.
#pragma once

#include <cstdint>

#include "robot/nao/guardian/guardian.h"
#include "robot/nao/motion/motion.h"
#include "tests/walk/lola_body.h"

namespace robot::nao {

/// A robot that stands in the mode playing, and obeys `command`.
class RobotInPhysics {
 public:
  RobotInPhysics(walk::Servos servos, std::uint64_t seed, bool with_ball = false, bool with_arms = false)
      : body(walk::draw_robot(seed, servos), seed, with_ball, with_arms) {
    cycle();
    for (int clicks = 0; clicks < 3; ++clicks) click();
    for (int i = 0; i < 500 && guardian.doing() != Doing::standing; ++i) cycle();
  }

  /// Moves everything on by one frame of LoLA, 12 ms.
  void cycle() {
    now_ns += 12'000'000;
    const Actuators& answer =
        guardian.step({.now_ns = now_ns, .sensors = &body.sensors, .order = runtime_lives ? &order_ : nullptr});
    body.obey(answer);
    if (runtime_lives) order_ = motion.next(report(answer), &command, 0, nullptr);
  }

  void run(double seconds) {
    for (double time = 0; time < seconds; time += 0.012) cycle();
  }

  foresight::MotionStatus status() const {
    foresight::MotionStatus status;
    motion.fill_status(report({.position = body.sensors.position, .stiffness = {}, .lights = {}}), status);
    return status;
  }

  LolaBody body;
  Guardian guardian;
  Motion motion;
  foresight::MotionCommand command;
  bool runtime_lives = true;
  std::uint64_t now_ns = 1'000'000'000;

 private:
  /// Presses the chest button once.
  void click() {
    for (const bool pressed : {true, false}) {
      body.sensors.touch[0] = pressed ? 1 : 0;
      run(0.1);
    }
  }

  Report report(const Actuators& answer) const {
    Report report;
    report.mode = guardian.mode();
    report.doing = guardian.doing();
    report.remaining = guardian.remaining();
    report.has_sensors = true;
    report.capture_ns = now_ns;
    report.sensors = body.sensors;
    report.commanded = answer.position;
    report.commanded_stiffness = answer.stiffness;
    return report;
  }

  Order order_;
};

}  // namespace robot::nao
