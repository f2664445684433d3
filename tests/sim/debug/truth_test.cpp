#include "sim/debug/truth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/io/models.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::for_each_decision;

bool has(const std::vector<Source>& sources, Source::Kind kind) {
  return std::ranges::any_of(sources, [&](const Source& source) { return source.kind == kind; });
}

TEST(Truth, OfThePlacesEqualsTheWorld) {
  for_each_decision(300, 13, [&](const Params&, const State& state, const Decision& decision, const auto&) {
    const agent::Beliefs truth = true_beliefs(state, decision.robot);
    const float sign = attack_sign(state.world, side_of(decision.robot));
    const Body& self = state.world.bodies[decision.robot];
    EXPECT_NEAR(distance(sign * truth.pose.pose.position, self.position), 0, 1e-5f);
    const Vec2 ball = self.position + turned(truth.ball.position, self.facing);
    EXPECT_NEAR(distance(ball, state.world.ball.position), 0, 1e-4f);
    for (int i = 0; i < state.world.players; ++i) {
      const Body& body = state.world.bodies[robot_of(other(side_of(decision.robot)), i + 1)];
      if (truth.opponents[i].seen == kNever) continue;
      EXPECT_NEAR(distance(sign * truth.opponents[i].position, body.position), 0, 1e-5f);
    }
  });
}

TEST(Truth, ARobotWithPerfectEyesIsNotFarFromIt) {
  contest::LineupChoice choice;
  choice.game.models[0] = choice.game.models[1] = "perfect";
  const auto setup = prepare(choice);
  ASSERT_TRUE(setup) << setup.error();
  State state = sim::test::begun((*setup)->params, 1);
  referee::Events events;
  int seen = 0;
  while (state.world.tick < 3000) {
    for_each_robot(state.world.players, [&](int robot) {
      const auto decision = decision_in((*setup)->params, state, robot);
      if (!decision || !decision->beliefs.ball.visible) return;
      ++seen;
      const agent::Beliefs truth = true_beliefs(state, robot);
      EXPECT_NEAR(distance(decision->beliefs.pose.pose.position, truth.pose.pose.position), 0, 0.01f);
      EXPECT_NEAR(distance(decision->beliefs.ball.position, truth.ball.position), 0, 0.25f);
    });
    step((*setup)->params, state, events);
  }
  EXPECT_GT(seen, 1000);
}

TEST(Sources, AreThePartsOnWhichAValueDepends) {
  int with_opponent = 0;
  for_each_decision(
      60, 97,
      [&](const Params& params, const State& state, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        const auto of = [&](const char* name) {
          return sources_of(agent::find_feature(name), params, behaviour.tree(), decision, state);
        };
        EXPECT_TRUE(has(of("x"), Source::Kind::pose));
        EXPECT_FALSE(has(of("x"), Source::Kind::ball));
        EXPECT_TRUE(has(of("ball_heat"), Source::Kind::ball));
        EXPECT_FALSE(has(of("ball_heat"), Source::Kind::opponent));
        EXPECT_TRUE(has(of("role"), Source::Kind::memory));
        EXPECT_TRUE(has(of("seconds_left"), Source::Kind::game));
        EXPECT_TRUE(of("field_length").empty());
        with_opponent += has(of("opponent_distance"), Source::Kind::opponent);
      });
  EXPECT_GT(with_opponent, 5);
}

TEST(Sources, AreToldWithAgeAndError) {
  EXPECT_EQ(text_of({.kind = Source::Kind::ball, .age = 0.3f, .error = 0.12f}), "ball seen 0.3 s ago, 0.12 m off");
  EXPECT_EQ(text_of({.kind = Source::Kind::mate, .player = 3, .age = 1, .error = 2}),
            "teammate 3 heard 1.0 s ago, 2.00 m off");
  EXPECT_EQ(text_of({.kind = Source::Kind::opponent, .player = 2}), "opponent 2 never seen");
  EXPECT_EQ(text_of({.kind = Source::Kind::pose, .error = 0.5f}), "own pose 0.50 m off");
}

}  // namespace
}  // namespace sim::debug
