#include "robot/lab/synthetic/synthetic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/support/recording_sink.h"

namespace robot::lab {
namespace {

using namespace synthetic;
using tests::RecordingSink;

/// Returns the recording with the smallest images, because images take long to draw and have their own test.
const RecordingSink& whole() {
  static const RecordingSink sink = [] {
    RecordingSink all;
    const auto report = SyntheticRobot({.image_width = 64}).write(all);
    EXPECT_TRUE(report && report->damage.empty());
    return all;
  }();
  return sink;
}

TEST(SyntheticRobot, HasEveryObjectAtItsRate) {
  std::map<std::string, int> counts;
  for (const auto& entry : whole().entries) ++counts[entry.object];
  const std::map<std::string, int> expected{{"joints", 2000},
                                            {"inertial", 2000},
                                            {"fsr", 2000},
                                            {"touch", 2000},
                                            {"odometry", 2000},
                                            {"vision", 667},
                                            {"pose", 667},
                                            {"decision", 667},
                                            {"motion_command", 667},
                                            {"motion_status", 2000},
                                            {"camera_top", 334},
                                            {"camera_top_matrix", 334},
                                            {"/truth/world", 200},
                                            {"game", 40},
                                            {"battery", 20},
                                            {"team", 20},
                                            {"log", 8},
                                            {"ball", counts["ball"]}};
  EXPECT_EQ(counts, expected);
  EXPECT_GT(counts["ball"], 450) << "the belief stays after the first sight";
}

TEST(SyntheticRobot, GivesTheSameBytesWholeOrInParts) {
  const SyntheticRobot robot({.seconds = 3, .image_width = 64});
  RecordingSink all, parts;
  ASSERT_TRUE(robot.write(all));
  for (const double from : {0.0, 0.77, 1.5, 2.3}) {
    const std::map<double, double> next{{0, 0.77}, {0.77, 1.5}, {1.5, 2.3}, {2.3, 9}};
    ASSERT_TRUE(robot.write(from, next.at(from), parts));
  }
  EXPECT_EQ(parts.entries.size(), all.entries.size());
  EXPECT_TRUE(tests::is_start_of(parts.entries, all.entries));
}

TEST(SyntheticRobot, AnotherSeedGivesOtherNoiseButTheSameStory) {
  RecordingSink one, two;
  ASSERT_TRUE(SyntheticRobot({.seconds = 1, .seed = 1, .image_width = 64}).write(one));
  ASSERT_TRUE(SyntheticRobot({.seconds = 1, .seed = 2, .image_width = 64}).write(two));
  ASSERT_EQ(one.entries.size(), two.entries.size());
  std::set<std::string> differing;
  for (std::size_t i = 0; i < one.entries.size(); ++i)
    if (one.entries[i].value->SerializeAsString() != two.entries[i].value->SerializeAsString())
      differing.insert(one.entries[i].object);
  EXPECT_TRUE(differing.contains("pose"));
  EXPECT_FALSE(differing.contains("/truth/world") || differing.contains("camera_top"));
}

TEST(SyntheticRobot, EndsWithTheErrorOfTheSink) {
  tests::FullSink sink;
  const auto report = SyntheticRobot({.seconds = 1}).write(sink);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error(), "disk full");
}

TEST(SyntheticRobot, PlaysTheGameOfItsLog) {
  std::vector<int> states;
  for (const auto* game : whole().of<pb::GameState>("game")) {
    if (states.empty() || states.back() != game->state()) states.push_back(game->state());
    EXPECT_EQ(game->own().score(), game->state() >= pb::GameState::STATE_READY && states.size() > 4 ? 1u : 0u);
  }
  EXPECT_EQ(states,
            (std::vector<int>{pb::GameState::STATE_INITIAL, pb::GameState::STATE_READY, pb::GameState::STATE_SET,
                              pb::GameState::STATE_PLAYING, pb::GameState::STATE_READY, pb::GameState::STATE_SET}));
  std::set<std::string> skills;
  for (const auto* decision : whole().of<pb::DecisionTrace>("decision")) skills.insert(decision->skill());
  EXPECT_TRUE(skills.contains("kick") && skills.contains("approach_ball") && skills.contains("stand"));
}

TEST(SyntheticRobot, BelievesTheBallNearTheTruthWhileItSeesIt) {
  int visible = 0;
  for (const auto& entry : whole().entries) {
    if (entry.object != "ball") continue;
    const auto& ball = dynamic_cast<const pb::Ball&>(*entry.value);
    if (!ball.visible()) continue;
    ++visible;
    const double t = static_cast<double>(entry.capture_ns - SyntheticRobot::Options().epoch_ns) * 1e-9;
    const Walker walker = walker_at(t);
    const Point truth = relative(ball_at(t)->position, walker.position, walker.heading);
    EXPECT_LT(std::hypot(ball.x() - truth.x, ball.y() - truth.y), 5 * ball.deviation()) << t;
    EXPECT_EQ(ball.seen_ns(), entry.capture_ns);
  }
  EXPECT_GT(visible, 100);
}

TEST(SyntheticRobot, BelievesItsPoseWithinItsUncertainty) {
  for (const auto& entry : whole().entries) {
    if (entry.object != "pose") continue;
    const auto& pose = dynamic_cast<const pb::Pose&>(*entry.value);
    const Walker walker = walker_at(static_cast<double>(entry.capture_ns - SyntheticRobot::Options().epoch_ns) * 1e-9);
    EXPECT_LT(std::abs(pose.x() - walker.position.x), 3 * pose.deviation_x());
    EXPECT_LT(std::abs(pose.y() - walker.position.y), 3 * pose.deviation_y());
  }
}

TEST(SyntheticWorld, WalksOneWholeCircleWithoutJumps) {
  const Walker start = walker_at(0), end = walker_at(kEnd);
  EXPECT_NEAR(start.position.x, end.position.x, 1e-9);
  EXPECT_NEAR(start.position.y, end.position.y, 1e-9);
  for (double t = 0; t < kEnd; t += 0.01) {
    const Walker now = walker_at(t), next = walker_at(t + 0.01);
    const double step = std::hypot(next.position.x - now.position.x, next.position.y - now.position.y);
    EXPECT_NEAR(step, 0.01 * (now.speed + next.speed) / 2, 1e-5) << t;
  }
}

TEST(SyntheticWorld, TheBallLiesAheadOfTheFootAtTheKickAndEndsInTheGoal) {
  const Walker walker = walker_at(kKick);
  const Point ball = relative(ball_at(kKick)->position, walker.position, walker.heading);
  EXPECT_NEAR(ball.x, 0.2, 1e-6);
  EXPECT_NEAR(ball.y, 0, 1e-6);
  const Point scored = ball_at(kGoal)->position;
  EXPECT_GT(scored.x, kFieldLength / 2);
  EXPECT_LT(std::abs(scored.y), kGoalWidth / 2);
  EXPECT_FALSE(ball_at(17));
}

TEST(SyntheticWorld, TheRollingBallMovesAsItsVelocitySays) {
  for (double t = kPlaying; t < kGoal; t += 0.01) {
    if (std::abs(t - kKick) < 0.02) continue;
    const RollingBall now = *ball_at(t), next = *ball_at(t + 0.001);
    if (now.position.x > kFieldLength / 2) continue;
    EXPECT_NEAR(next.position.x - now.position.x, 0.001 * now.velocity.x, 1e-6) << t;
    EXPECT_NEAR(next.position.y - now.position.y, 0.001 * now.velocity.y, 1e-6) << t;
  }
}

TEST(SyntheticCamera, ProjectsAsTheProtoSays) {
  const SyntheticMoment moment{.t = 9.3, .width = 320, .height = 240};
  const pb::CameraMatrix matrix = camera_matrix_of(moment);
  const Camera camera = camera_in_robot(bearing_at(9.3), 320, 240);
  const Vector p{2, 0.3, 0.05};
  const double d[3] = {p.x - matrix.x(), p.y - matrix.y(), p.z - matrix.z()};
  double q[3]{};
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) q[column] += matrix.rotation(3 * row + column) * d[row];
  const auto pixel = camera.project(p);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->u, matrix.centre_x() + matrix.focal_x() * q[0] / q[2], 1e-3);
  EXPECT_NEAR(pixel->v, matrix.centre_y() + matrix.focal_y() * q[1] / q[2], 1e-3);
}

TEST(SyntheticCamera, DrawsTheBallWhereVisionReportsIt) {
  const Noise noise(1);
  int compared = 0;
  for (double t = 7.5; t < 16; t += 0.06) {
    if (!ball_visible(t, 320, 240)) continue;
    const SyntheticMoment moment{.t = t, .step = 1, .width = 320, .height = 240};
    const pb::Vision vision = vision_of(moment, {.visible = true, .last_seen = t, .run = 1}, noise);
    if (vision.ball().radius() < 5) continue;
    ++compared;
    const pb::Image image = image_of(moment);
    ASSERT_EQ(image.data().size(), 2u * 320 * 240);
    const auto u = static_cast<std::size_t>(vision.ball().detection().image_x());
    const auto v = static_cast<std::size_t>(vision.ball().detection().image_y());
    // neither green nor red: the ball is black and white
    const auto cr = static_cast<unsigned char>(image.data()[4 * ((v * 320 + u) / 2) + 3]);
    EXPECT_NEAR(cr, 128, 3) << t;
  }
  EXPECT_GT(compared, 5);
}

TEST(SyntheticNoise, HasMeanZeroAndDeviationOne) {
  const Noise noise(3);
  double sum = 0, squares = 0;
  for (std::uint64_t i = 0; i < 10000; ++i) {
    const double value = noise(Noise::kBallX, i);
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / 10000, 0, 0.03);
  EXPECT_NEAR(squares / 10000, 1, 0.03);
}

}  // namespace
}  // namespace robot::lab
