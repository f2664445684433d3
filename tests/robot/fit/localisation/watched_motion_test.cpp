#include "robot/fit/localisation/watched_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "robot/core/clock.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/memory/memory.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

constexpr std::uint64_t kStart = 1'700'000'000 * kSecond;

/// A recording of one robot, message by message.
class Recorded {
 public:
  template <class Message>
  void add(memory::MemoryObject<Message>& object, const Message& message, std::uint64_t after_ns) {
    object.write(message, kStart + after_ns);
    const auto newest = object.newest();
    ASSERT_TRUE(writer_->write(object.info(), newest->capture_ns(), newest->bytes()));
  }

  WatchedRobot robot() {
    EXPECT_TRUE(writer_->close());
    WatchedRobot robot{.name = "14/2", .session = *logging::open_session(folder_.path() / "one")};
    lab::TruthRecord record;
    record.epoch_ns = kStart;
    robot.game = std::make_shared<const TrueGame>(TrueGame{.name = "game", .record = std::move(record)});
    return robot;
  }

  memory::Memory memory{"14/2", clock_};

 private:
  const ::tests::TemporaryFolder folder_;
  const ManualClock clock_;
  std::unique_ptr<logging::SessionWriter> writer_ =
      std::move(*logging::SessionWriter::create(folder_.path() / "one", {.robot = "14/2"}));
};

TEST(WatchedMotion, NumbersThatAreNotFiniteAndAbsurdOnesAreLeftOutAndCounted) {
  Recorded recorded;
  foresight::Odometry odometry;
  odometry.set_x(1);
  recorded.add(recorded.memory.odometry, odometry, kSecond);
  for (const float bad : {NAN, INFINITY, 1e9f}) {
    odometry.set_x(bad);
    recorded.add(recorded.memory.odometry, odometry, 2 * kSecond);
  }
  foresight::Pose pose;
  pose.set_x(2);
  pose.set_deviation_x(0.1f);
  pose.set_deviation_y(0.3f);
  recorded.add(recorded.memory.pose, pose, 3 * kSecond);
  pose.set_heading(NAN);
  recorded.add(recorded.memory.pose, pose, 4 * kSecond);
  foresight::MotionStatus status;
  status.set_velocity_x(0.3f);
  status.set_velocity_y(0.4f);
  status.set_turn_rate(-1);
  status.set_fall(foresight::MotionStatus::FALL_GETTING_UP);
  recorded.add(recorded.memory.motion_status, status, 5 * kSecond);
  status.set_velocity_x(100);
  recorded.add(recorded.memory.motion_status, status, 6 * kSecond);

  const WatchedMotion motion = read_motion(recorded.robot(), {.odometry = true, .poses = true});
  EXPECT_EQ(motion.damaged, 5u);
  ASSERT_EQ(motion.odometry.size(), 1u);
  EXPECT_EQ(motion.odometry[0].at, 1);
  ASSERT_EQ(motion.poses.size(), 1u);
  EXPECT_FLOAT_EQ(static_cast<float>(motion.poses[0].deviation), 0.3f) << "the greater one of both axes";
  EXPECT_TRUE(std::isnan(motion.poses[0].deviation_heading)) << "0 is not reported";
  ASSERT_EQ(motion.status.size(), 1u);
  EXPECT_NEAR(motion.status[0].speed, 0.5, 1e-6);
  EXPECT_EQ(motion.status[0].turn_rate, 1);
  EXPECT_EQ(motion.status[0].body, StatusAt::Body::getting_up);
}

TEST(WatchedMotion, TheHeadIsThatOfTheCameraMatrix) {
  Recorded recorded;
  foresight::CameraMatrix matrix;
  // the optical axis looks 0.5 rad to the left and 0.2 rad down; the image reaches 0.4 rad above it
  const double yaw = 0.5, pitch = 0.2, c = std::cos(pitch);
  const double columns[3] = {c * std::cos(yaw), c * std::sin(yaw), -std::sin(pitch)};
  for (int i = 0; i < 9; ++i) matrix.add_rotation(i % 3 == 2 ? static_cast<float>(columns[i / 3]) : 0);
  matrix.set_focal_y(100);
  matrix.set_centre_y(static_cast<float>(100 * std::tan(0.4)));
  recorded.add(recorded.memory.camera_top_matrix, matrix, kSecond);
  matrix.set_focal_y(0);
  recorded.add(recorded.memory.camera_top_matrix, matrix, 2 * kSecond);
  const WatchedMotion motion = read_motion(recorded.robot(), {.heads = true});
  ASSERT_EQ(motion.heads.size(), 1u);
  EXPECT_NEAR(motion.heads[0].yaw, 0.5, 1e-5);
  EXPECT_NEAR(motion.heads[0].upper_edge, -0.2, 1e-5);
}

TEST(WatchedMotion, TheTruthIsInterpolatedWithinAQuarterOfASecond) {
  const std::vector<TrueMoment> truth{
      {.at = 0, .x = 1, .heading = 3.1}, {.at = 0.2, .x = 2, .heading = -3.1}, {.at = 1}};
  TruthReader reader(truth);
  EXPECT_FALSE(reader.at(-1));
  EXPECT_EQ(reader.at(0)->x, 1);
  const auto middle = reader.at(0.1);
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x, 1.5, 1e-9);
  EXPECT_NEAR(std::abs(middle->heading), M_PI, 0.01) << "the short way round";
  EXPECT_NEAR(middle->noise, 0.5, 1e-9);
  EXPECT_FALSE(reader.at(0.6)) << "a longer pause";
  EXPECT_FALSE(reader.at(2));
}

TEST(WatchedMotion, MomentsWithoutAHeadingAreLeftOutAndOthersNearbyAreACrowd) {
  lab::TruthRecord record;
  const lab::Path own{
      {.at = 0, .x = 0, .heading = 1}, {.at = 0.1, .x = 0, .heading = NAN}, {.at = 0.2, .x = 3, .heading = 1}};
  record.robots = {{.name = "14/2", .path = own},
                   {.name = "5/1", .path = {{.at = 0, .x = 0.5}, {.at = 0.2, .x = 0.5}}}};
  const auto moments = true_moments(own, record);
  ASSERT_EQ(moments.size(), 2u);
  EXPECT_TRUE(moments[0].crowded);
  EXPECT_FALSE(moments[1].crowded);
}

}  // namespace
}  // namespace robot::fit
