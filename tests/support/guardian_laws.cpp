#include "tests/support/guardian_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tests {

using namespace robot::nao;

namespace {

constexpr float kRounding = 1e-5f;

}  // namespace

void GuardianLaws::happen(std::uint8_t byte, std::uint32_t details) {
  random_.seed(details);
  std::uniform_real_distribution<float> angle(-4, 4), share(-0.5f, 1.5f);
  extra_ = {};
  switch (byte % 40) {
    case 0: body_.press_chest(true); break;
    case 1: body_.press_chest(false); break;
    case 2: body_.hold_head(details % 2 == 0); break;
    case 3: extra_.asked_soft = details % 8 == 0; break;
    case 4: extra_.runtime_crashed = true; break;
    case 5: extra_.runtime_left = true; break;
    case 6: gives_orders_ = details % 4 != 0; break;
    case 7: readable_ = details % 4 != 0; break;
    case 8:
      if (details % 4 == 0) body_.fall();
      break;
    case 9: body_.put_upright(); break;
    case 10: body_.sensors.temperature[details % kJoints] = details % 3 == 0 ? 85.0f : 40.0f; break;
    case 11: body_.sensors.temperature.fill(40); break;
    case 12: body_.sensors.battery[0] = details % 3 == 0 ? 0.02f : 0.9f; break;
    case 13:
      if (details % 2 == 0) body_.lift();
      break;
    case 14: body_.put_down(); break;
    case 15: order_.posture = static_cast<Order::Posture>(details % 6); break;
    case 16:
      order_.game = {.heard = details % 2 == 0,
                     .penalised = details % 4 < 2,
                     .state = static_cast<GameState>(details / 4 % 9),
                     .player = 3};
      break;
    case 17:
      for (float& position : order_.position) position = angle(random_);
      break;
    case 18:
      for (float& stiffness : order_.stiffness) stiffness = share(random_);
      break;
    case 19:
      for (std::uint8_t& drives : order_.drives) drives = static_cast<std::uint8_t>(random_() % 3);
      break;
    case 20: order_.position[details % kJoints] = std::numeric_limits<float>::quiet_NaN(); break;
    case 21: order_.stiffness[details % kJoints] = std::numeric_limits<float>::infinity(); break;
    case 22: step_ns_ = details % 3 == 0 ? details % 60'000'000 : 12'000'000; break;
    case 23: body_.sensors.angles[0] = details % 4 == 0 ? 0.5f : 0.0f; break;
    case 24: body_.sensors.position[details % kJoints] += angle(random_) / 10; break;
    case 25: extra_.stop = details % 8 == 0; break;
    case 26:
    case 27:
    case 28: make_well(); break;
    default: break;  // time passes
  }
}

/// Ends all conditions that keep the robot from standing.
void GuardianLaws::make_well() {
  body_.put_upright();
  body_.put_down();
  body_.hold_head(false);
  body_.sensors.temperature.fill(40);
  body_.sensors.battery[0] = 0.9f;
  gives_orders_ = readable_ = true;
  step_ns_ = 12'000'000;
  order_.posture = Order::Posture::stand;
}

std::string GuardianLaws::step(std::uint8_t byte, std::uint32_t details) {
  happen(byte, details);
  now_ns_ += step_ns_;
  extra_.now_ns = now_ns_;
  extra_.sensors = readable_ ? &body_.sensors : nullptr;
  extra_.order = gives_orders_ ? &order_ : nullptr;
  const float dt = std::min(static_cast<float>(step_ns_) * 1e-9f, Guardian::kLongestStep);
  const Actuators& answer = guardian_.step(extra_);
  std::string broken = judge(last_, answer, dt);
  if (broken.empty()) broken = judge_softness(answer, dt);
  last_ = {.position = answer.position, .stiffness = answer.stiffness};
  if (answer.stiffness[l_knee_pitch] > 0.5f && answer.position[l_knee_pitch] < 1) ++stood_;
  body_.obey(answer, dt);
  return broken;
}

std::string GuardianLaws::judge(const Pose& before, const Actuators& answer, float dt) {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const JointLimits& limits = limits_of(joint);
    const float position = answer.position[joint], stiffness = answer.stiffness[joint];
    if (!(position >= limits.range.low && position <= limits.range.high))
      return std::string(limits.name) + " is told to go beyond its range";
    if (!(stiffness >= 0 && stiffness <= 1)) return std::string(limits.name) + " has a stiffness that is none";
    if (stiffness > before.stiffness[joint] + Limiter::kStiffnessRise * dt + kRounding)
      return std::string(limits.name) + " gets stiff too fast";
    const bool moves = stiffness > 0 && before.stiffness[joint] > 0;
    if (moves && std::abs(position - before.position[joint]) > limits.speed * dt + kRounding)
      return std::string(limits.name) + " is told to go faster than it can";
  }
  const Range pitch = head_pitch_range(answer.position[head_yaw]);
  if (answer.position[head_pitch] < pitch.low || answer.position[head_pitch] > pitch.high)
    return "the head is told to go into the shoulders";
  return "";
}

std::string GuardianLaws::judge_softness(const Actuators& answer, float dt) {
  const auto lasts = [&](float& seconds, bool so) { seconds = so ? seconds + dt : 0; };
  if (readable_) {
    const bool pressed = body_.sensors.touch[0] > 0.5f;
    if (pressed_ && !pressed) must_be_soft_ = false;
    pressed_ = pressed;
    held_ = body_.sensors.touch[1] > 0.5f ? held_ + 1 : 0;
    const bool may_get_up = gives_orders_ && order_.posture == Order::Posture::get_up;
    lasts(lies_, body_.sensors.angles[1] > 0.9f && !may_get_up);
    lasts(hot_, *std::max_element(body_.sensors.temperature.begin(), body_.sensors.temperature.end()) > 80);
    lasts(empty_, body_.sensors.battery[0] < 0.04f);
  }
  if (held_ >= Touches::kHeldFrames || extra_.asked_soft) must_be_soft_ = true;
  lasts(blind_, !readable_);
  lasts(silent_, !gives_orders_);

  const bool soft = std::all_of(answer.stiffness.begin(), answer.stiffness.end(), [](float s) { return s == 0; });
  if (soft) return "";
  if (must_be_soft_) return "it has stiffness before the chest button was pressed";
  if (lies_ > 1.5f) return "it lies and has stiffness";
  if (hot_ > 7) return "it is hot and has stiffness";
  if (empty_ > 7) return "its battery is empty and it has stiffness";
  if (silent_ > 7) return "nobody gives orders and it has stiffness";
  if (blind_ > 7) return "it sees nothing and has stiffness";
  return "";
}

}  // namespace tests
