#include "robot/nao/motion/messages.h"

#include <cmath>
#include <numeric>
#include <string>

namespace robot::nao {
namespace {

constexpr int kCharging = 0x80;        // bit of the battery's status
constexpr float kFootLoaded = 0.3f;    // [kg] smallest load of a foot that stands
constexpr float kOnGround = 1;         // [kg] smallest load of both feet on the ground
constexpr float kNearestEcho = 0.01f;  // [m]
constexpr float kFarthestEcho = 2.5f;  // [m] greater values mean that there was no echo

template <class List>
void add(const PerJoint<float>& numbers, List& list) {
  list.Add(numbers.begin(), numbers.end());
}

pb::Body::Mode mode_of(Mode mode) {
  switch (mode) {
    case Mode::unstiff: return pb::Body::MODE_UNSTIFF;
    case Mode::initial: return pb::Body::MODE_INITIAL;
    case Mode::penalised: return pb::Body::MODE_PENALISED;
    case Mode::playing: return pb::Body::MODE_PLAYING;
  }
  return pb::Body::MODE_UNSPECIFIED;
}

pb::Body::Doing doing_of(Doing doing) {
  switch (doing) {
    case Doing::soft: return pb::Body::DOING_SOFT;
    case Doing::standing_up: return pb::Body::DOING_STANDING_UP;
    case Doing::standing: return pb::Body::DOING_STANDING;
    case Doing::holding: return pb::Body::DOING_HOLDING;
    case Doing::sitting_down: return pb::Body::DOING_SITTING_DOWN;
    case Doing::falling: return pb::Body::DOING_FALLING;
    case Doing::fallen: return pb::Body::DOING_FALLEN;
    case Doing::getting_up: return pb::Body::DOING_GETTING_UP;
  }
  return pb::Body::DOING_UNSPECIFIED;
}

const char* motion_of(Doing doing) {
  switch (doing) {
    case Doing::standing_up: return "stand_up";
    case Doing::sitting_down: return "sit";
    case Doing::falling: return "tuck";
    case Doing::getting_up: return "get_up";
    default: return "";
  }
}

pb::MotionStatus::Fall fall_of(Doing doing) {
  switch (doing) {
    case Doing::falling: return pb::MotionStatus::FALL_FALLING;
    case Doing::fallen: return pb::MotionStatus::FALL_FALLEN;
    case Doing::getting_up: return pb::MotionStatus::FALL_GETTING_UP;
    default: return pb::MotionStatus::FALL_UPRIGHT;
  }
}

/// Returns the side to which the torso leans most.
pb::MotionStatus::FallSide side_of(float roll, float pitch) {
  if (std::abs(pitch) >= std::abs(roll))
    return pitch > 0 ? pb::MotionStatus::FALL_SIDE_FRONT : pb::MotionStatus::FALL_SIDE_BACK;
  return roll > 0 ? pb::MotionStatus::FALL_SIDE_RIGHT : pb::MotionStatus::FALL_SIDE_LEFT;
}

float load(const Report& report, std::size_t first) {
  return std::accumulate(&report.sensors.fsr[first], &report.sensors.fsr[first] + 4, 0.0f);
}

pb::MotionStatus::SupportFoot support_of(const Report& report) {
  const bool left = load(report, 0) >= kFootLoaded, right = load(report, 4) >= kFootLoaded;
  if (left && right) return pb::MotionStatus::SUPPORT_FOOT_BOTH;
  if (left) return pb::MotionStatus::SUPPORT_FOOT_LEFT;
  return right ? pb::MotionStatus::SUPPORT_FOOT_RIGHT : pb::MotionStatus::SUPPORT_FOOT_NONE;
}

template <std::size_t Size>
std::string text_of(const std::array<char, Size>& text) {
  return std::string(text.data());
}

}  // namespace

void fill(const Report& report, pb::Joints& joints) {
  const Sensors& sensors = report.sensors;
  add(sensors.position, *joints.mutable_position());
  add(report.commanded, *joints.mutable_commanded());
  add(sensors.stiffness, *joints.mutable_stiffness());
  add(sensors.temperature, *joints.mutable_temperature());
  add(sensors.current, *joints.mutable_current());
  for (const float status : sensors.status) joints.add_status(static_cast<std::uint32_t>(clamp(status, {0, 65535})));
}

void fill(const Report& report, pb::Inertial& inertial) {
  // LoLA's accelerometer has the opposite sign
  inertial.set_accelerometer_x(-report.sensors.accelerometer[0]);
  inertial.set_accelerometer_y(-report.sensors.accelerometer[1]);
  inertial.set_accelerometer_z(-report.sensors.accelerometer[2]);
  inertial.set_gyroscope_x(report.sensors.gyroscope[0]);
  inertial.set_gyroscope_y(report.sensors.gyroscope[1]);
  inertial.set_gyroscope_z(report.sensors.gyroscope[2]);
  inertial.set_torso_roll(report.sensors.angles[0]);
  inertial.set_torso_pitch(report.sensors.angles[1]);
}

void fill(const Report& report, pb::Fsr& fsr) {
  fsr.set_left_front_left(report.sensors.fsr[0]);
  fsr.set_left_front_right(report.sensors.fsr[1]);
  fsr.set_left_rear_left(report.sensors.fsr[2]);
  fsr.set_left_rear_right(report.sensors.fsr[3]);
  fsr.set_right_front_left(report.sensors.fsr[4]);
  fsr.set_right_front_right(report.sensors.fsr[5]);
  fsr.set_right_rear_left(report.sensors.fsr[6]);
  fsr.set_right_rear_right(report.sensors.fsr[7]);
}

void fill(const Report& report, pb::Sonar& sonar) {
  const auto came_back = [](float distance) { return distance >= kNearestEcho && distance <= kFarthestEcho; };
  if (came_back(report.sensors.sonar[0])) sonar.set_left(report.sensors.sonar[0]);
  if (came_back(report.sensors.sonar[1])) sonar.set_right(report.sensors.sonar[1]);
}

void fill(const Report& report, pb::Touch& touch) {
  const auto touched = [&](std::size_t field) { return report.sensors.touch[field] > 0.5f; };
  touch.set_chest_button(touched(0));
  touch.set_head_front(touched(1));
  touch.set_head_middle(touched(2));
  touch.set_head_rear(touched(3));
  touch.set_left_foot_left(touched(4));
  touch.set_left_foot_right(touched(5));
  touch.set_left_hand_back(touched(6));
  touch.set_left_hand_left(touched(7));
  touch.set_left_hand_right(touched(8));
  touch.set_right_foot_left(touched(9));
  touch.set_right_foot_right(touched(10));
  touch.set_right_hand_back(touched(11));
  touch.set_right_hand_left(touched(12));
  touch.set_right_hand_right(touched(13));
}

void fill(const Report& report, pb::Battery& battery) {
  const auto& [charge, status, current, temperature] = report.sensors.battery;
  battery.set_charge(charge);
  battery.set_current(current);
  battery.set_temperature(temperature);
  battery.set_status(static_cast<std::int32_t>(clamp(status, {-32768, 65535})));
  battery.set_charging((battery.status() & kCharging) != 0);
}

void fill(const Report& report, pb::Body& body) {
  if (!report.has_sensors) {
    body.set_reason(text_of(report.problem));
    return;
  }
  body.set_mode(mode_of(report.mode));
  body.set_doing(doing_of(report.doing));
  body.set_reason(sentence_of(report.reason));
  body.set_limited(report.limited);
  body.set_body_id(text_of(report.body_id));
  body.set_body_version(text_of(report.body_version));
  body.set_head_id(text_of(report.head_id));
  body.set_head_version(text_of(report.head_version));
}

void fill(const Report& report, pb::MotionStatus& status) {
  const bool moves = *motion_of(report.doing) != '\0';
  status.set_body_active(moves);
  status.set_standing(report.doing == Doing::standing);
  status.set_calibrated(true);  // LoLA's inertial unit calibrates itself
  status.set_running(motion_of(report.doing));
  status.set_remaining(report.remaining);
  status.set_support_foot(support_of(report));
  status.set_ground_contact(load(report, 0) + load(report, 4) >= kOnGround);
  status.set_fall(fall_of(report.doing));
  if (!report.lies_known) return;
  status.set_fall_side(side_of(report.lies_roll, report.lies_pitch));
  if (report.doing == Doing::fallen) status.set_support_foot(pb::MotionStatus::SUPPORT_FOOT_NONE);
}

}  // namespace robot::nao
