#include "robot/fit/ball_noise/seen_balls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/byte_sink.h"
#include "robot/core/clock.h"
#include "robot/logging/mcap/writer.h"
#include "robot/memory/memory.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

constexpr std::uint64_t kRecordedNs = 1'700'000'000 * kSecond;

/// Writes 60 images of a robot: every second one with a ball 2 m ahead and half a metre to the left. Each is published
/// `delay_ns` after its capture.
void write_images(const std::filesystem::path& path, std::uint64_t delay_ns) {
  const ManualClock clock;
  const memory::Memory memory("14/2", clock);
  const std::vector<memory::ChannelInfo> channels{memory.vision.info(), memory.ball.info(),
                                                  memory.motion_status.info()};
  auto sink = FileSink::create(path);
  ASSERT_TRUE(sink);
  auto writer = logging::McapWriter::open(std::move(*sink), channels, {});
  ASSERT_TRUE(writer);
  for (std::uint64_t i = 0; i < 60; ++i) {
    const std::uint64_t capture_ns = kRecordedNs + i * 33 * kMillisecond;
    foresight::Vision vision;
    foresight::Ball ball;
    foresight::MotionStatus status;
    if (i % 2 == 0) {
      vision.mutable_ball()->mutable_detection()->set_distance(2);
      vision.mutable_ball()->mutable_detection()->set_bearing(0.25F);
    }
    ball.set_x(2), ball.set_y(0.5F), ball.set_visible(i % 2 == 0);
    status.set_standing(i < 20), status.set_walking(i >= 20);
    if (i >= 40) status.set_fall(foresight::MotionStatus::FALL_FALLEN);
    const std::string texts[] = {vision.SerializeAsString(), ball.SerializeAsString(), status.SerializeAsString()};
    for (std::size_t channel = 0; channel < 3; ++channel)
      ASSERT_TRUE(writer->write(
          channel,
          {.sequence = i + 1, .capture_ns = capture_ns, .publish_ns = capture_ns + delay_ns, .bytes = texts[channel]},
          capture_ns));
  }
  ASSERT_TRUE(writer->close());
}

SeenBalls seen_after(std::uint64_t delay_ns, const std::string& profile = "game") {
  const ::tests::TemporaryFolder folder;
  const std::filesystem::path path = folder / "robot.mcap";
  write_images(path, delay_ns);
  auto session = logging::read_recording(path);
  EXPECT_TRUE(session);
  WatchedRobot robot;
  robot.session = std::move(*session);
  robot.session.info.robot = "14/2", robot.session.info.profile = profile;
  SeenBalls seen = read_seen_balls(robot);
  seen.robot = nullptr;
  return seen;
}

TEST(SeenBalls, ArePerceptsAndBeliefsOfImagesWithABallAndAllReportsOfTheMotion) {
  const SeenBalls seen = seen_after(40 * kMillisecond);
  ASSERT_EQ(seen.percepts.size(), 30u);
  EXPECT_EQ(seen.percepts[1].capture_ns, kRecordedNs + 66 * kMillisecond);
  EXPECT_NEAR(seen.percepts[1].bearing, 0.25, 1e-6);
  ASSERT_EQ(seen.beliefs.size(), 30u);
  EXPECT_NEAR(seen.beliefs[0].distance, std::hypot(2, 0.5), 1e-6);
  ASSERT_EQ(seen.gaits.size(), 60u);
  EXPECT_EQ(seen.gaits[0].gait, Gait::standing);
  EXPECT_EQ(seen.gaits[30].gait, Gait::moving);
  EXPECT_EQ(seen.gaits[50].gait, Gait::down);
}

TEST(SeenBalls, HaveTheTimeFromTheCaptureToTheWritingOfTheBelief) {
  const SeenBalls seen = seen_after(40 * kMillisecond);
  ASSERT_TRUE(seen.writing);
  EXPECT_NEAR(*seen.writing, 0.04, 1e-9);
}

TEST(SeenBalls, OfASimulatedGameOrAWriterThatRepeatsTheCaptureTimeHaveNone) {
  EXPECT_FALSE(seen_after(40 * kMillisecond, "sim").writing);
  EXPECT_FALSE(seen_after(0).writing);
}

}  // namespace
}  // namespace robot::fit
