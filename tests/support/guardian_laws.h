// Laws of the guardian's answers under any input, judged from outside by its input and output.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "robot/nao/guardian/guardian.h"
#include "tests/support/fake_body.h"

namespace tests {

/// A guardian, a body that obeys it, and events of people, gravity, heat and the runtime, chosen by a stream of bytes.
///
/// - No joint is beyond its range, and the head stays clear of the shoulders.
/// - No joint with stiffness is faster than its speed.
/// - Stiffness is within 0 .. 1 and never grows faster than its ramp.
/// - There is no stiffness before the first press of the chest button.
/// - There is none from the third frame with the head held, or from sit_and_soft on, until the chest button is pressed.
/// - There is none after 1.5 s of lying without an order to get up, or after 7 s of heat, an empty battery, no orders or no
///   readable frame.
class GuardianLaws {
 public:
  /// Applies the event that `byte` chooses, with details from `details`, and runs one cycle. Returns the first broken law, or
  /// an empty text.
  std::string step(std::uint8_t byte, std::uint32_t details);

  /// Number of cycles in the stand with stiffness. Laws about a robot that never moves would prove nothing.
  int stood() const { return stood_; }

 private:
  void happen(std::uint8_t byte, std::uint32_t details);
  void make_well();
  std::string judge(const robot::nao::Pose& before, const robot::nao::Actuators& answer, float dt);
  std::string judge_softness(const robot::nao::Actuators& answer, float dt);

  FakeBody body_;
  robot::nao::Guardian guardian_;
  robot::nao::Order order_;
  robot::nao::Cycle extra_;
  robot::nao::Pose last_;
  std::minstd_rand random_;  // sown anew in each cycle, which costs it nothing
  std::uint64_t now_ns_ = 1'000'000'000, step_ns_ = 12'000'000;
  bool gives_orders_ = true, readable_ = true;
  int stood_ = 0;

  // the state seen so far
  bool must_be_soft_ = true;  // until the chest button is pressed
  bool pressed_ = false;
  int held_ = 0;
  float lies_ = 0, hot_ = 0, empty_ = 0, silent_ = 0, blind_ = 0;  // [s of moving] for how long
};

}  // namespace tests
