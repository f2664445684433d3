#include "sim/agent/kick_choice.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/motion/motion.h"
#include "tests/sim/agent/practice.h"

namespace sim::agent {
namespace {

using Command = motion::Command;

const motion::Model& model() { return *surroundings().motion; }

Tree kicking(const std::string& with) {
  return tree_of(R"({"name": "k", "tree": {"do": "kick", "with": {)" + with + "}}}");
}

/// Returns the angle between the ball's way and a direction of the field [rad].
float miss(const World& world, float wanted) {
  const Vec2 way = direction(wanted), rolls = world.ball.velocity;
  return std::abs(atan2(cross(way, rolls), dot(way, rolls)));
}

TEST(KickChoice, ANamedKickSendsTheBallInTheGivenDirection) {
  for (const std::string name : {"forward", "long", "walk_forward", "side", "turn"})
    for (int n = 0; n < 8; ++n) {
      const float wanted = -3 + 0.8f * static_cast<float>(n);
      Practice practice(
          kicking(R"("kick": ")" + name + R"(", "tolerance": "5 deg", "direction": )" + std::to_string(wanted)),
          {{-0.8f, 0.3f}, 0.4f}, {0, 0});
      bool kicked = false;
      for (int tick = 0; tick < 30 * 60 && !kicked; ++tick) kicked = practice.step();
      ASSERT_TRUE(kicked) << name << " to " << wanted;
      EXPECT_EQ(model().kicks[practice.command.kick].name, name);
      EXPECT_LT(miss(practice.world, wanted), 0.1f) << name << " to " << wanted;
    }
}

TEST(KickChoice, ASideKickNeedsNoTurnWhereTheBallLiesBesideTheFoot) {
  for (const float side : {1.f, -1.f}) {
    Scene scene;
    scene.see_ball({0.06f, side * 0.18f});
    const std::string to = R"("direction": )" + std::to_string(side * 1.571f);
    const Command any = scene.decide(TreeBehaviour(kicking(R"("kick": "any", "range": 1, )" + to)));
    ASSERT_EQ(any.body, Command::Body::kick);
    EXPECT_STREQ(model().kicks[any.kick].name, "side");
    EXPECT_EQ(any.kick_left, side > 0);
    EXPECT_NE(scene.decide(TreeBehaviour(kicking(to))).body, Command::Body::kick);
    // too far for this kick
    const Command far = scene.decide(TreeBehaviour(kicking(R"("kick": "any", "range": 3, )" + to)));
    EXPECT_NE(far.body, Command::Body::kick);
  }
}

TEST(KickChoice, OfAllKicksOneIsPossibleSooner) {
  const auto time_until_kick = [](const char* choice, float& worst) {
    int total = 0;
    for (int n = 0; n < 24; ++n) {
      const float wanted = -3 + 0.25f * static_cast<float>(n);
      Practice practice(kicking(std::string(R"("range": 1, "tolerance": "10 deg", "kick": ")") + choice +
                                R"(", "direction": )" + std::to_string(wanted)),
                        {{-0.5f, 0}, 0}, {0, 0});
      while (!practice.step() && practice.world.tick < 6000) ++total;
      worst = std::max(worst, miss(practice.world, wanted));
    }
    return total;
  };
  float front_miss = 0, any_miss = 0;
  const int front = time_until_kick("front", front_miss), any = time_until_kick("any", any_miss);
  EXPECT_LT(any, 0.8f * static_cast<float>(front));
  EXPECT_LT(any_miss, 0.2f);
  EXPECT_LT(front_miss, 0.2f);
}

TEST(KickChoice, TheChosenKickCarriesFarEnoughAndSendsTheBallIntoTheSector) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> reach(0.2f, 5), angle(-3, 3), tolerance(0.02f, 1);
  float longest = 0;
  for (int i = 0; i < model().kick_count; ++i) longest = std::max(longest, model().kicks[i].range);
  for (int n = 0; n < 3000; ++n) {
    Scene scene = random_scene(random);
    const View view = scene.view();
    const Where where{.direction = angle(random)};
    const float range = reach(random), allowed = tolerance(random);
    const Sector sector = sector_of(view, target_of(view, where, 0), allowed);
    const Shot shot = choose_shot(view, sector, KickChoice::any, range);
    const motion::Kick& kick = model().kicks[shot.kick];
    EXPECT_GE(kick.range, std::min(range, longest));
    EXPECT_GE(dot(shot.way, sector.straight), sector.allowed - 1e-4f);
    EXPECT_NEAR(distance(turned(shot.face, direction(static_cast<float>(shot.side) * kick.direction)), shot.way), 0,
                1e-4f);
  }
}

TEST(KickChoice, AKickThatTheBodyLacksIsReplacedByOneToTheFront) {
  Scene scene;
  scene.see_ball({0.19f, 0.05f});
  const Command command = scene.decide(TreeBehaviour(kicking(R"("kick": "bicycle", "aim": "ahead")")));
  ASSERT_EQ(command.body, Command::Body::kick);
  EXPECT_EQ(model().kicks[command.kick].direction, 0);
}

TEST(KickChoice, ATargetPointIsWhereTheBallGoes) {
  for (const Vec2 target : {Vec2{2, 1}, Vec2{-1, -2}, Vec2{1, 1.5f}}) {
    Scene scene;
    const std::string point = "[" + std::to_string(target.x) + ", " + std::to_string(target.y) + "]";
    scene.decide(TreeBehaviour(kicking(R"("tolerance": 0.01, "target": )" + point)));
    const Vec2 wanted = target - Vec2{1, 0}, way = direction(scene.mind.kick_direction);
    EXPECT_NEAR(cross(unit(wanted), way), 0, 0.02f);
    EXPECT_GT(dot(wanted, way), 0);
  }
}

TEST(KickChoice, APassToAPointTakesAKickThatCarriesThatFar) {
  for (const float far : {1.5f, 2.5f, 3.5f}) {
    Scene scene;
    const std::string point = "[" + std::to_string(1 + far) + ", 0]";
    scene.decide(TreeBehaviour(tree_of(R"({"name": "p", "tree": {"do": "pass", "with": {"target": )" + point + "}}}")));
    EXPECT_GE(model().kicks[scene.mind.kick].range, far);
  }
}

TEST(KickChoice, TheErrorOfAKickCountsFromItsOwnDirection) {
  Scene scene;
  scene.see_ball({0.06f, 0.18f});
  scene.mind.kick = static_cast<std::uint8_t>(motion::find_kick(model(), "side"));
  scene.mind.search_side = 1;
  scene.mind.kick_direction = 1.571f;
  EXPECT_NEAR(value_of(find_feature("kick_error"), scene.view()), 0, 0.01f);
  scene.mind.search_side = -1;
  EXPECT_NEAR(value_of(find_feature("kick_error"), scene.view()), kPi, 0.01f);
}

}  // namespace
}  // namespace sim::agent
