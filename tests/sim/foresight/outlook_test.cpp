#include "sim/foresight/outlook.h"

#include <gtest/gtest.h>

#include "sim/io/outlook.h"
#include "sim/match/situation.h"
#include "tests/sim/support/games.h"

namespace sim::foresight {
namespace {

TEST(Outlook, ZonesCountFromTheOwnGoal) {
  const io::PreparedGame setup = test::setup_of(test::choice_of("spl2012", "baseline", "match"));
  State state = random_situation(setup.params, {.seed = 1});
  const field::Field& field = setup.params.rules.field;
  state.book.last_touch = Side::home;
  for (const auto& [x, zone] : {std::pair{-2.9f, 0}, {-0.1f, 3}, {0.1f, 4}, {2.9f, 7}, {9.f, 7}, {-9.f, 0}}) {
    state.world.ball.position = {x, 0};
    EXPECT_EQ(place_of(field, state, Side::home).zone, zone) << x;
    EXPECT_EQ(place_of(field, state, Side::away).zone, 7 - zone) << x;
  }
  EXPECT_EQ(place_of(field, state, Side::home).touch, 0);
  EXPECT_EQ(place_of(field, state, Side::away).touch, 1);
  state.world.home_attacks = -1;
  state.world.ball.position = {2.9f, 0};
  EXPECT_EQ(place_of(field, state, Side::home).zone, 0);
}

TEST(Outlook, AnAdvantageIsTheOtherSidesDisadvantage) {
  for (const char* rules : {"spl2012", "spl2025"}) {
    const auto outlook = io::load_outlook(rules);
    ASSERT_TRUE(outlook) << outlook.error();
    const io::PreparedGame setup = test::setup_of(test::choice_of(rules, "baseline", "match"));
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      State state = random_situation(setup.params, {.seed = seed});
      state.book.last_touch = seed % 2 == 0 ? Side::home : Side::away;
      EXPECT_NEAR(worth(*outlook, setup.params, state, Side::home), -worth(*outlook, setup.params, state, Side::away),
                  1e-6);
    }
  }
}

TEST(Outlook, TheOpponentsGoalIsABetterPlaceThanTheOwn) {
  for (const char* rules : {"spl2012", "spl2025"}) {
    const auto outlook = io::load_outlook(rules);
    ASSERT_TRUE(outlook);
    EXPECT_GT(outlook->worth[7][0], 0.05f);
    EXPECT_LT(outlook->worth[0][1], -0.05f);
  }
}

TEST(Outlook, AllValuesAreZeroWhenTheHalfIsOver) {
  const auto outlook = io::load_outlook("spl2012");
  ASSERT_TRUE(outlook);
  const io::PreparedGame setup = test::setup_of(test::choice_of("spl2012", "baseline", "match"));
  State state = random_situation(setup.params, {.seed = 1});
  state.world.ball.position = {2.9f, 0};
  const float at_first = worth(*outlook, setup.params, state, Side::home);
  state.book.clock = ticks(setup.params.rules.half_duration - 30);
  EXPECT_NEAR(worth(*outlook, setup.params, state, Side::home), at_first / 2, 1e-3);
  state.book.clock = ticks(setup.params.rules.half_duration);
  EXPECT_EQ(worth(*outlook, setup.params, state, Side::home), 0);
}

TEST(Outlook, RulesFromAFileHaveNoOutlook) {
  const auto outlook = io::load_outlook("./mine.json");
  ASSERT_TRUE(outlook);
  for (const auto& pair : outlook->worth) EXPECT_EQ(pair[0], 0);
}

TEST(Outlook, IsReadBackAsItWasWritten) {
  const auto outlook = io::load_outlook("spl2025");
  ASSERT_TRUE(outlook);
  const auto back = io::parse_outlook(io::print_outlook(*outlook, "x", "y"), "outlook 'x'");
  ASSERT_TRUE(back) << back.error();
  for (int zone = 0; zone < Outlook::kZones; ++zone)
    for (const int touch : {0, 1}) EXPECT_EQ(back->worth[zone][touch], outlook->worth[zone][touch]);
}

TEST(Outlook, NamesTheError) {
  const auto wrong = [](const char* text) {
    const auto parsed = io::parse_outlook(text, "outlook 'x'");
    return parsed ? "" : parsed.error();
  };
  EXPECT_EQ(wrong(R"({"reach": 60, "worth": [[0, 0]]})"),
            "outlook 'x': worth must be a list of 8 pairs of numbers -1 .. 1 [goals], got [[0,0]]");
  EXPECT_NE(wrong(R"({"reach": 0, "worth": []})"), "");
  EXPECT_NE(wrong(R"({"reach": 60})"), "");
  EXPECT_NE(wrong("[]"), "");
}

}  // namespace
}  // namespace sim::foresight
