#include "robot/bridge/to_messages.h"

#include <gtest/gtest.h>

#include <limits>

#include <random>

#include "sim/math/vec2.h"

namespace robot::bridge {
namespace {

constexpr Timeline kTimeline{.epoch_ns = 1'000'000'000'000};

TEST(Timeline, ThirtyTicksAreASecondExactly) {
  for (const sim::Tick second : {0u, 1u, 7u, 1200u, 86400u})
    EXPECT_EQ(kTimeline.at(30 * second), kTimeline.epoch_ns + std::uint64_t{second} * 1'000'000'000);
  for (sim::Tick tick = 0; tick < 100000; tick += 97) EXPECT_GT(kTimeline.at(tick + 1), kTimeline.at(tick));
}

TEST(Convert, ABallThatWasNeverSeenIsAbsent) {
  pb::Ball message;
  message.set_x(3);
  EXPECT_FALSE(to_proto(sim::agent::Ball{}, 0.3f, kTimeline, message));
  EXPECT_EQ(message.ByteSizeLong(), 0u);
}

/// A ball rolls to its resting place and crosses the robot's y axis at the given place, if any.
TEST(Convert, TheBallCrossesWhereItRolls) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> metres(-2, 2);
  int crossings = 0;
  for (int i = 0; i < 1000; ++i) {
    const sim::agent::Ball ball{.position = {metres(random), metres(random)},
                                .velocity = {metres(random), metres(random)},
                                .variance = 0.04f,
                                .seen = 30};
    pb::Ball message;
    ASSERT_TRUE(to_proto(ball, 0.3f, kTimeline, message));
    EXPECT_EQ(message.seen_ns(), kTimeline.at(30));
    EXPECT_FLOAT_EQ(message.deviation(), 0.2f);

    sim::Ball rolling{.position = ball.position, .velocity = ball.velocity};
    sim::Vec2 before = rolling.position;
    bool crossed = false;
    float crossing = 0;
    for (int tick = 0; tick < 600; ++tick, before = rolling.position) {
      sim::roll(rolling, 0.3f, 0, sim::kTickDuration);
      if (before.x <= 0 || rolling.position.x > 0) continue;
      crossed = true;
      crossing = before.y + (rolling.position.y - before.y) * before.x / (before.x - rolling.position.x);
    }
    EXPECT_NEAR(message.rest_x(), rolling.position.x, 1e-3);
    EXPECT_NEAR(message.rest_y(), rolling.position.y, 1e-3);
    EXPECT_EQ(message.has_crossing_y(), crossed) << i;
    EXPECT_NEAR(message.crossing_y(), crossing, 1e-3);  // 0 if it does not
    crossings += crossed ? 1 : 0;
  }
  EXPECT_GT(crossings, 100);
}

TEST(Convert, AMateReportsTheBallInItsOwnFrame) {
  sim::agent::Beliefs beliefs;
  sim::agent::Mate& mate = beliefs.mates[2];  // of player 3, player 4
  mate.pose = {.position = {1, 2}, .heading = 0.7f};
  mate.ball = {-0.5f, 0.25f};
  mate.sent = 90;
  mate.ball_age = 30;
  mate.active = true;
  pb::Team team;
  to_proto(beliefs, 3, kTimeline, team);
  ASSERT_EQ(team.teammates_size(), 1);
  const pb::Teammate& told = team.teammates(0);
  EXPECT_EQ(told.player(), 4u);
  EXPECT_EQ(told.sent_ns(), kTimeline.at(90));
  EXPECT_EQ(told.ball().seen_ns(), kTimeline.at(60));
  const sim::Vec2 in_field =
      mate.pose.position + sim::turned({told.ball().x(), told.ball().y()}, sim::direction(told.pose().heading()));
  EXPECT_NEAR(in_field.x, mate.ball.x, 1e-5);
  EXPECT_NEAR(in_field.y, mate.ball.y, 1e-5);
}

TEST(Convert, MatesAreNumberedWithoutTheRobotItself) {
  for (int player = 1; player <= sim::kMaxPlayers; ++player) {
    sim::agent::Beliefs beliefs;
    for (sim::agent::Mate& mate : beliefs.mates) mate.sent = 0;
    pb::Team team;
    to_proto(beliefs, player, kTimeline, team);
    std::uint32_t expected = 1;
    for (const pb::Teammate& told : team.teammates()) {
      if (expected == static_cast<std::uint32_t>(player)) ++expected;
      EXPECT_EQ(told.player(), expected++);
    }
  }
}

TEST(Convert, UnknownDataHaveNoValue) {
  sim::agent::Trace trace;
  trace.visited.push_back({.path = "tree/near",
                           .name = "near",
                           .condition = "ball_distance < 0.35",
                           .feature = "ball_distance",
                           .threshold = 0.35f,
                           .known = false,
                           .result = false});
  trace.visited.push_back({.path = "tree/late",
                           .name = "late",
                           .condition = "player < time_to_ball",
                           .feature = "player",
                           .value = 2,
                           .threshold = std::numeric_limits<float>::quiet_NaN(),
                           .result = false});
  trace.visited.push_back({.path = "tree/search", .name = "search", .condition = "", .feature = ""});
  trace.skill = "search_ball";
  trace.arguments.push_back({.name = "side", .value = -1});
  pb::DecisionTrace message;
  trace.strategy = "baseline";
  to_proto(trace, message);
  EXPECT_EQ(message.strategy(), "baseline");
  ASSERT_EQ(message.visited_size(), 3);
  EXPECT_FALSE(message.visited(0).has_value());
  EXPECT_TRUE(message.visited(0).has_threshold());
  EXPECT_EQ(message.visited(0).kind(), pb::DecisionTrace::Node::KIND_CONDITION);
  EXPECT_EQ(message.visited(1).value(), 2);
  EXPECT_FALSE(message.visited(1).has_threshold());
  EXPECT_EQ(message.visited(1).kind(), pb::DecisionTrace::Node::KIND_CONDITION);
  EXPECT_FALSE(message.visited(2).has_threshold());
  EXPECT_EQ(message.visited(2).kind(), pb::DecisionTrace::Node::KIND_SKILL);
  EXPECT_EQ(message.skill(), "search_ball");
  EXPECT_EQ(message.arguments(0).value(), -1);
}

TEST(Convert, RemovedRobotsAreNotOnTheField) {
  sim::World world;
  world.players = 4;
  world.bodies[sim::robot_of(sim::Side::away, 3)].doing = sim::Body::Doing::removed;
  pb::GroundTruth truth;
  to_proto(world, {.home = 14, .away = 5}, truth);
  EXPECT_EQ(truth.robots_size(), 7);
  for (const auto& robot : truth.robots()) EXPECT_FALSE(robot.team() == 5 && robot.player() == 3);
}

TEST(Convert, KicksAreMirroredWithTheFoot) {
  sim::motion::Model model{};
  model.kick_count = 1;
  model.kicks[0] = {.name = "side", .range = 2, .direction = 1.5f};
  sim::motion::Command command{.body = sim::motion::Command::Body::kick, .kick_left = true, .gain = 0.5f};
  pb::MotionCommand left, right;
  to_proto(command, model, left);
  command.kick_left = false;
  to_proto(command, model, right);
  EXPECT_EQ(left.kick().type(), "side");
  EXPECT_EQ(left.kick().leg(), pb::Kick::LEG_LEFT);
  EXPECT_EQ(left.kick().direction(), -right.kick().direction());
  EXPECT_EQ(left.kick().distance(), 1);
}

}  // namespace
}  // namespace robot::bridge
