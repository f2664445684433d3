#include "sim/check/event.h"

#include <gtest/gtest.h>

#include "sim/io/matchup.h"
#include "sim/io/situation.h"
#include "sim/match/step.h"

namespace sim::check {
namespace {

const Params& params() {
  static const io::PreparedGame made = io::prepare({}).value();
  return made.params;
}

std::string refused_event(std::string_view text) {
  const auto event = parse_event(text, 4);
  return event ? "accepted" : event.error();
}

TEST(Event, IsReadWithItsTime) {
  const auto penalty = parse_event("at 5 s: penalise away/3", 4);
  ASSERT_TRUE(penalty) << penalty.error();
  EXPECT_EQ(penalty->kind, Event::Kind::penalise);
  EXPECT_EQ(penalty->at, ticks(5));
  EXPECT_EQ(penalty->robot, robot_of(Side::away, 3));
  const auto ball = parse_event("at 0.5 min: ball at -1.2 m, 50 cm", 4);
  ASSERT_TRUE(ball) << ball.error();
  EXPECT_EQ(ball->kind, Event::Kind::ball);
  EXPECT_EQ(ball->at, ticks(30));
  EXPECT_EQ(ball->ball, (Vec2{-1.2f, 0.5f}));
}

TEST(Event, NamesARobotByTheNumberOfItsTeamWhereTheSituationNamesTheTeams) {
  const io::SituationTeams teams{.home = 14, .away = 5};
  for (const auto& [text, robot] : {std::pair{"14/3", robot_of(Side::home, 3)},
                                    {"5/1", robot_of(Side::away, 1)},
                                    {"away/3", robot_of(Side::away, 3)}}) {
    const auto event = parse_event(std::string("at 5 s: penalise ") + text, 4, teams);
    ASSERT_TRUE(event) << event.error();
    EXPECT_EQ(event->robot, robot) << text;
  }
  const auto refused = [&](const char* text) { return parse_event(text, 4, teams).error(); };
  EXPECT_EQ(refused("at 5 s: penalise 7/3"),
            "penalise: expected home/N, away/N, 14/N or 5/N, N from 1 to 4, got '7/3'");
  EXPECT_EQ(refused("at 5 s: penalise 14/5"),
            "penalise: expected home/N, away/N, 14/N or 5/N, N from 1 to 4, got '14/5'");
  EXPECT_EQ(refused_event("at 5 s: penalise 14/3"),
            "penalise: expected home/N or away/N, N from 1 to 4, got '14/3'; the situation has no \"teams\"");
}

TEST(Event, APenalisedRobotLeavesAndComesBack) {
  State state = io::load_situation("blocked", params()).value();
  const int robot = robot_of(Side::home, 3);
  apply(*parse_event("at 0: penalise home/3", 4), params(), state);
  EXPECT_EQ(state.world.bodies[robot].doing, Body::Doing::removed);
  referee::Events events;
  bool returned = false;
  for (Tick tick = 0; tick < ticks(60); ++tick) {
    step(params(), state, events);
    returned = returned || on_field(state.world.bodies[robot]);
  }
  EXPECT_TRUE(returned);
}

TEST(Event, ARobotThatIsAwayIsNotPenalisedAgain) {
  State state = io::load_situation("blocked", params()).value();
  const Event event = *parse_event("at 0: penalise home/3", 4);
  apply(event, params(), state);
  const Tick until = state.book.penalised_until[robot_of(Side::home, 3)];
  apply(event, params(), state);
  EXPECT_EQ(state.book.penalised_until[robot_of(Side::home, 3)], until);
}

TEST(Event, ThePlacedBallLiesThere) {
  State state = io::load_situation("blocked", params()).value();
  state.world.ball.velocity = {1, 0};
  apply(*parse_event("at 0: ball at 1, 0.5", 4), params(), state);
  EXPECT_EQ(state.world.ball.position, (Vec2{1, 0.5f}));
  EXPECT_EQ(state.world.ball.velocity, Vec2{});
}

TEST(Event, NamesTheError) {
  constexpr const char* kForm = "expected 'at TIME: ACTION' such as 'at 5 s: penalise home/3', got '";
  for (const char* wrong : {"", "at", "at 5 s", "penalise home/3", "5 s: penalise home/3"})
    EXPECT_EQ(refused_event(wrong), std::string(kForm) + wrong + "'");
  EXPECT_EQ(refused_event("at soon: ball at 1, 2"), "the time must be 0 .. 3600 [s], got \"soon\"");
  EXPECT_EQ(refused_event("at 5 s: dance"), "expected 'penalise home/N' or 'ball at X, Y', got 'dance'");
  for (const char* wrong : {"home/5", "home/0", "ours/3", "home", "home/", "home/3x", "x4/3"})
    EXPECT_EQ(refused_event(std::string("at 5 s: penalise ") + wrong),
              std::string("penalise: expected home/N or away/N, N from 1 to 4, got '") + wrong + "'");
  EXPECT_EQ(refused_event("at 5 s: ball at 1"), "ball at: expected x, y in [m], got '1'");
  EXPECT_EQ(refused_event("at 5 s: ball at 1, far"), "ball at: y must be -20 .. 20 [m], got \"far\"");
}

}  // namespace
}  // namespace sim::check
