// What must hold of the guardian's answers whatever it is told: judged from outside, by what went in and what came out.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "robot/nao/guardian/guardian.h"
#include "tests/support/fake_body.h"

namespace tests {

/// A guardian, a body that obeys it, and whatever people, gravity, heat and the runtime do, told by a stream of bytes.
///
///   no joint beyond its range; the head clear of the shoulders; no joint with stiffness faster than its speed; stiffness
///   within 0 .. 1 and never growing faster than its ramp; no stiffness
///     before the chest button was pressed for the first time,
///     from the third frame with the head held, or from sit_and_soft on, until the chest button is pressed,
///     after 1.5 s of lying, and after 7 s of heat, an empty battery, no orders, or no readable frame
class GuardianLaws {
 public:
  /// What happens next, chosen by `byte`, its details by `details`; then one cycle. The first law that is broken, or an
  /// empty text.
  std::string step(std::uint8_t byte, std::uint32_t details);

  /// How often the robot was seen in the stand with stiffness: laws about a robot that never moves prove nothing.
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
  std::mt19937 random_;
  std::uint64_t now_ns_ = 1'000'000'000, step_ns_ = 12'000'000;
  bool gives_orders_ = true, readable_ = true;
  int stood_ = 0;

  // what we have seen
  bool must_be_soft_ = true;  // until the chest button is pressed
  bool pressed_ = false;
  int held_ = 0;
  float lies_ = 0, hot_ = 0, empty_ = 0, silent_ = 0, blind_ = 0;  // [s of moving] for how long
};

}  // namespace tests
