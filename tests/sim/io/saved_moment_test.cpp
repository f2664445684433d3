#include "sim/io/saved_moment.h"

#include <gtest/gtest.h>

#include "sim/io/matchup.h"
#include "sim/io/situation.h"
#include "sim/match/step.h"

namespace sim::io {
namespace {

const Params& params() {
  static const PreparedGame made = prepare({}).value();
  return made.params;
}

/// Plays a game for `seconds` and returns its states.
std::vector<State> game_of(std::uint64_t seed, float seconds) {
  referee::Events events;
  std::vector<State> states = {begin(params(), {.seed = seed}, events)};
  while (states.back().world.tick < ticks(seconds)) {
    State next = states.back();
    step(params(), next, events);
    states.push_back(next);
  }
  return states;
}

std::string saved(const std::string& when, const std::vector<State>& states, const std::string& about = {}) {
  auto moment = SavedMoment::parse(when);
  EXPECT_TRUE(moment) << moment.error();
  for (const State& state : states) moment->see(state, about);
  return moment->text();
}

std::string error_of_moment(const std::string& when) {
  const auto moment = SavedMoment::parse(when);
  return moment ? "" : moment.error();
}

TEST(SavedMoment, LoadsWithThePositionsOfTheGameAtThatMoment) {
  const std::vector<State> states = game_of(7, 90);
  for (const char* when : {"0", "31.5", "60", "90"}) {
    const State& now = states[ticks(std::stof(when))];
    const auto loaded = parse_situation(saved(when, states), "situation", params());
    ASSERT_TRUE(loaded) << loaded.error();
    EXPECT_EQ(loaded->world.ball.position, now.world.ball.position) << when;
    EXPECT_EQ(loaded->world.ball.velocity, now.world.ball.velocity) << when;
    for_each_robot(now.world.players, [&](int robot) {
      EXPECT_EQ(loaded->world.bodies[robot].position, now.world.bodies[robot].position) << when << " " << robot;
      EXPECT_EQ(loaded->world.bodies[robot].heading, now.world.bodies[robot].heading) << when << " " << robot;
    });
    EXPECT_EQ(loaded->book.half, now.book.half);
    EXPECT_EQ(loaded->book.clock, now.book.clock);
    EXPECT_EQ(loaded->book.phase, now.book.phase);
    EXPECT_EQ(loaded->book.score[0], now.book.score[0]);
    EXPECT_EQ(loaded->book.score[1], now.book.score[1]);
  }
}

TEST(SavedMoment, TheSameGameGivesTheSameBytes) {
  EXPECT_EQ(saved("60", game_of(7, 61), "a game"), saved("60", game_of(7, 61), "a game"));
  EXPECT_NE(saved("60", game_of(7, 61)), saved("60", game_of(8, 61)));
}

TEST(SavedMoment, TellsFromWhichGameItComes) {
  const std::string text = saved("1", game_of(7, 2), "baseline, seed 7");
  EXPECT_NE(text.find(R"("about": "baseline, seed 7")"), text.npos) << text;
  EXPECT_TRUE(parse_situation(text, "situation", params()));
}

TEST(SavedMoment, ATimeOnTheClockIsTheFirstTickWithThatTime) {
  const std::vector<State> states = game_of(7, 120);
  const std::string text = saved("1:00:20", states);
  ASSERT_NE(text, "");
  // the clock stands still before the kick-off
  for (const State& state : states)
    if (state.book.clock >= ticks(20)) {
      EXPECT_EQ(text, save_situation(state));
      EXPECT_GT(state.world.tick, state.book.clock);
      break;
    }
}

TEST(SavedMoment, IsEmptyBeforeTheMoment) {
  EXPECT_EQ(saved("60", game_of(7, 59)), "");
  EXPECT_EQ(saved("2:00:00", game_of(7, 59)), "");
}

TEST(SavedMoment, NamesTheError) {
  const std::string expected =
      "a moment must be 0 .. 36000 [s] since the first tick, or half:minutes:seconds on the clock such as 2:05:12, "
      "got ";
  for (const char* wrong : {"", "soon", "-1", "36001", "nan", "1e9", "5 s", "0:00:10", "5:00:10", "1:00", "1:00:60",
                            "1:-1:00", "1:00:-5", "1:00:10x", "1:00:10:5", ":::"})
    EXPECT_EQ(error_of_moment(wrong), expected + "'" + wrong + "'");
  for (const char* right : {"0", "312", "31.5", "1:00:00", "2:9:59.5", "36000"}) EXPECT_EQ(error_of_moment(right), "");
}

}  // namespace
}  // namespace sim::io
