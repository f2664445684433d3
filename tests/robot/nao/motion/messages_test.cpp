// Messages hold LoLA's values in their own units and signs.
#include "robot/nao/motion/messages.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/lola_frame.h"

namespace robot::nao {
namespace {

struct NaoMessages : ::testing::Test {
  NaoMessages() {
    report.has_sensors = true;
    report.sensors = tests::standing_sensors();
  }

  template <class Message>
  Message filled() const {
    Message message;
    fill(report, message);
    return message;
  }

  Report report;
};

TEST_F(NaoMessages, HaveEveryJoint) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto number = static_cast<float>(i);
    report.sensors.position[i] = number;
    report.commanded[i] = 2 * number;
    report.sensors.stiffness[i] = number / 25;
    report.sensors.temperature[i] = 30 + number;
    report.sensors.current[i] = number / 10;
    report.sensors.status[i] = number;
  }
  const auto joints = filled<pb::Joints>();
  ASSERT_EQ(joints.position_size(), 25);
  ASSERT_EQ(joints.status_size(), 25);
  EXPECT_EQ(joints.position(24), 24);
  EXPECT_EQ(joints.commanded(24), 48);
  EXPECT_EQ(joints.stiffness(5), 0.2f);
  EXPECT_EQ(joints.temperature(8), 38);
  EXPECT_EQ(joints.current(10), 1);
  EXPECT_EQ(joints.status(7), 7u);
}

TEST_F(NaoMessages, ChangeTheSignOfTheAccelerometerOnly) {
  report.sensors.accelerometer = {1, 2, -9.81f};
  report.sensors.gyroscope = {0.1f, 0.2f, 0.3f};
  report.sensors.angles = {0.01f, -0.02f};
  const auto inertial = filled<pb::Inertial>();
  EXPECT_EQ(inertial.accelerometer_x(), -1);
  EXPECT_EQ(inertial.accelerometer_z(), 9.81f) << "a robot that stands still";
  EXPECT_EQ(inertial.gyroscope_z(), 0.3f);
  EXPECT_EQ(inertial.torso_roll(), 0.01f);
  EXPECT_EQ(inertial.torso_pitch(), -0.02f);
  EXPECT_FALSE(inertial.has_torso_yaw());
}

TEST_F(NaoMessages, ReadTheBatteryInLolasOwnOrder) {
  report.sensors.battery = {0.99f, -32552, 0.016f, 3.6f};  // recorded from a robot on its charger
  const auto battery = filled<pb::Battery>();
  EXPECT_EQ(battery.charge(), 0.99f);
  EXPECT_EQ(battery.status(), -32552);
  EXPECT_EQ(battery.current(), 0.016f);
  EXPECT_EQ(battery.temperature(), 3.6f);
  EXPECT_TRUE(battery.charging());
  report.sensors.battery[1] = 0;
  EXPECT_FALSE(filled<pb::Battery>().charging());
}

TEST_F(NaoMessages, KeepTheFeetAndFieldsApart) {
  for (std::size_t i = 0; i < 8; ++i) report.sensors.fsr[i] = static_cast<float>(i);
  EXPECT_EQ(filled<pb::Fsr>().left_rear_right(), 3);
  EXPECT_EQ(filled<pb::Fsr>().right_front_left(), 4);
  for (std::size_t touched = 0; touched < 14; ++touched) {
    report.sensors.touch.fill(0);
    report.sensors.touch[touched] = 1;
    const auto touch = filled<pb::Touch>();
    // numbers in LoLA's order, too
    int set = 0;
    for (int field = 0; field < pb::Touch::descriptor()->field_count(); ++field)
      if (pb::Touch::GetReflection()->GetBool(touch, pb::Touch::descriptor()->field(field))) set += field + 1;
    EXPECT_EQ(set, static_cast<int>(touched) + 1);
  }
}

TEST_F(NaoMessages, HaveNoEchoWhereNoneCameBack) {
  report.sensors.sonar = {0.4f, 5};
  EXPECT_EQ(filled<pb::Sonar>().left(), 0.4f);
  EXPECT_FALSE(filled<pb::Sonar>().has_right());
}

TEST_F(NaoMessages, HoldTheBodysState) {
  report.mode = Mode::penalised;
  report.doing = Doing::sitting_down;
  report.reason = Reason::hot;
  report.limited = true;
  std::strcpy(report.head_id.data(), "P0000074A03S84F00006");
  auto body = filled<pb::Body>();
  EXPECT_EQ(body.mode(), pb::Body::MODE_PENALISED);
  EXPECT_EQ(body.doing(), pb::Body::DOING_SITTING_DOWN);
  EXPECT_EQ(body.reason(), "a joint is too hot: the robot sits until the joint has cooled");
  EXPECT_TRUE(body.limited());
  EXPECT_EQ(body.head_id(), "P0000074A03S84F00006");
  report.has_sensors = false;
  std::strcpy(report.problem.data(), "LoLA is gone");
  body = filled<pb::Body>();
  EXPECT_EQ(body.mode(), pb::Body::MODE_UNSPECIFIED);
  EXPECT_EQ(body.reason(), "LoLA is gone");
}

TEST_F(NaoMessages, HoldTheBodysCurrentMotion) {
  report.doing = Doing::standing;
  auto status = filled<pb::MotionStatus>();
  EXPECT_TRUE(status.standing() && status.ground_contact() && !status.body_active());
  EXPECT_EQ(status.support_foot(), pb::MotionStatus::SUPPORT_FOOT_BOTH);
  EXPECT_EQ(status.fall(), pb::MotionStatus::FALL_UPRIGHT);
  EXPECT_EQ(status.fall_side(), pb::MotionStatus::FALL_SIDE_UNSPECIFIED);

  report.doing = Doing::standing_up;
  report.remaining = 1.5f;
  status = filled<pb::MotionStatus>();
  EXPECT_TRUE(status.body_active() && !status.standing());
  EXPECT_EQ(status.running(), "stand_up");
  EXPECT_EQ(status.remaining(), 1.5f);

  report.sensors.fsr.fill(0);
  EXPECT_FALSE(filled<pb::MotionStatus>().ground_contact());
  EXPECT_EQ(filled<pb::MotionStatus>().support_foot(), pb::MotionStatus::SUPPORT_FOOT_NONE);
  report.sensors.fsr[5] = 3;
  EXPECT_EQ(filled<pb::MotionStatus>().support_foot(), pb::MotionStatus::SUPPORT_FOOT_RIGHT);

  report.lies_known = true;
  report.doing = Doing::fallen;
  for (const auto& [roll, pitch, side] : {std::tuple{0.1f, 1.4f, pb::MotionStatus::FALL_SIDE_FRONT},
                                          {0.1f, -1.4f, pb::MotionStatus::FALL_SIDE_BACK},
                                          {1.4f, 0.1f, pb::MotionStatus::FALL_SIDE_RIGHT},
                                          {-1.4f, 0.1f, pb::MotionStatus::FALL_SIDE_LEFT}}) {
    report.lies_roll = roll;
    report.lies_pitch = pitch;
    EXPECT_EQ(filled<pb::MotionStatus>().fall(), pb::MotionStatus::FALL_FALLEN);
    EXPECT_EQ(filled<pb::MotionStatus>().fall_side(), side);
  }
}

}  // namespace
}  // namespace robot::nao
