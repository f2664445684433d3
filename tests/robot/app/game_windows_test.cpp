#include "robot/app/game_windows.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"
#include "robot/lab/import/session_sink.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

namespace pb = foresight;

constexpr std::uint64_t kStart = 1'000 * kSecond;

/// Ball and two robots a side, of teams 7 and 3. The ball is hidden for a second, robot 3/2 lies for a while.
pb::GroundTruth truth_at(double seconds) {
  pb::GroundTruth truth;
  if (seconds < 30 || seconds >= 31) {
    truth.mutable_ball()->set_x(static_cast<float>(0.01 * seconds));
    truth.mutable_ball()->set_y(0.5f);
  }
  for (const std::uint32_t team : {7u, 3u})
    for (const std::uint32_t player : {1u, 2u}) {
      auto& robot = *truth.add_robots();
      robot.set_team(team), robot.set_player(player);
      robot.set_x(static_cast<float>(team)), robot.set_y(static_cast<float>(player));
      robot.set_fallen(team == 3 && player == 2 && seconds >= 10 && seconds < 12);
    }
  truth.add_robots()->set_x(9);  // a robot that is not identified
  return truth;
}

struct GameWindows : ::testing::Test {
  /// Writes a session of that length. With `set`, play is interrupted from second 20 to 25.
  Result<std::vector<sim::statistics::Window>> windows(int seconds, bool set) {
    const auto path = folder / ("s" + std::to_string(++sessions_));
    auto writer = logging::SessionWriter::create(path, {.robot = "3/1", .team = 3, .player = 1});
    EXPECT_TRUE(writer);
    lab::SessionSink sink("3/1", **writer);
    for (int frame = 0; frame < seconds * 30; ++frame) {
      const std::uint64_t at_ns = kStart + static_cast<std::uint64_t>(frame) * kSecond / 30;
      if (set && frame % 15 == 0) {
        pb::GameState game;
        game.set_state(frame >= 600 && frame < 750 ? pb::GameState::STATE_SET : pb::GameState::STATE_PLAYING);
        EXPECT_TRUE(sink.message("game", at_ns, game));
      }
      EXPECT_TRUE(sink.message("/truth/world", at_ns, truth_at(frame / 30.)));
    }
    EXPECT_TRUE((*writer)->close());
    return windows_of(logging::open_session(path).value());
  }

  const tests::TemporaryFolder folder;
  int sessions_ = 0;
};

TEST_F(GameWindows, HoldBallAndRobotsOfTheTwoTeams) {
  const auto made = windows(70, false);
  ASSERT_TRUE(made) << made.error();
  ASSERT_EQ(made->size(), 1u);
  const sim::statistics::Window& window = made->front();
  EXPECT_EQ(window.size(), 2100u);
  ASSERT_TRUE(window.ball[300]);
  EXPECT_FLOAT_EQ(window.ball[300]->x, 0.1f);
  EXPECT_FALSE(window.ball[910]);
  ASSERT_EQ(window.robots.size(), 4u);
  for (const auto& robot : window.robots) {
    ASSERT_EQ(robot.frames.size(), window.size());
    ASSERT_TRUE(robot.frames[320]);
    EXPECT_EQ(robot.frames[320]->position.x, robot.side == 0 ? 3.f : 7.f);
    EXPECT_EQ(robot.frames[320]->position.y, static_cast<float>(robot.player));
    EXPECT_EQ(robot.frames[320]->down, robot.side == 0 && robot.player == 2);
  }
}

TEST_F(GameWindows, AreEmptyOutOfPlay) {
  const auto made = windows(70, true);
  ASSERT_TRUE(made) << made.error();
  const sim::statistics::Window& window = made->front();
  EXPECT_EQ(window.size(), 2100u);
  EXPECT_TRUE(window.ball[599] && !window.ball[600] && !window.ball[749] && window.ball[750]);
  EXPECT_FALSE(window.robots[0].frames[700]);
}

TEST_F(GameWindows, Have5000FramesInPlayAndAShortRestIsLeftOut) {
  const auto made = windows(190, false);
  ASSERT_TRUE(made) << made.error();
  ASSERT_EQ(made->size(), 1u);
  EXPECT_EQ(made->front().size(), sim::statistics::kWindowFrames);
}

TEST_F(GameWindows, ASessionWithLessThanAMinuteOrWithoutTruthIsRefused) {
  EXPECT_EQ(windows(59, false).error(), "s1: /truth/world has less than a minute in play");
  auto writer = logging::SessionWriter::create(folder / "none", {.robot = "3/1", .team = 3, .player = 1});
  ASSERT_TRUE(writer && (*writer)->close());
  EXPECT_EQ(windows_of(logging::open_session(folder / "none").value()).error(), "none has no /truth/world");
}

}  // namespace
}  // namespace robot::app
