#include "robot/foresight/triggers.h"

#include <gtest/gtest.h>

#include "tests/robot/foresight/memories.h"

namespace robot::foreseeing {
namespace {

constexpr std::uint64_t kSecondNs = 1'000'000'000, kPeriodNs = 10 * kSecondNs;

std::string text(const char* why) { return why ? why : ""; }

TEST(Captain, IsTheFirstFieldPlayerWhoPlays) {
  pb::GameState game;
  for (int i = 0; i < 5; ++i) game.mutable_own()->add_players();
  EXPECT_EQ(captain_of(game), 2);
  game.mutable_own()->mutable_players(1)->set_penalised(true);
  EXPECT_EQ(captain_of(game), 3);
  game.mutable_own()->set_goalkeeper(3);
  EXPECT_EQ(captain_of(game), 1);
  for (int i = 0; i < 5; ++i) game.mutable_own()->mutable_players(i)->set_penalised(true);
  EXPECT_EQ(captain_of(game), 0);
  EXPECT_EQ(captain_of({}), 0);
}

/// A moment in which nothing happens.
Recollection quiet() {
  Recollection now = test::Played("perfect").recollection();
  now.game->value.set_state(pb::GameState::STATE_PLAYING);
  now.game->value.clear_set_play();
  now.opponents.reset();
  now.ball->value.set_seen_ns(now.now_ns);
  for (pb::PlayerState& player : *now.game->value.mutable_own()->mutable_players()) player.set_penalised(false);
  return now;
}
Recollection after(Recollection now, double seconds) {
  now.now_ns += static_cast<std::uint64_t>(seconds * 1e9);
  now.ball->value.set_seen_ns(now.now_ns);
  return now;
}

TEST(Triggers, ThereIsAReasonAtTheBeginningAndAfterThePeriod) {
  Triggers triggers;
  const Recollection now = quiet();
  EXPECT_NE(triggers.look(now, kPeriodNs), nullptr);
  for (double seconds = 0.1; seconds < 9.95; seconds += 0.1)
    EXPECT_EQ(text(triggers.look(after(now, seconds), kPeriodNs)), "") << seconds;
  EXPECT_EQ(text(triggers.look(after(now, 10), kPeriodNs)), "it is time");
}

TEST(Triggers, EventsAreReasons) {
  const Recollection now = quiet();
  const auto why = [&](auto&& change) {
    Triggers triggers;
    triggers.look(now, kPeriodNs);
    Recollection then = after(now, 3);
    change(then);
    return text(triggers.look(then, kPeriodNs));
  };
  EXPECT_EQ(why([](Recollection&) {}), "");
  EXPECT_EQ(why([](Recollection& r) { r.game->value.mutable_own()->set_score(5); }), "the score changed");
  EXPECT_EQ(why([](Recollection& r) { r.game->value.set_set_play(pb::GameState::SET_PLAY_CORNER_KICK); }),
            "the game was stopped or goes on");
  EXPECT_EQ(why([](Recollection& r) { r.ball->value.set_seen_ns(r.now_ns - 5 * kSecondNs); }), "the ball is lost");
  EXPECT_EQ(why([](Recollection& r) {
              const pb::Pose& pose = r.pose->value;
              const sim::Vec2 ball = sim::Vec2{pose.x(), pose.y()} + sim::turned({r.ball->value.x(), r.ball->value.y()},
                                                                                 sim::direction(pose.heading()));
              r.opponents.emplace();
              pb::Opponents::Opponent& opponent = *r.opponents->value.add_opponents();
              opponent.set_x(ball.x + 0.6f);
              opponent.set_y(ball.y - 0.1f);
              opponent.set_seen_ns(r.now_ns);
            }),
            "the way is blocked");
}

TEST(Triggers, QuestionsAreTwoSecondsApart) {
  Triggers triggers;
  Recollection now = quiet();
  triggers.look(now, kPeriodNs);
  now = after(now, 1.9);
  now.game->value.mutable_own()->set_score(5);
  EXPECT_EQ(text(triggers.look(now, kPeriodNs)), "");
  now = after(now, 0.2);
  now.game->value.mutable_own()->set_score(6);
  EXPECT_EQ(text(triggers.look(now, kPeriodNs)), "the score changed");
}

TEST(Triggers, OnlyTheCaptainAsksAndOnlyInAGame) {
  Recollection now = quiet();
  now.game->value.set_own_player(3);
  EXPECT_EQ(Triggers().look(now, kPeriodNs), nullptr);
  now = quiet();
  for (const auto state : {pb::GameState::STATE_INITIAL, pb::GameState::STATE_FINISHED, pb::GameState::STATE_STANDBY}) {
    now.game->value.set_state(state);
    EXPECT_EQ(Triggers().look(now, kPeriodNs), nullptr);
  }
  now.game.reset();
  EXPECT_EQ(Triggers().look(now, kPeriodNs), nullptr);
}

}  // namespace
}  // namespace robot::foreseeing
