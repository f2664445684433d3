// The ball of a real robot: pictures of 2009, a truth by odometry, and the fit to both.
#include <gtest/gtest.h>

#include <algorithm>

#include "robot/core/files.h"
#include "robot/fit/ball_distance/ball_distance.h"
#include "robot/lab/import/bhuman2009.h"
#include "robot/lab/import/resting_ball.h"
#include "robot/lab/import/session_sink.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/real_data.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

constexpr std::uint64_t kEpochNs = 1'246'406'400ull * 1'000'000'000;

/// Imports the recording into a session and gathers it.
Result<Evidence> imported(const std::filesystem::path& recording, const std::filesystem::path& session) {
  const Result<std::string> bytes = read_file(recording, 1 << 24);
  if (!bytes) return bytes.failure();
  logging::SessionInfo info;
  info.name = "real";
  info.robot = "0/1";
  info.player = 1;
  info.start_ns = kEpochNs;
  const Result<void> written =
      logging::write_session(session, info, [&](logging::SessionWriter& writer) -> Result<void> {
        lab::SessionSink sink("0/1", writer);
        const auto report = lab::import_with_ball(
            sink, [&](lab::ImportSink& to) { return lab::import_bhuman2009(*bytes, kEpochNs, to); });
        if (!report) return report.failure();
        return {};
      });
  if (!written) return written.failure();
  return gather({session}, {}, 0);
}

const HeldOut& held_out(const BallDistance& fit, const std::string& curve) {
  return *std::ranges::find_if(fit.held_out,
                               [&](const HeldOut& errors) { return errors.is_whole && errors.curve == curve; });
}

TEST(RealBall, APinholeFitsThePicturesOfARobotThatWalksToTheBall) {
  REAL_DATA_OR_SKIP(path, "bhuman2009/logfile.log");
  const ::tests::TemporaryFolder folder;
  const Result<Evidence> evidence = imported(path, folder / "real");
  ASSERT_TRUE(evidence) << evidence.error();
  ASSERT_EQ(evidence->robots.size(), 1u);
  const Result<BallDistance> fit = fit_ball_distance(read_ball_sizes(*evidence));
  ASSERT_TRUE(fit) << fit.error();

  // the known answers: 20 px wide at 1.6 m, 77 px at 0.2 m, in images half as wide as kImageWidth
  EXPECT_NEAR(fit->seen.sizes.front().distance, 1.6, 0.1);
  EXPECT_NEAR(fit->seen.sizes.front().radius, 20, 2);
  for (const BallSize& size : fit->seen.sizes) {
    if (size.distance < 0.18 || size.distance > 0.22) continue;
    EXPECT_NEAR(size.radius, 77, 6) << size.at;
  }
  // the camera is 0.41 to 0.49 m high, the middle of the ball 0.04 m
  EXPECT_LT(fit->figures[2].low, 0.41);
  EXPECT_GT(fit->figures[2].high, 0.39);

  // on parts of the walk that a curve was not fitted to: 3 cm against 110 cm and 89 cm
  EXPECT_LT(held_out(*fit, "pinhole").errors.mean, 0.05);
  EXPECT_GT(held_out(*fit, "power law").errors.mean, 0.3);
  EXPECT_GT(held_out(*fit, "constant").errors.mean, 0.3);
  EXPECT_LT(held_out(*fit, "the robot's own").errors.mean, 0.05) << "by the camera matrix";
}

}  // namespace
}  // namespace robot::fit
