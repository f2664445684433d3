#include "robot/game/send_guard.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"

namespace robot::game {
namespace {

struct Guard : ::testing::Test {
  void hear(std::uint32_t budget, pb::GameState::State state = pb::GameState::STATE_PLAYING) {
    pb::GameState game;
    game.set_state(state);
    game.set_half(1);
    game.set_seconds_remaining(600);
    game.set_players_per_team(7);
    game.mutable_own()->set_message_budget(budget);
    game.mutable_opponent()->set_number(5);
    guard.hear(game);
  }
  void count(int messages) {
    for (int i = 0; i < messages; ++i) guard.count();
  }
  SendGuard guard;
};

TEST_F(Guard, SendsOnlyWhileTheGameRuns) {
  EXPECT_FALSE(guard.may_send(kSecond, 0)) << "nothing heard yet";
  for (const auto state : {pb::GameState::STATE_INITIAL, pb::GameState::STATE_STANDBY, pb::GameState::STATE_FINISHED}) {
    hear(1200, state);
    EXPECT_FALSE(guard.may_send(kSecond, 0));
  }
  for (const auto state : {pb::GameState::STATE_READY, pb::GameState::STATE_SET, pb::GameState::STATE_PLAYING}) {
    hear(1200, state);
    EXPECT_TRUE(guard.may_send(kSecond, 0));
  }
}

// 1200 s, 7 players, 1170 usable messages: one message per robot every 7.18 s
TEST_F(Guard, MakesTheBudgetLastToTheEndOfTheGame) {
  hear(1200);
  EXPECT_FALSE(guard.may_send(17 * kSecond, 10 * kSecond));
  EXPECT_TRUE(guard.may_send(18 * kSecond, 10 * kSecond));
}

TEST_F(Guard, KeepsAWholeTeamWithinTheBudget) {
  std::uint32_t budget = 1200;
  std::uint64_t last[7] = {};
  for (std::uint64_t second = 1; second <= 1200; ++second) {
    pb::GameState game;
    game.set_state(pb::GameState::STATE_PLAYING);
    game.set_half(second <= 600 ? 1 : 2);
    game.set_seconds_remaining(static_cast<float>((second <= 600 ? 600 : 1200) - second));
    game.set_players_per_team(7);
    game.mutable_own()->set_message_budget(budget);
    guard.hear(game);
    for (std::uint64_t& sent : last)
      if (guard.may_send(second * kSecond, sent)) {
        sent = second * kSecond;
        guard.count();
        --budget;
      }
  }
  EXPECT_GE(budget, SendGuard::kReserve - 7) << "all may send the last one at once";
  EXPECT_LT(budget, 200u) << "and it is used";
  EXPECT_EQ(guard.stopped(), "");
}

TEST_F(Guard, KeepsAReserve) {
  hear(SendGuard::kReserve + 1);
  EXPECT_TRUE(guard.may_send(kSecond, 0));
  hear(SendGuard::kReserve);
  EXPECT_FALSE(guard.may_send(kSecond, 0));
  EXPECT_EQ(guard.stopped(), "") << "reaching the reserve is no error";
}

TEST_F(Guard, StopsWhenTheBudgetFallsFasterThanItCounts) {
  hear(1200);
  count(40);
  hear(1200 - 60);
  EXPECT_EQ(guard.stopped(), "") << "some messages may be lost on the way to us";
  hear(1200 - 61);
  EXPECT_EQ(
      guard.stopped(),
      "sending has stopped: the GameController's message budget fell by 61, but only 40 messages of the team were "
      "sent or heard");
  EXPECT_FALSE(guard.may_send(100 * kSecond, 0));
  count(1000);
  hear(1200);
  EXPECT_FALSE(guard.may_send(100 * kSecond, 0)) << "it stays so";
}

TEST_F(Guard, RestartsTheCountInExtraTimeAndInAnotherGame) {
  hear(100);
  count(3);
  hear(160);  // one minute more
  hear(150);
  hear(1200);  // another game
  hear(1190);
  EXPECT_EQ(guard.stopped(), "");
}

TEST_F(Guard, StopsWhenAnotherProgramSendsAsOurPlayer) {
  hear(1200);
  guard.hear_double("192.168.14.9:10014");
  EXPECT_EQ(guard.stopped(), "sending has stopped: 192.168.14.9:10014 also sends as our player; only one of us may");
  EXPECT_FALSE(guard.may_send(kSecond, 0));
}

TEST(GuardWithoutBudget, SendsOnceASecond) {
  SendGuard guard;
  pb::GameState game;
  game.set_state(pb::GameState::STATE_PLAYING);
  guard.hear(game);
  EXPECT_FALSE(guard.may_send(10 * kSecond + kSecond / 2, 10 * kSecond));
  EXPECT_TRUE(guard.may_send(11 * kSecond, 10 * kSecond));
}

}  // namespace
}  // namespace robot::game
