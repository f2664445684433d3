// From the tree to the joints: a strategy decides by beliefs about the physics, our body walks to the ball and kicks it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/agent/agent.h"
#include "tests/walk/dice.h"
#include "tests/walk/robot_in_physics.h"

namespace robot::nao {
namespace {

namespace pb = foresight;

constexpr std::uint64_t kDecision_ns = 33'333'333;
constexpr double kAwayFromGoal = 2.5;  // [m] the physics' origin is this far before the opponent's goal
constexpr double kSeen = 1.3;          // [rad] to both sides, with a turning head

/// The beliefs of good eyes and a good localisation: the truth with errors.
class Eyes {
 public:
  explicit Eyes(std::uint64_t seed) : dice_(seed) {}

  bridge::Recollection believe(const RobotInPhysics& robot) {
    const walk::Truth truth = robot.body.truth();
    bridge::Recollection beliefs{.now_ns = robot.now_ns};
    pb::Pose pose;
    pose.set_x(static_cast<float>(4.5 - kAwayFromGoal + truth.x + 0.03 * dice_.normal()));
    pose.set_y(static_cast<float>(truth.y + 0.03 * dice_.normal()));
    pose.set_heading(static_cast<float>(truth.heading + 0.02 * dice_.normal()));
    pose.set_deviation_x(0.03f), pose.set_deviation_y(0.03f), pose.set_deviation_heading(0.02f);
    beliefs.pose = {pose, robot.now_ns};

    const double x = truth.ball_x - truth.x, y = truth.ball_y - truth.y;
    const double ahead = x * std::cos(truth.heading) + y * std::sin(truth.heading);
    const double left = y * std::cos(truth.heading) - x * std::sin(truth.heading);
    const double distance = std::hypot(ahead, left);
    ball_.set_visible(std::abs(std::atan2(left, ahead)) < kSeen);
    ball_.set_frames_visible(ball_.visible() ? 10 : 0);
    if (ball_.visible()) {
      ball_.set_seen_ns(robot.now_ns);
      ball_.set_x(static_cast<float>(ahead * (1 + 0.03 * dice_.normal())));
      ball_.set_y(static_cast<float>(left + 0.01 * distance * dice_.normal()));
      ball_.set_deviation(static_cast<float>(0.01 + 0.03 * distance));
    }
    beliefs.ball = {ball_, robot.now_ns};

    pb::GameState game;
    game.set_state(pb::GameState::STATE_PLAYING);
    game.set_phase(pb::GameState::PHASE_NORMAL);
    game.set_half(1), game.set_seconds_remaining(300), game.set_players_per_team(5);
    game.set_own_team(14), game.set_own_player(2);
    game.mutable_own()->set_goalkeeper(1), game.mutable_opponent()->set_goalkeeper(1);
    for (int player = 1; player <= 5; ++player) {
      game.mutable_own()->add_players()->set_penalised(player != 2);
      game.mutable_opponent()->add_players()->set_penalised(true);
    }
    beliefs.game = {game, robot.now_ns};
    beliefs.motion = {robot.status(), robot.now_ns};
    return beliefs;
  }

 private:
  walk::Dice dice_;
  pb::Ball ball_;
};

class StrategyInPhysics : public ::testing::TestWithParam<walk::Servos> {};

TEST_P(StrategyInPhysics, WalksToTheBallAndKicksItToTheGoal) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    auto agent = agent::Agent::load({.models = "nao"});
    ASSERT_TRUE(agent) << agent.error();
    RobotInPhysics robot(GetParam(), seed, true);
    ASSERT_EQ(robot.guardian.doing(), Doing::standing);
    robot.body.place_ball(0.7, 0.25);
    const walk::Truth before = robot.body.truth();
    Eyes eyes(seed);
    std::uint64_t next_ns = 0;
    double nearest = INFINITY, fastest = 0;
    int kicking = 0;  // frames
    for (double time = 0; time < 40 && robot.body.upright(); time += 0.012) {
      if (robot.now_ns >= next_ns) {
        const auto decision = agent->decide(eyes.believe(robot));
        ASSERT_EQ(decision.problem, "");
        robot.command = decision.command;
        next_ns = robot.now_ns + kDecision_ns;
      }
      robot.cycle();
      EXPECT_EQ(robot.motion.refused(), "");
      const walk::Truth now = robot.body.truth();
      nearest = std::min(nearest, std::hypot(kAwayFromGoal - now.ball_x, now.ball_y));
      fastest = std::max(fastest, now.ball_speed);
      kicking += robot.motion.kicks() ? 1 : 0;
    }
    EXPECT_TRUE(robot.body.upright()) << "robot " << seed;
    EXPECT_GT(kicking, 10) << "robot " << seed;
    EXPECT_GT(fastest, 0.4) << "robot " << seed << ": faster than it walks";
    EXPECT_LT(nearest, std::hypot(kAwayFromGoal - before.ball_x, before.ball_y) - 0.4) << "robot " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(BothClasses, StrategyInPhysics, ::testing::Values(walk::Servos::stiff, walk::Servos::soft),
                         [](const auto& tested) { return tested.param == walk::Servos::stiff ? "Stiff" : "Soft"; });

}  // namespace
}  // namespace robot::nao
