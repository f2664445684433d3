#include "sim/environment/actions.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim/environment/options.h"
#include "sim/io/models.h"

namespace sim::environment {
namespace {

using Body = motion::Command::Body;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

agent::Tree menu_of_two() {
  const auto options = read_options(R"({"frame": {"name": "x", "menu": [{"do": "kick"}, {"do": "stand"}]}})");
  EXPECT_TRUE(options) << options.error();
  return options->frame.tree;
}

motion::Model body() {
  Team team;
  EXPECT_TRUE(io::load_team_models("match", kMaxPlayers, team));
  return team.models.motion;
}

motion::Command moved(std::initializer_list<float> row) { return command_of(row.begin(), body()); }

TEST(Actions, OfAMenuAreItsRules) {
  const agent::Tree tree = menu_of_two();
  const auto problem = [&](float number) { return problem_of(Kind::menu, tree, &number); };
  EXPECT_EQ(problem(0), "");
  EXPECT_EQ(problem(1), "");
  for (const float wrong : {-1.f, 0.5f, 2.f, kNan})
    EXPECT_EQ(problem(wrong).substr(0, 36),
              "must be a whole number 0 .. 1, got " + std::string(problem(wrong).substr(35, 1)));
  EXPECT_EQ(problem(2), "must be a whole number 0 .. 1, got 2");
}

TEST(Actions, OfSkillsHaveArgumentsInTheirRanges) {
  const agent::Tree tree = menu_of_two();
  const auto kick = static_cast<float>(agent::find_skill("kick"));
  const auto problem = [&](float skill, float aim) {
    float row[1 + agent::kMaxArguments];
    std::ranges::fill(row, kNan);
    row[0] = skill, row[1] = aim;
    return problem_of(Kind::skills, tree, row);
  };
  ASSERT_STREQ(agent::info_of(agent::find_skill("kick")).parameters[0].name, "aim");
  EXPECT_EQ(problem(kick, kNan), "");
  EXPECT_EQ(problem(kick, 5), "");
  EXPECT_EQ(problem(kick, 6), "has aim of kick, which must be 0 .. 5, a whole number, got 6");
  EXPECT_EQ(problem(kick, 0.5f), "has aim of kick, which must be 0 .. 5, a whole number, got 0.5");
  EXPECT_EQ(problem(-1, 0).substr(0, 25), "must be a whole number 0 ");
}

TEST(Actions, OfMotionAreSharesOfTheGreatestSpeeds) {
  const motion::Walk walk = body().walk;
  const motion::Command fast = moved({1, -1, 0.5f, 0, 0, 0, 0}), back = moved({-0.5f, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(fast.body, Body::walk_speed);
  EXPECT_EQ(fast.walk, (Vec2{walk.forward, -walk.sideward}));
  EXPECT_EQ(fast.turn, 0.5f * walk.turn_rate);
  EXPECT_EQ(back.walk.x, -0.5f * walk.backward);
  EXPECT_EQ(moved({9, 0, 0, 0, 0, 0, 0}).walk.x, walk.forward) << "clipped";
}

TEST(Actions, OfMotionKickBeyondAHalf) {
  const int kicks = body().kick_count;
  EXPECT_EQ(moved({0, 0, 0, 0.5f, 0, 0, 0}).body, Body::walk_speed);
  EXPECT_EQ(moved({0, 0, 0, -0.5f, 0, 0, 0}).body, Body::walk_speed);
  for (int kick = 0; kick < kicks; ++kick) {
    const float value = 0.5f + 0.5f * (static_cast<float>(kick) + 0.5f) / static_cast<float>(kicks);
    const motion::Command left = moved({1, 0, 0, value, 1, 0, 0}), right = moved({1, 0, 0, -value, 1, 0, 0});
    EXPECT_EQ(left.body, Body::kick);
    EXPECT_EQ(left.kick, kick);
    EXPECT_TRUE(left.kick_left);
    EXPECT_EQ(right.kick, kick);
    EXPECT_FALSE(right.kick_left);
  }
  EXPECT_EQ(moved({0, 0, 0, 1, 0, 0, 0}).kick, kicks - 1);
  EXPECT_EQ(moved({1, 0, 0, 0, 0.6f, 0, 0}).body, Body::squat);
}

TEST(Actions, OfMotionTurnTheHeadToShareOfItsLimits) {
  const motion::Head head = body().head;
  const motion::Command command = moved({0, 0, 0, 0, 0, 1, 1}), up = moved({0, 0, 0, 0, 0, -0.5f, -1});
  EXPECT_EQ(command.head, motion::Command::Head::angles);
  EXPECT_EQ(command.look[0], head.yaw_limit);
  EXPECT_EQ(command.look[1], head.pitch_down);
  EXPECT_EQ(up.look[0], -0.5f * head.yaw_limit);
  EXPECT_EQ(up.look[1], head.pitch_up);
}

TEST(Actions, OfMotionAreNumbers) {
  const agent::Tree tree = menu_of_two();
  const float row[kMotionWidth] = {0, 0, 0, kNan, 0, 0, 0}, good[kMotionWidth] = {-7, 0, 9, 0, 0, 0, 0};
  EXPECT_EQ(problem_of(Kind::motion, tree, row), "has kick, which must be a number, got NaN");
  EXPECT_EQ(problem_of(Kind::motion, tree, good), "");
}

}  // namespace
}  // namespace sim::environment
