#include "robot/foresight/triggers.h"

#include <gtest/gtest.h>

#include "tests/robot/bridge/played.h"

namespace robot::foreseeing {
namespace {

constexpr std::uint64_t kSecondNs = 1'000'000'000, kPeriodNs = 10 * kSecondNs;
constexpr float kGoalX = 3;  // [m]

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

/// A moment without an event.
bridge::Recollection quiet() {
  bridge::Recollection now = bridge::test::Played("perfect").recollection();
  now.game->value.set_state(pb::GameState::STATE_PLAYING);
  now.game->value.clear_set_play();
  now.opponents.reset();
  now.ball->value.set_seen_ns(now.now_ns);
  for (pb::PlayerState& player : *now.game->value.mutable_own()->mutable_players()) player.set_penalised(false);
  return now;
}
bridge::Recollection after(bridge::Recollection now, double seconds) {
  now.now_ns += static_cast<std::uint64_t>(seconds * 1e9);
  now.ball->value.set_seen_ns(now.now_ns);
  return now;
}

/// Looks, and asks if there is a reason.
std::string ask(Triggers& triggers, const bridge::Recollection& now) {
  const char* const why = triggers.look(now, kPeriodNs);
  if (why) triggers.asked();
  return text(why);
}

/// An opponent that is seen at this distance from the ball.
void see_opponent(bridge::Recollection& now, sim::Vec2 from_ball) {
  const pb::Pose& pose = now.pose->value;
  const sim::Vec2 ball = sim::Vec2{pose.x(), pose.y()} +
                         sim::turned({now.ball->value.x(), now.ball->value.y()}, sim::direction(pose.heading()));
  now.opponents.emplace();
  pb::Opponents::Opponent& opponent = *now.opponents->value.add_opponents();
  opponent.set_x(ball.x + from_ball.x);
  opponent.set_y(ball.y + from_ball.y);
  opponent.set_seen_ns(now.now_ns);
}

TEST(Triggers, ThereIsAReasonAtTheBeginningAndAfterThePeriod) {
  Triggers triggers(kGoalX);
  const bridge::Recollection now = quiet();
  EXPECT_NE(ask(triggers, now), "");
  for (double seconds = 0.1; seconds < 9.95; seconds += 0.1)
    EXPECT_EQ(ask(triggers, after(now, seconds)), "") << seconds;
  EXPECT_EQ(ask(triggers, after(now, 10)), "it is time");
}

TEST(Triggers, EventsAreReasons) {
  const bridge::Recollection now = quiet();
  const auto why = [&](auto&& change) {
    Triggers triggers(kGoalX);
    ask(triggers, now);
    bridge::Recollection then = after(now, 3);
    change(then);
    return ask(triggers, then);
  };
  EXPECT_EQ(why([](bridge::Recollection&) {}), "");
  EXPECT_EQ(why([](bridge::Recollection& r) { r.game->value.mutable_own()->set_score(5); }), "the score changed");
  EXPECT_EQ(why([](bridge::Recollection& r) { r.game->value.set_set_play(pb::GameState::SET_PLAY_CORNER_KICK); }),
            "the game was stopped or goes on");
  EXPECT_EQ(why([](bridge::Recollection& r) { r.ball->value.set_seen_ns(r.now_ns - 5 * kSecondNs); }),
            "the ball is lost");
}

TEST(Triggers, TheWayIsBlockedTowardsTheGoal) {
  // the ball lies at (1.5, 1.5), from where the goal is to the right and ahead
  bridge::Recollection now = quiet();
  now.pose->value.set_x(1), now.pose->value.set_y(1.5f), now.pose->value.set_heading(0);
  now.ball->value.set_x(0.5f), now.ball->value.set_y(0);
  const auto blocked = [&](sim::Vec2 from_ball) {
    see_opponent(now, from_ball);
    return way_is_blocked(now, kGoalX);
  };
  EXPECT_TRUE(blocked({0.5f, -0.5f}));
  EXPECT_TRUE(blocked({0.9f, -0.7f}));
  EXPECT_FALSE(blocked({0.8f, 0})) << "the goal is not straight ahead";
  EXPECT_FALSE(blocked({-0.3f, 0.3f})) << "behind";
  EXPECT_FALSE(blocked({1.2f, -1.2f})) << "far off";
  Triggers triggers(kGoalX);
  now.opponents.reset();
  ask(triggers, now);
  now = after(now, 3);
  see_opponent(now, {0.5f, -0.5f});
  EXPECT_EQ(ask(triggers, now), "the way is blocked");
  now = after(now, 3);
  see_opponent(now, {0.5f, -0.5f});
  EXPECT_EQ(ask(triggers, now), "") << "it still is";
}

TEST(Triggers, QuestionsAreTwoSecondsApartAndReasonsAreKept) {
  Triggers triggers(kGoalX);
  bridge::Recollection now = quiet();
  ask(triggers, now);
  now = after(now, 1.9);
  now.game->value.mutable_own()->set_score(5);
  EXPECT_EQ(ask(triggers, now), "");
  now = after(now, 0.2);
  EXPECT_EQ(text(triggers.look(now, kPeriodNs)), "the score changed") << "a goal of the earlier time";
  now = after(now, 0.1);
  EXPECT_EQ(ask(triggers, now), "the score changed") << "foresight was busy when it came";
  EXPECT_EQ(ask(triggers, after(now, 3)), "");
}

TEST(Triggers, InAFastSimulationSecondsAreThoseOfTheGame) {
  const auto fast = [](bridge::Recollection now) {
    now.speed = 10;
    return now;
  };
  Triggers triggers(kGoalX);
  const bridge::Recollection now = fast(quiet());
  ask(triggers, now);
  EXPECT_EQ(ask(triggers, after(now, 0.95)), "");
  EXPECT_EQ(ask(triggers, after(now, 1)), "it is time") << "10 s of the game";
  bridge::Recollection then = after(now, 1.15);
  then.game->value.mutable_own()->set_score(5);
  EXPECT_EQ(ask(triggers, then), "") << "1.5 s";
  then.now_ns += kSecondNs / 10;
  EXPECT_EQ(ask(triggers, then), "the score changed") << "2.5 s";
  then.now_ns += kSecondNs / 2;
  then.ball->value.set_seen_ns(then.now_ns - kSecondNs / 2);
  EXPECT_EQ(ask(triggers, then), "the ball is lost") << "for 5 s";
}

TEST(Triggers, AfterTimeWasMovedBackItStartsAnew) {
  Triggers triggers(kGoalX);
  const bridge::Recollection now = quiet();
  ask(triggers, after(now, 500));
  EXPECT_NE(ask(triggers, now), "");
  EXPECT_EQ(ask(triggers, after(now, 9)), "");
  EXPECT_EQ(ask(triggers, after(now, 10)), "it is time");
}

TEST(Triggers, OnlyTheCaptainAsksAndOnlyInAGame) {
  bridge::Recollection now = quiet();
  now.game->value.set_own_player(3);
  EXPECT_EQ(Triggers(kGoalX).look(now, kPeriodNs), nullptr);
  now = quiet();
  for (const auto state : {pb::GameState::STATE_INITIAL, pb::GameState::STATE_FINISHED, pb::GameState::STATE_STANDBY}) {
    now.game->value.set_state(state);
    EXPECT_EQ(Triggers(kGoalX).look(now, kPeriodNs), nullptr);
  }
  now = quiet();
  for (const auto phase : {pb::GameState::PHASE_PENALTY_SHOOT_OUT, pb::GameState::PHASE_TIMEOUT}) {
    now.game->value.set_phase(phase);
    EXPECT_EQ(Triggers(kGoalX).look(now, kPeriodNs), nullptr);
  }
  now.game.reset();
  EXPECT_EQ(Triggers(kGoalX).look(now, kPeriodNs), nullptr);
}

}  // namespace
}  // namespace robot::foreseeing
