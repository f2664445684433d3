#include "robot/fit/evidence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "proto/foresight/vision.pb.h"
#include "robot/logging/sessions/read_all.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

TEST(Evidence, ASimulatedGameHasEachOfItsRobotsBesideTheTruth) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence =
      tests::simulated_robots(folder.path() / "game", {.seconds = 60, .place_error = 0.02, .clock_error = 0.02});
  ASSERT_EQ(evidence.games.size(), 1u);
  EXPECT_EQ(evidence.robots.size(), 10u);
  EXPECT_TRUE(evidence.left_out.empty());
  for (const WatchedRobot& robot : evidence.robots) {
    EXPECT_GT(robot.path.size(), 1000u) << robot.name;
    EXPECT_TRUE(std::isfinite(robot.path.front().heading)) << robot.name;
    EXPECT_TRUE(robot.path.front().fallen) << robot.name;
    EXPECT_EQ(robot.clock.deviation, 0.02);
  }
}

TEST(Evidence, TheVisionOfASimulatedRobotShowsTheBallWhereItIs) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence = tests::simulated_robots(folder.path() / "game", {.models = "perfect", .seconds = 60});
  std::size_t seen = 0;
  for (const WatchedRobot& robot : evidence.robots) {
    const auto check = [&](const foresight::Vision& vision, std::uint64_t capture_ns) {
      const double at = robot.true_seconds(capture_ns);
      const auto own = lab::place_at(robot.path, at), ball = lab::place_at(robot.game->record.ball, at);
      if (!vision.has_ball() || !own || !ball) return;
      const foresight::Detection& percept = vision.ball().detection();
      const double far = std::hypot(ball->x - own->x, ball->y - own->y);
      ASSERT_NEAR(percept.distance(), far, 0.01) << robot.name << " at " << at;
      const double bearing = std::atan2(ball->y - own->y, ball->x - own->x) - own->heading;
      ASSERT_NEAR(std::remainder(percept.bearing() - bearing, 2 * M_PI), 0, 0.02 + 0.01 / far);
      ++seen;
    };
    logging::read_each<foresight::Vision>(robot.session, "/" + robot.session.info.robot + "/vision", check);
  }
  EXPECT_GT(seen, 1000u);
}

TEST(Evidence, RobotsThatMoveInLongerPiecesAreLeftOut) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence =
      tests::simulated_robots(folder.path() / "game", {.seconds = 10, .pace = sim::Pace::thinned});
  EXPECT_EQ(evidence.games.size(), 1u);
  EXPECT_TRUE(evidence.robots.empty());
  ASSERT_EQ(evidence.left_out.size(), 1u);
  EXPECT_EQ(evidence.left_out[0],
            "game: expected a game recorded with foresight-sim match --every-tick, got one whose robots move in longer "
            "pieces; its truth counts alone");
}

}  // namespace
}  // namespace robot::fit
