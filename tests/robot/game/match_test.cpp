#include "robot/game/match.h"

#include <gtest/gtest.h>

#include <vector>

#include "robot/core/clock.h"

namespace robot::game {
namespace {

using enum Match::Change;
using pb::GameState;

pb::GameState game(GameState::State state, std::uint32_t half = 1, GameState::Phase phase = GameState::PHASE_NORMAL) {
  GameState game;
  game.set_source(GameState::SOURCE_GAME_CONTROLLER);
  game.set_received_ns(kSecond);
  game.set_state(state);
  game.set_half(half);
  game.set_phase(phase);
  game.set_own_team(14);
  game.set_own_player(3);
  game.mutable_opponent()->set_number(5);
  return game;
}

std::vector<Match::Change> changes(const std::vector<GameState>& games) {
  Match match;
  std::vector<Match::Change> changes;
  for (const GameState& game : games) changes.push_back(match.update(game, kSecond));
  return changes;
}

TEST(Match, IsInProgressFromReadyToFinished) {
  Match match;
  const auto in_progress = [&](GameState::State state) {
    match.update(game(state), kSecond);
    return match.in_progress();
  };
  EXPECT_FALSE(in_progress(GameState::STATE_INITIAL));
  EXPECT_FALSE(in_progress(GameState::STATE_STANDBY));
  EXPECT_TRUE(in_progress(GameState::STATE_READY));
  EXPECT_TRUE(in_progress(GameState::STATE_SET));
  EXPECT_TRUE(in_progress(GameState::STATE_PLAYING));
  EXPECT_TRUE(in_progress(GameState::STATE_READY)) << "after a goal";
  EXPECT_FALSE(in_progress(GameState::STATE_FINISHED));
}

TEST(Match, BeginsAndEndsOnceEach) {
  EXPECT_EQ(changes({game(GameState::STATE_INITIAL), game(GameState::STATE_READY), game(GameState::STATE_READY),
                     game(GameState::STATE_PLAYING), game(GameState::STATE_FINISHED), game(GameState::STATE_FINISHED)}),
            (std::vector{none, began, none, none, ended, none}));
}

TEST(Match, BeginsInAnyStateOfPlayForARobotThatJoinsLate) {
  EXPECT_EQ(changes({game(GameState::STATE_PLAYING)}), std::vector{began});
}

TEST(Match, ContinuesThroughATimeOut) {
  EXPECT_EQ(changes({game(GameState::STATE_PLAYING), game(GameState::STATE_INITIAL, 1, GameState::PHASE_TIMEOUT),
                     game(GameState::STATE_STANDBY), game(GameState::STATE_READY)}),
            (std::vector{began, none, none, none}));
}

TEST(Match, EndsWhenTheGameIsRestarted) {
  EXPECT_EQ(changes({game(GameState::STATE_PLAYING), game(GameState::STATE_INITIAL)}), (std::vector{began, ended}));
}

TEST(Match, AnotherHalfOrOpponentIsAnotherMatch) {
  EXPECT_EQ(changes({game(GameState::STATE_PLAYING, 1), game(GameState::STATE_READY, 2)}),
            (std::vector{began, another}));
  GameState other = game(GameState::STATE_READY);
  other.mutable_opponent()->set_number(6);
  EXPECT_EQ(changes({game(GameState::STATE_PLAYING), other}), (std::vector{began, another}));
}

TEST(Match, IgnoresSimulatedGames) {
  GameState simulated = game(GameState::STATE_PLAYING);
  simulated.set_source(GameState::SOURCE_SIMULATOR);
  EXPECT_EQ(changes({simulated}), std::vector{none});
}

TEST(Match, EndsAfterALongSilenceOnly) {
  Match match;
  const GameState playing = game(GameState::STATE_PLAYING);
  EXPECT_EQ(match.update(playing, 2 * kSecond), began);
  EXPECT_EQ(match.update(playing, Match::kSilenceNs), none);
  EXPECT_EQ(match.update(playing, Match::kSilenceNs + kSecond), ended);
  EXPECT_EQ(match.update(playing, Match::kSilenceNs + 2 * kSecond), none);
}

GameState unreadable() {
  GameState game;
  game.set_source(GameState::SOURCE_GAME_CONTROLLER);
  game.set_received_ns(kSecond);
  game.set_unreadable(true);
  game.set_packet_version(21);
  game.set_own_team(14);
  game.set_own_player(3);
  return game;
}

TEST(Match, AnUnreadableFormatCountsAsAMatch) {
  EXPECT_EQ(changes({unreadable(), unreadable()}), (std::vector{began, none}));
  EXPECT_EQ(changes({game(GameState::STATE_PLAYING), unreadable(), game(GameState::STATE_PLAYING)}),
            (std::vector{began, none, none}))
      << "one match, one recording";
  EXPECT_EQ(changes({unreadable(), game(GameState::STATE_READY)}), (std::vector{began, another}));
  EXPECT_EQ(changes({unreadable(), game(GameState::STATE_INITIAL)}), (std::vector{began, ended}));
  EXPECT_EQ(session_name(unreadable(), "A", "x"), "A_format-21_14-3_x");
}

TEST(Match, AMatchInAnUnreadableFormatEndsAfterTheLongSilence) {
  Match match;
  EXPECT_EQ(match.update(unreadable(), kSecond), began);
  EXPECT_EQ(match.update(unreadable(), Match::kSilenceNs), none);
  EXPECT_EQ(match.update(unreadable(), Match::kSilenceNs + kSecond), ended);
}

TEST(Match, ItsRecordingIsNamedByFieldOpponentHalfRobotAndBuild) {
  EXPECT_EQ(session_name(game(GameState::STATE_READY, 2), "A", "0123abcd"), "A_vs-5_half-2_14-3_0123abcd");
  EXPECT_EQ(session_name(game(GameState::STATE_READY, 1), "", "0123abcd"), "vs-5_half-1_14-3_0123abcd");
  EXPECT_EQ(session_name(game(GameState::STATE_SET, 2, GameState::PHASE_PENALTY_SHOOT_OUT), "A", "x"),
            "A_vs-5_shoot-out_14-3_x");
  EXPECT_EQ(session_name(game(GameState::STATE_READY, 1, GameState::PHASE_OVERTIME), "A", "x"),
            "A_vs-5_overtime-1_14-3_x");
}

}  // namespace
}  // namespace robot::game
