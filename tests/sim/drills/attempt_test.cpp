#include "sim/drills/attempt.h"

#include <gtest/gtest.h>

#include <functional>

namespace sim::drills {
namespace {

using Kind = referee::Event::Kind;

constexpr const char* kShots = R"({"seconds": 2, "start": {"ball": {"x": 0, "y": 0}}, "success": "our goal",
  "failure": "ball out or their goal", "score": {"our shot": 0.25, "ball_x > 1 m": 0.5}, "progress": {"ball_x": 0.125}})";

/// An attempt in a made-up course of ticks.
class Course {
 public:
  explicit Course(const std::string& text = kShots) : drill_(*parse_drill(text, "drill")) {
    start_.world.players = 4;
    now_ = start_;
    attempt_.emplace(drill_, start_);
  }

  Outcome tick(const std::function<void(State&, referee::Events&)>& change = [](State&, referee::Events&) {}) {
    referee::Events events;
    change(now_, events);
    ++now_.world.tick;
    return attempt_->see(now_, events);
  }
  Outcome event(Kind kind, Side side) {
    return tick([&](State&, referee::Events& events) { events.add({.kind = kind, .side = side, .at = {}}); });
  }
  Outcome ball_to(float x) {
    return tick([&](State& state, referee::Events&) { state.world.ball.position.x = x; });
  }
  const Attempt& attempt() const { return *attempt_; }

 private:
  const Drill drill_;
  State start_, now_;
  std::optional<Attempt> attempt_;
};

TEST(Attempt, EndsWithSuccessFailureOrItsTime) {
  EXPECT_EQ(Course().event(Kind::goal, Side::home), Outcome::success);
  EXPECT_EQ(Course().event(Kind::goal, Side::away), Outcome::failure);
  EXPECT_EQ(Course().event(Kind::out, Side::home), Outcome::failure);
  Course course;
  for (Tick i = 1; i < ticks(2); ++i) ASSERT_EQ(course.tick(), Outcome::running);
  EXPECT_EQ(course.tick(), Outcome::time_over);
}

TEST(Attempt, SuccessCountsBeforeFailureInTheSameTick) {
  EXPECT_EQ(Course().tick([](State&, referee::Events& events) {
    events.add({.kind = Kind::out, .side = Side::home, .at = {}});
    events.add({.kind = Kind::goal, .side = Side::home, .at = {}});
  }),
            Outcome::success);
}

TEST(Attempt, AGameThatEndsWithoutSuccessIsAFailure) {
  EXPECT_EQ(Course().tick([](State& state, referee::Events&) { state.book.phase = agent::Game::Phase::finished; }),
            Outcome::failure);
}

TEST(Attempt, TheDrillSaysWhetherTheTimeIsASuccess) {
  const std::string text = kShots;
  EXPECT_FALSE(Course().attempt().succeeded(Outcome::time_over));
  const Course holds(text.substr(0, text.size() - 1) + R"(, "time_over": "success"})");
  EXPECT_TRUE(holds.attempt().succeeded(Outcome::time_over));
  EXPECT_TRUE(holds.attempt().succeeded(Outcome::success));
  EXPECT_FALSE(holds.attempt().succeeded(Outcome::failure));
}

TEST(Attempt, AFactGivesPointsEachTimeItComesTrue) {
  Course course;
  course.ball_to(1.5f);
  EXPECT_EQ(course.attempt().points(), 0.5f + 0.125f * 1.5f);
  course.ball_to(1.5f);
  EXPECT_EQ(course.attempt().points(), 0);
  course.ball_to(0.5f);
  EXPECT_EQ(course.attempt().points(), -0.125f);
  course.ball_to(1.5f);
  EXPECT_EQ(course.attempt().points(), 0.5f + 0.125f);
}

TEST(Attempt, TheScoreIsTheSumOfAllPointsAndSuccessGivesOne) {
  Course course;
  course.ball_to(2);
  course.event(Kind::goal, Side::home);
  EXPECT_EQ(course.attempt().points(), 1);
  EXPECT_EQ(course.attempt().score(), 0.5f + 0.25f + 1);
}

TEST(Attempt, ProgressEndsBeforeTheLastTick) {
  Course course;
  course.ball_to(2);
  course.tick([](State& state, referee::Events& events) {
    state.world.ball.position.x = 0;  // the referee puts the ball to the middle
    events.add({.kind = Kind::goal, .side = Side::home, .at = {}});
  });
  EXPECT_EQ(course.attempt().points(), 1);
}

}  // namespace
}  // namespace sim::drills
