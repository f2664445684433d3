#include "sim/agent/behaviour.h"

#include <gtest/gtest.h>

#include "sim/agent/search.h"
#include "sim/agent/trace.h"
#include "sim/agent/tree.h"
#include "tests/sim/agent/scene.h"
#include "tests/sim/support/allocations.h"

namespace sim::agent {
namespace {

/// A behaviour in C++: runs to the ball and through it.
class Charge final : public Behaviour {
 public:
  const std::string& name() const override { return name_; }
  motion::Command decide(const Surroundings& around, const Game& game, const Beliefs& beliefs, Tick now, Mind& mind,
                         Trace* trace) const override {
    if (trace) trace->clear();
    const View view(around, settings_, game, beliefs, now, mind);
    if (!plays(game)) return wait(view, mind, trace);
    if (!view.ball_known) return search_ball(view, mind, {});
    if (trace) trace->skill = "charge";
    motion::Command command;
    command.body = motion::Command::Body::walk_to;
    command.walk = 1.5f * view.ball;
    command.turn = angle_of(view.ball);
    return command;
  }

 private:
  Settings settings_;
  std::string name_ = "charge";
};

TEST(Behaviour, CanBeWrittenInCpp) {
  const Charge charge;
  Scene scene;
  scene.see_ball({2, 1});
  Trace trace;
  const motion::Command command = scene.decide(charge, &trace);
  EXPECT_EQ(command.body, motion::Command::Body::walk_to);
  EXPECT_EQ(command.walk, (Vec2{3, 1.5f}));
  EXPECT_STREQ(trace.skill, "charge");
  scene.game.penalised = true;
  EXPECT_EQ(scene.decide(charge).body, motion::Command::Body::stand);
}

TEST(Behaviour, StandsWhenNotInPlayAndGoesToItsPlaceWhenReady) {
  for (const char* name : kShipped) {
    const TreeBehaviour behaviour(shipped(name));
    std::mt19937 random(4);
    for (int i = 0; i < 500; ++i) {
      Scene scene = random_scene(random);
      for (const auto phase : {Game::Phase::initial, Game::Phase::set, Game::Phase::finished}) {
        scene.game.phase = phase;
        EXPECT_EQ(scene.decide(behaviour).body, motion::Command::Body::stand);
        EXPECT_EQ(scene.mind.leaf, kNoLeaf);
      }
      scene.game.phase = Game::Phase::ready;
      Trace trace;
      scene.decide(behaviour, &trace);
      EXPECT_STREQ(trace.skill, "get_ready");
      scene.game.penalised = true;
      for (const auto phase : {Game::Phase::ready, Game::Phase::playing}) {
        scene.game.phase = phase;
        EXPECT_EQ(scene.decide(behaviour).body, motion::Command::Body::stand);
      }
    }
  }
}

TEST(Behaviour, IsAFunctionOfItsArgumentsAndATraceChangesNothing) {
  for (const char* name : kShipped) {
    const TreeBehaviour behaviour(shipped(name));
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i) {
      Scene scene = random_scene(random), again = scene;
      Trace trace;
      EXPECT_EQ(scene.decide(behaviour), again.decide(behaviour, &trace));
      EXPECT_EQ(scene.mind.leaf, again.mind.leaf);
    }
  }
}

TEST(Behaviour, DecidesWithoutAllocating) {
  for (const char* name : kShipped) {
    const TreeBehaviour behaviour(shipped(name));
    std::mt19937 random(6);
    surroundings();
    for (int i = 0; i < 2000; ++i) {
      Scene scene = random_scene(random);
      if (i % 10 == 0) scene.game.phase = Game::Phase::ready;
      const std::size_t before = test::allocations();
      scene.decide(behaviour);
      ASSERT_EQ(test::allocations(), before);
    }
  }
}

TEST(Behaviour, CommandsAreFiniteAndWithinLimits) {
  for (const char* name : kShipped) {
    const TreeBehaviour behaviour(shipped(name));
    std::mt19937 random(7);
    for (int i = 0; i < 5000; ++i) {
      Scene scene = random_scene(random);
      const motion::Command command = scene.decide(behaviour);
      EXPECT_LT(squared_length(command.walk), 400);
      EXPECT_LE(std::abs(command.turn), 3.15f);
      EXPECT_GT(command.gain, 0);
      EXPECT_LE(command.gain, 1);
      EXPECT_LT(command.kick, surroundings().motion->kick_count);
      EXPECT_LT(std::abs(command.look[0]), 20);
    }
  }
}

}  // namespace
}  // namespace sim::agent
