#include "sim/agent/follower.h"

#include <gtest/gtest.h>

namespace sim::agent {
namespace {

/// A strategy identified by its walking speed.
class Walker final : public Behaviour {
 public:
  explicit Walker(float speed) : speed_(speed) {}
  const std::string& name() const override { return name_; }
  motion::Command decide(const Surroundings&, const Game&, const Beliefs&, Tick, Mind& mind, Trace*) const override {
    motion::Command command;
    command.walk.x = speed_;
    leaf_before = mind.leaf;
    mind.leaf = 3;
    return command;
  }
  mutable std::uint16_t leaf_before = 0;

 private:
  const std::string name_ = "walker";
  const float speed_;
};

constexpr Tick kStale = ticks(5);

struct Team {
  std::shared_ptr<const Walker> slow = std::make_shared<Walker>(1.f), fast = std::make_shared<Walker>(2.f);
  Follower follower{"team", {slow, fast}, kStale};
  Mind mind;
  Beliefs beliefs;

  /// Returns the speed of player 4.
  float speed(Tick now) {
    const Game game{.phase = Game::Phase::playing, .player = 4};
    return follower.decide({}, game, beliefs, now, mind, nullptr).walk.x;
  }
  void captain_tells(Choice choice, Tick sent) { beliefs.mates[1] = {.sent = sent, .active = true, .choice = choice}; }
};

TEST(Follower, PlaysTheFirstUntilTheCaptainChoosesAndAgainWhenItIsSilent) {
  Team team;
  EXPECT_EQ(team.speed(100), 1);
  EXPECT_EQ(team.slow->leaf_before, kNoLeaf);
  team.captain_tells({1, 1}, 110);
  EXPECT_EQ(team.speed(111), 2);
  EXPECT_EQ(team.fast->leaf_before, kNoLeaf) << "the leaves of another tree are other leaves";
  EXPECT_EQ(team.speed(112), 2);
  EXPECT_EQ(team.fast->leaf_before, 3) << "of the same one they are not";
  EXPECT_EQ(team.speed(110 + kStale - 1), 2);
  EXPECT_EQ(team.speed(110 + kStale), 1);
  team.captain_tells({1, 1}, 300);
  EXPECT_EQ(team.speed(301), 2) << "heard again";
}

TEST(Follower, IgnoresAStrategyThatItDoesNotHave) {
  Team team;
  team.captain_tells({2, 1}, 110);
  EXPECT_EQ(team.speed(111), 1);
  EXPECT_EQ(team.mind.choice.strategy, kNoStrategy);
}

TEST(Follower, TakesOverAChoice) {
  Team team;
  team.speed(100);
  take_over({1, 7}, 101, team.mind);
  EXPECT_EQ(team.mind.leaf, kNoLeaf);
  EXPECT_EQ(team.speed(101), 2);
  take_over({1, 7}, 101 + kStale, team.mind);
  EXPECT_EQ(team.mind.leaf, 3);
  EXPECT_EQ(team.speed(2 * kStale), 2) << "confirmed";
}

TEST(Follower, TheCaptainIsTheHeardFieldPlayerWithTheLowestNumber) {
  const Game third{.player = 3};
  Beliefs beliefs;
  EXPECT_EQ(captain_of(third, beliefs, 100, 50), 3) << "a robot that hears no other leads";
  beliefs.mates[1] = {.sent = 90, .active = true};  // player 2
  EXPECT_EQ(captain_of(third, beliefs, 100, 50), 2);
  EXPECT_EQ(captain_of(third, beliefs, 140, 50), 3) << "silent";
  beliefs.mates[1].active = false;
  EXPECT_EQ(captain_of(third, beliefs, 100, 50), 3) << "penalised";
  beliefs.mates[2] = {.sent = 90, .active = true};  // player 4
  EXPECT_EQ(captain_of({.penalised = true, .player = 3}, beliefs, 100, 50), 4);
  EXPECT_EQ(captain_of({.penalised = true, .player = 2}, {}, 100, 50), 0);
}

}  // namespace
}  // namespace sim::agent
